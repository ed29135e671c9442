// bake_navmesh LEVEL... - writes the navmesh of each level beside it (foyer.glb: foyer.navmesh), so that every
// machine plays with the same one. Run it whenever a level's geometry has changed. Exit: 0, or 2 with a sentence.
#include "load/navmesh.h"

#include <cstdio>
#include <string_view>

using namespace std::string_view_literals;

int main(int count, char** arguments) {
    const bool asks_for_help = count == 2 && (arguments[1] == "--help"sv || arguments[1] == "-h"sv);
    if (count < 2 || asks_for_help) {
        std::fputs("usage: bake_navmesh LEVEL.glb...\nWrites the navmesh of each level beside it.\n",
                   asks_for_help ? stdout : stderr);
        return asks_for_help ? 0 : 2;
    }
    for (int i = 1; i < count; ++i) {
        const gh::Result<void> baked = gh::load::bake_navmesh_file(arguments[i]);
        if (!baked) {
            std::fprintf(stderr, "%s\n", baked.error().sentence.c_str());
            return 2;
        }
    }
    return 0;
}
