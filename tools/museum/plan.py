"""The floor plan: rooms and the openings between them as boxes of air, and the shell built from their union.

The shell is the skin of the air: one closed mesh whose normals point into the rooms, every edge shared by exactly two
faces that run along it in opposite directions. It is found on a grid made of every plan line, so no corner of one
face ever lies on the middle of another's edge. North is +y, east is +x, metres."""
import bmesh
import bpy

import meshkit

LOW, HIGH = 0.0, 0.8   # the floors of the entrance and of the Hall of Mirrors

# name: (x0, y0, z0, x1, y1, z1, floor, wall, ceiling, title)
ROOMS = {
    "cloakroom": (-14.0, -11.0, LOW, -8.4, -6.9, 3.2, "floor_boards", "wall_paper", "ceiling", "Cloakroom"),
    "vestibule": (-3.0, -15.4, LOW, 3.0, -11.4, 3.9, "floor_foyer", "wall_foyer", "ceiling", "Vestibule"),
    "foyer": (-8.0, -11.0, LOW, 8.0, 3.0, 6.6, "floor_foyer", "wall_foyer", "ceiling", "Foyer"),
    "lodge": (8.4, -11.0, LOW, 14.0, -6.9, 3.2, "floor_boards", "wall_paper", "ceiling", "Porter's Lodge"),
    "west_gallery": (-13.0, -6.5, LOW, -8.4, 10.6, 4.6, "floor_gallery", "wall_red", "ceiling", "Gallery of Painters"),
    "west_gallery_north": (-13.0, 10.6, HIGH, -8.4, 18.2, 4.6, "floor_gallery", "wall_red", "ceiling", ""),
    "east_gallery": (8.4, -6.5, LOW, 13.0, 10.6, 4.6, "floor_gallery", "wall_green", "ceiling", "Sculpture Gallery"),
    "east_gallery_north": (8.4, 10.6, HIGH, 13.0, 18.2, 4.6, "floor_gallery", "wall_green", "ceiling", ""),
    "stair": (-2.6, 3.4, LOW, 2.6, 8.0, 5.4, "floor_foyer", "wall_foyer", "ceiling", "Grand Stair"),
    "store": (3.0, 3.8, LOW, 8.0, 8.0, 2.8, "floor_service", "wall_service", "ceiling", "Lamp Store"),
    "flue": (-8.4, 5.0, LOW, -2.6, 6.2, 1.2, "floor_service", "wall_service", "wall_service", "Flue"),
    "hall": (-8.0, 8.4, HIGH, 8.0, 18.2, 6.2, "floor_hall", "wall_blue", "ceiling", "Hall of Mirrors"),
    "cabinet": (-3.6, 18.6, HIGH, 3.6, 25.0, 5.2, "floor_cabinet", "wall_violet", "ceiling", "Lens Cabinet"),
    "library": (-13.0, 18.6, HIGH, -4.0, 25.0, 4.6, "floor_cabinet", "wall_cream", "ceiling", "Reading Room"),
    "workshop": (4.0, 18.6, HIGH, 13.0, 25.0, 4.6, "floor_boards", "wall_cream", "ceiling", "Optician's Workshop"),
}

# name: (x0, y0, z0, x1, y1, z1), each bridging one 0.4 m wall; the plan's doors are hung in doors.py
OPENINGS = {
    "vestibule_foyer": (-1.1, -11.4, LOW, 1.1, -11.0, 2.6),
    "cloakroom_foyer": (-8.4, -9.4, LOW, -8.0, -8.2, 2.3),
    "lodge_foyer": (8.0, -9.4, LOW, 8.4, -8.2, 2.3),
    "cloakroom_west": (-11.8, -6.9, LOW, -10.6, -6.5, 2.3),
    "lodge_east": (10.6, -6.9, LOW, 11.8, -6.5, 2.3),
    "foyer_west": (-8.4, -2.6, LOW, -8.0, -0.4, 3.2),
    "foyer_east": (8.0, -2.6, LOW, 8.4, -0.4, 3.2),
    "foyer_stair": (-1.5, 3.0, LOW, 1.5, 3.4, 3.8),
    "stair_hall": (-1.3, 8.0, HIGH, 1.3, 8.4, 3.8),
    "stair_store": (2.6, 5.0, LOW, 3.0, 6.2, 1.2),
    "store_east": (8.0, 4.4, LOW, 8.4, 5.6, 2.2),
    "hall_west": (-8.4, 14.2, HIGH, -8.0, 16.2, 3.6),
    "hall_east": (8.0, 11.6, HIGH, 8.4, 13.6, 3.3),
    "hall_cabinet": (-1.0, 18.2, HIGH, 1.0, 18.6, 3.3),
    "cabinet_library": (-4.0, 21.2, HIGH, -3.6, 22.4, 3.1),
    "cabinet_workshop": (3.6, 21.2, HIGH, 4.0, 22.4, 3.1),
    "library_west": (-11.5, 18.2, HIGH, -9.7, 18.6, 3.4),
    "workshop_east": (10.0, 18.2, HIGH, 11.2, 18.6, 3.1),
}

# skylights: the hole through the ceiling, and the closed piece of night above it that holds its moon
SKYLIGHTS = {
    "foyer": (-2.5, -6.5, 6.6, 2.5, -1.5, 7.2),
    "west_south": (-11.7, -4.6, 4.6, -9.7, -1.6, 5.0),
    "west_mid": (-11.7, 3.2, 4.6, -9.7, 6.2, 5.0),
    "west_north": (-11.7, 12.6, 4.6, -9.7, 15.6, 5.0),
    "east_south": (9.7, -4.6, 4.6, 11.7, -1.6, 5.0),
    "east_mid": (9.7, 3.2, 4.6, 11.7, 6.2, 5.0),
    "east_north": (9.7, 12.6, 4.6, 11.7, 15.6, 5.0),
    "hall": (-2.5, 11.2, 6.2, 2.5, 15.2, 6.8),
    "cabinet": (-1.2, 20.6, 5.2, 1.2, 23.0, 5.7),
}
NIGHTS = {
    "night_foyer": (-6.0, -10.0, 7.2, 6.0, 2.0, 14.0),
    "night_west": (-14.5, -6.0, 5.0, -8.4, 18.0, 11.0),
    "night_east": (8.4, -6.0, 5.0, 14.5, 18.0, 11.0),
    "night_hall": (-6.0, 9.0, 6.8, 6.0, 17.8, 13.0),
    "night_cabinet": (-4.0, 19.0, 5.7, 4.0, 25.0, 11.0),
}


def air():
    """Every box of air with the materials of its floor, walls and ceiling; where boxes overlap the first wins."""
    boxes = [(room[:6], room[6:9]) for room in ROOMS.values()]
    for name, box in OPENINGS.items():
        first = name.split("_")[0]
        floor = next((r[6] for n, r in ROOMS.items() if n.split("_")[0] == first), "floor_service")
        boxes.append((box, (floor, "stucco", "stucco")))
    boxes += [(box, ("stucco", "stucco", "stucco")) for box in SKYLIGHTS.values()]
    boxes += [(box, ("night", "night", "night")) for box in NIGHTS.values()]
    return boxes


def _skin(boxes):
    """Quads between air and no air on the grid of all plan lines."""
    lines = [sorted({round(b[a], 4) for b, _ in boxes} | {round(b[a + 3], 4) for b, _ in boxes}) for a in range(3)]
    place = [{v: i for i, v in enumerate(line)} for line in lines]
    cell = {}
    for box, materials in boxes:
        low = [place[a][round(box[a], 4)] for a in range(3)]
        high = [place[a][round(box[a + 3], 4)] for a in range(3)]
        for i in range(low[0], high[0]):
            for j in range(low[1], high[1]):
                for k in range(low[2], high[2]):
                    cell.setdefault((i, j, k), materials)
    shape, index = meshkit.Shape(), {}

    def corner(ijk):
        if ijk not in index:
            index[ijk] = len(shape.points)
            shape.points.append(tuple(lines[a][ijk[a]] for a in range(3)))
        return index[ijk]

    for c in sorted(cell):
        for axis in range(3):
            for side in (0, 1):
                beyond = list(c)
                beyond[axis] += 1 if side else -1
                if tuple(beyond) in cell:
                    continue
                ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
                if side:  # the face looks back into the cell
                    ring = ring[::-1]
                quad = []
                for u, v in ring:
                    p = list(c)
                    p[axis] += side
                    p[(axis + 1) % 3] += u
                    p[(axis + 2) % 3] += v
                    quad.append(corner(tuple(p)))
                floor, wall, ceiling = cell[c]
                shape.face(quad, wall if axis < 2 else ceiling if side else floor)
    return shape


def shell_mesh():
    """The shell with coplanar faces of one material merged, which keeps it closed, and then triangulated."""
    skin = _skin(air())
    mesh = meshkit.to_mesh(skin, "shell", smooth_deg=1.0)
    kit = bmesh.new()
    kit.from_mesh(mesh)
    bmesh.ops.dissolve_limit(kit, angle_limit=0.001, verts=kit.verts, edges=kit.edges, delimit={"MATERIAL"})
    bmesh.ops.triangulate(kit, faces=kit.faces, quad_method="BEAUTY", ngon_method="BEAUTY")
    kit.to_mesh(mesh)
    kit.free()
    _map_from_world(mesh)
    faults = open_edges(mesh)
    assert not faults, f"the shell has {len(faults)} edges that two faces do not share in opposite directions: {faults[:4]}"
    return mesh


def _map_from_world(mesh):
    layer = mesh.uv_layers.active.data
    for polygon in mesh.polygons:
        name = mesh.materials[polygon.material_index].name
        points = [tuple(mesh.vertices[i].co) for i in polygon.vertices]
        for loop, uv in zip(polygon.loop_indices, meshkit._box_uv(points, polygon.normal, name)):
            layer[loop].uv = uv


def open_edges(mesh):
    """The edges (as pairs of points) not shared by exactly two faces in opposite directions; none, for a closed mesh."""
    seen = {}
    for polygon in mesh.polygons:
        corners = list(polygon.vertices)
        for a, b in zip(corners, corners[1:] + corners[:1]):
            seen[a, b] = seen.get((a, b), 0) + 1
    where = [tuple(round(c, 3) for c in v.co) for v in mesh.vertices]
    return [(where[a], where[b]) for a, b in sorted(seen) if seen[a, b] != 1 or seen.get((b, a), 0) != 1]


def _minus(span, holes):
    pieces = [span]
    for h0, h1 in holes:
        pieces = [p for a, b in pieces for p in ((a, min(b, h0)), (max(a, h1), b)) if p[1] - p[0] > 0.02]
    return pieces


def wall_runs(name, z, clearance=0.0):
    """Plan paths along a room's walls, the room on their left, broken where an opening is at height z: what a
    skirting or a cornice follows. A whole unbroken perimeter comes back closed, as (path, True)."""
    x0, y0, _, x1, y1, _ = ROOMS[name][:6]
    neighbours = list(OPENINGS.values()) + [r[:6] for n, r in ROOMS.items() if n != name]
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    runs = []
    for i in range(4):
        (ax, ay), (bx, by) = corners[i], corners[(i + 1) % 4]
        along = 0 if ay == by else 1
        wall = ay if along == 0 else ax
        holes = []
        for o in neighbours:
            touches = o[1 - along] - 1e-6 <= wall <= o[4 - along] + 1e-6
            if touches and o[2] - 1e-6 <= z < o[5] - 1e-6 and o[3 + along] > min(ax, bx, ay, by) - 99:
                holes.append((o[along] - clearance, o[3 + along] + clearance))
        low, high = (ax, bx) if along == 0 else (ay, by)
        forward = low < high
        pieces = _minus((min(low, high), max(low, high)), holes)
        for a, b in pieces if forward else [(b, a) for a, b in reversed(pieces)]:
            start, end = ((a, ay), (b, by)) if along == 0 else ((ax, a), (bx, b))
            if runs and runs[-1][-1] == start:
                runs[-1].append(end)
            else:
                runs.append([start, end])
    if len(runs) > 1 and runs[-1][-1] == runs[0][0]:
        runs[0] = runs.pop() + runs[0][1:]
    if len(runs) == 1 and runs[0][0] == runs[0][-1]:
        return [(runs[0][:-1], True)]
    return [(run, False) for run in runs]
