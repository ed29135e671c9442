// bake_navmesh LEVEL... - writes the navmesh of each level beside it (foyer.glb: foyer.navmesh), so that every
// machine plays with the same one. Run it whenever a level's geometry has changed. Exit: 0, or 2 with a sentence.
#include "load/navmesh.h"

#include <cstdio>

int main(int count, char** arguments) {
    if (count < 2) {
        std::fputs("usage: bake_navmesh LEVEL...\n", stderr);
        return 2;
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
