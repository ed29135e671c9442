#!/usr/bin/env python3
"""Draws what `raycore_bench --json FILE` measured: rays a second on one thread, as multiples of Embree's fast scenes.

    raycore_bench --json bench.json; tools/bench/plot.py bench.json [more.json ...] -o assets/pictures/raycore.svg
"""
import argparse
import json
import math
import re
import sys

QUERIES = ["primary", "shadow", "ao", "diffuse"]
CONTESTANTS = [  # row of the table, what it is called here, colour, shape
    ("raycore high, batches of 64", "raycore, batches of 64", "#c0392b", "square"),
    ("raycore high, single", "raycore, one ray at a time", "#c0392b", "disc"),
    ("embree high, packets of 16", "Embree, packets of 16", "#7f8c8d", "square"),
    ("embree high, robust", "Embree robust, one at a time", "#7f8c8d", "disc"),
]
FACET, HEIGHT, LEFT, TOP = 164, 250, 46, 34
LEAST, MOST = 0.35, 8.0  # of the axis


def height_of(ratio):
    """Where a ratio lies on the logarithmic axis, in pixels from the top."""
    share = math.log(ratio / LEAST) / math.log(MOST / LEAST)
    return TOP + HEIGHT * (1 - min(max(share, 0), 1))


def mark(x, y, colour, shape, hint):
    body = (f"<circle cx='{x:.1f}' cy='{y:.1f}' r='4.5'" if shape == "disc"
            else f"<rect x='{x - 4:.1f}' y='{y - 4:.1f}' width='8' height='8'")
    return f"{body} fill='{colour}'><title>{hint}</title></{'circle' if shape == 'disc' else 'rect'}>"


def races(paths):
    """(scene, triangles, rows by name) of every race on one thread in the files."""
    for path in paths:
        with open(path, encoding="utf-8") as file:
            tables = json.load(file)["tables"]
        for table in tables:
            title = re.fullmatch(r"(\S+), (\d+) triangles, 1 thread\(s\): Mrays/s .*", table["title"])
            if title:
                scene = title[1].rsplit("/", 1)[-1].removesuffix(".glb")
                yield scene, int(title[2]), {row["name"]: row for row in table["rows"]}


def facet(index, scene, triangles, rows):
    left = LEFT + index * FACET
    lines = [f"<rect x='{left}' y='{TOP}' width='{FACET - 10}' height='{HEIGHT}' fill='#fafafa'/>",
             f"<text x='{left + (FACET - 10) / 2}' y='{TOP - 16}' text-anchor='middle' font-weight='bold'>{scene}</text>",
             f"<text x='{left + (FACET - 10) / 2}' y='{TOP - 4}' text-anchor='middle' fill='#777'>{triangles:,} triangles</text>"]
    for tick in (0.5, 1, 2, 4, 8):
        y = height_of(tick)
        colour = "#333" if tick == 1 else "#ddd"
        lines.append(f"<line x1='{left}' x2='{left + FACET - 10}' y1='{y:.1f}' y2='{y:.1f}' stroke='{colour}'/>")
    for column, query in enumerate(QUERIES):
        x = left + 20 + column * 38
        lines.append(f"<text x='{x}' y='{TOP + HEIGHT + 14}' text-anchor='middle'>{query}</text>")
        for name, called, colour, shape in CONTESTANTS:
            ratio = rows[name][query]["ratio"]
            lines.append(mark(x, height_of(ratio), colour, shape, f"{called}: {ratio:.2f}"))
    return lines


def draw(found):
    width = LEFT + FACET * len(found)
    lines = [f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {TOP + HEIGHT + 48}' width='{width}' "
             f"height='{TOP + HEIGHT + 48}' font-family='sans-serif' font-size='10'>"
             "<rect width='100%' height='100%' fill='#fff'/>"]
    for tick in (0.5, 1, 2, 4, 8):
        lines.append(f"<text x='{LEFT - 5}' y='{height_of(tick) + 3:.1f}' text-anchor='end'>{tick:g} x</text>")
    for index, race in enumerate(found):
        lines += facet(index, *race)
    for index, (_, called, colour, shape) in enumerate(CONTESTANTS):
        x, y = LEFT + 6 + index * 162, TOP + HEIGHT + 34
        lines += [mark(x, y - 3, colour, shape, called), f"<text x='{x + 9}' y='{y}'>{called}</text>"]
    lines.append(f"<text x='{LEFT + 6}' y='{TOP + HEIGHT - 6}' fill='#777'>1 x: Embree fast, one ray at a time</text>")
    return "\n".join(lines + ["</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("json", nargs="+", help="what raycore_bench --json wrote")
    parser.add_argument("-o", "--output", required=True, help="the picture (SVG)")
    options = parser.parse_args()
    found = list(races(options.json))
    if not found:
        sys.exit(f"{options.json[0]}: no race on one thread in it (was raycore_bench run with --no-queries?)")
    with open(options.output, "w", encoding="utf-8") as file:
        file.write(draw(found))


if __name__ == "__main__":
    main()
