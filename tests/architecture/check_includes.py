"""Who may include whom: the table of the design, held against every source file.

Usage: check_includes.py ROOT | --self-test.  Exit 1 with a line per offence.
"""
import re
import sys
from pathlib import Path

# Rooms a room may include, itself always; (room, file) pairs allow one header of a room.
ROOMS = {
    "base": set(),
    "input": {"base"},
    "world": {"base", "raycore"},
    "load": {"base", "world", "raycore"},
    "spatial": {"base", "world", "raycore"},
    "sense": {"base", "world", "raycore"},
    "sim": {"base", "world", "raycore", "load", "spatial", "sense"},
    "render": {"base", "world", "raycore"},
    "filter": {"base"},
    "audio": {"base", "world", "raycore"},
    "present": {"base"},
    "record": {"base"},
    "app": {"base", "input", "world", "load", "spatial", "sense", "sim", "render", "filter", "audio", "present",
            "record", "raycore"},
}
SINGLE_HEADERS = {
    "sim": {"input/command.h"},
    "audio": {"sense/hearing.h", "sense/sound_types.h", "sense/types.h"},
    "world": set(),
}
# Third-party headers stay in the room that wraps them.
LIBRARIES = {
    r"tiny_gltf|stb_image": {"load", "record"},
    r"OpenImageIO/": {"load", "record"},
    r"GLFW/": {"present", "input"},
    r"imgui|GL/": {"present"},
    r"AL/": {"audio"},
    r"sndfile": {"audio", "record"},
    r"recastnavigation/Recast": {"load"},
    r"recastnavigation/Detour": {"load", "sim"},
    r"CLI/|nlohmann/": {"app"},
    r"hwy/": {"raycore", "render", "filter"},
    r"immintrin|xmmintrin|emmintrin": {"raycore"},
    r"xxhash": {"base"},
    r"zstd": {"input"},
    r"embree": set(),
}
KERNEL_HEADERS = {"immintrin.h", "cstdint"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def includes_of(text):
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1), match.group(2)


def offences_in_room(room, text, rooms=ROOMS):
    for number, quote, header in includes_of(text):
        first = header.split("/")[0]
        if first in rooms or first == "raycore":
            allowed = first == room or first in rooms.get(room, set()) or header in SINGLE_HEADERS.get(room, set())
            if not allowed:
                yield number, f"{room} may not include {header}"
        yield from library_offences(room, number, header)


def library_offences(room, number, header):
    for pattern, owners in LIBRARIES.items():
        if re.match(pattern, header) and room not in owners:
            yield number, f"{room} may not include {header}: it stays in {', '.join(sorted(owners)) or 'the benchmark'}"


RAYCORE_PARALLEL = "parallel.h"


def offences_in_raycore(path, text):
    for number, quote, header in includes_of(text):
        if header.split("/")[0] in ROOMS:
            yield number, f"raycore knows no game: {header}"
        if header.startswith("tbb/") and path.name != RAYCORE_PARALLEL:
            yield number, f"oneTBB stays inside raycore/src/parallel.h: {header}"
        if "include/raycore" in path.as_posix() and quote == "<" and "/" in header and not header.startswith("glm/"):
            yield number, f"public headers show GLM and the standard library only: {header}"
        if "src/kernels" in path.as_posix() and not header.startswith("kernels/") and header not in KERNEL_HEADERS:
            yield number, f"kernel files include kernel_abi.h and their SIMD header, nothing else: {header}"
        yield from library_offences("raycore", number, header)


def check(root):
    offences = []
    seen = 0
    for path in sorted([*root.glob("game/**/*"), *root.glob("raycore/**/*")]):
        if path.suffix not in {".h", ".cpp", ".inl"} or "example" in path.parts:
            continue
        text = path.read_text(encoding="utf-8", errors="replace")
        seen += 1
        parts = path.relative_to(root).parts
        found = offences_in_raycore(path, text) if parts[0] == "raycore" else offences_in_room(parts[1], text)
        offences += [f"{path.relative_to(root)}:{number}: {what}" for number, what in found]
    if seen < 20:
        offences.append(f"{root}: only {seen} files found; the check would pass without looking")
    return offences


def self_test():
    """The check must go red for each kind of offence."""
    assert list(offences_in_room("sense", '#include "sim/tick.h"'))
    assert list(offences_in_room("filter", '#include "world/level.h"'))
    assert list(offences_in_room("sim", '#include <GLFW/glfw3.h>'))
    assert list(offences_in_room("base", '  #  include "raycore/query.h"'))
    assert not list(offences_in_room("sim", '#include "input/command.h"\n#include "raycore/query.h"\n#include <vector>'))
    assert list(offences_in_room("sim", '#include "input/replay.h"'))
    assert list(offences_in_raycore(Path("raycore/src/query.cpp"), '#include "world/level.h"'))
    assert list(offences_in_raycore(Path("raycore/src/query.cpp"), '#include <tbb/parallel_for.h>'))
    assert not list(offences_in_raycore(Path("raycore/src/parallel.h"), '#include <tbb/parallel_for.h>'))
    assert list(offences_in_raycore(Path("raycore/src/kernels/avx2.cpp"), '#include <vector>'))
    assert list(offences_in_raycore(Path("raycore/include/raycore/ray.h"), '#include <tbb/task.h>'))
    assert not list(offences_in_raycore(Path("raycore/src/kernels/avx2.cpp"), '#include <immintrin.h>'))


def main():
    if sys.argv[1] == "--self-test":
        self_test()
        return 0
    offences = check(Path(sys.argv[1]))
    print("\n".join(offences))
    return 1 if offences else 0


sys.exit(main())
