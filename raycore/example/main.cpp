// A lamp over a table, and how much of the table it reaches: the whole of raycore in forty lines.
#include <raycore/query.h>

#include <array>
#include <cstdio>

int main() {
    // A tabletop of two triangles, and a plate hanging over it: the same mesh, placed twice.
    const std::array<glm::vec3, 4> corners{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}};
    const std::array<glm::uvec3, 2> triangles{{{0, 2, 1}, {0, 3, 2}}};
    const auto square = rc::build_blas({corners, triangles});

    glm::mat4x3 table(1.0f), plate(0.25f);
    plate[3] = {0.0f, 1.0f, 0.0f};
    rc::SceneBuilder builder;
    const auto table_id = builder.add({square, table});
    builder.add({square, plate});
    const auto scene = builder.commit();  // frozen: any number of threads may ask it from here on

    const glm::vec3 lamp(0.0f, 2.0f, 0.0f), eye(3.0f, 2.5f, 3.0f);
    int lit = 0, seen = 0;
    for (int row = 0; row < 20; ++row) {
        for (int column = 0; column < 40; ++column) {
            const glm::vec3 to(float(column) / 20.0f - 0.975f, 0.0f, float(row) / 10.0f - 0.95f);
            const rc::Ray ray{.origin = eye, .direction = to - eye};
            const auto hit = rc::closest_hit(*scene, ray, rc::kAllLayers);
            if (!hit || hit->instance != table_id) {
                std::putchar(' ');
                continue;
            }
            ++seen;
            const rc::Ray to_lamp = rc::spawn_ray_to(scene->surface(*hit), lamp);
            const bool dark = rc::any_hit(*scene, to_lamp, rc::kAllLayers);
            std::putchar(dark ? '.' : '#');
            lit += !dark;
        }
        std::putchar('\n');
    }
    std::printf("lit %d of %d\n", lit, seen);
}
