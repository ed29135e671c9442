"""Puts shapes into Blender's scene as the nodes assets/README.md describes: meshes, empties, lamps and cameras with
their `kind` and other properties. Every name is given by the caller, so that nodes can be referred to."""
import math

import bpy

import meshkit


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def _place(node, at, turn_deg, parent, properties):
    assert "." not in node.name, f"two nodes are called {node.name.rsplit('.', 1)[0]}"
    bpy.context.scene.collection.objects.link(node)
    node.location = at
    node.rotation_mode = "XYZ"
    node.rotation_euler = (0.0, 0.0, math.radians(turn_deg))
    if parent is not None:
        node.parent = parent
    for key, value in properties.items():
        node[key] = value
    return node


def mesh(name, body, at=(0, 0, 0), turn_deg=0.0, parent=None, smooth_deg=35.0, **properties):
    """A mesh node; `body` may be a Blender mesh made before, which several nodes then share."""
    if isinstance(body, meshkit.Shape):
        body = meshkit.to_mesh(body, name, smooth_deg)
    return _place(bpy.data.objects.new(name, body), at, turn_deg, parent, properties)


def empty(name, at, turn_deg=0.0, **properties):
    """An empty; its direction is its own +y, that is north for a turn of 0, counter-clockwise seen from above."""
    return _place(bpy.data.objects.new(name, None), at, turn_deg, None, properties)


def spot(name, at, target, watts_per_sr, colour, cone_deg, blend=0.15, **properties):
    light = bpy.data.lights.new(name, "SPOT")
    light.energy = watts_per_sr * 4.0 * math.pi
    light.color = colour
    light.spot_size = math.radians(cone_deg)
    light.spot_blend = blend
    light.shadow_soft_size = 0.0
    node = _place(bpy.data.objects.new(name, light), at, 0.0, None, properties)
    _aim(node, at, target)
    return node


def camera(name, at, target, fov_deg=70.0):
    lens = bpy.data.cameras.new(name)
    lens.sensor_fit = "HORIZONTAL"
    lens.angle = math.radians(fov_deg)
    lens.clip_start, lens.clip_end = 0.05, 200.0
    node = _place(bpy.data.objects.new(name, lens), at, 0.0, None, {})
    _aim(node, at, target)
    return node


def _aim(node, at, target):
    """Turns the node's -z to the target, its +y as far up as it goes."""
    dx, dy, dz = (t - a for t, a in zip(target, at))
    node.rotation_euler = (math.atan2(math.hypot(dx, dy), -dz), 0.0, math.atan2(-dx, dy))


def triangles():
    return sum(len(p.vertices) - 2 for o in bpy.context.scene.objects if o.type == "MESH" for p in o.data.polygons)
