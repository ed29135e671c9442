"""The museum's night watchman: an armature, one skinned mesh, five clips.

    build_guard()         adds him to the current scene (the level script calls this)
    EXPORT_OPTIONS        what bpy.ops.export_scene.gltf needs so that skin and clips arrive whole

    blender -b --factory-startup -noaudio --python tools/museum/guard.py -- tests/assets/guard.glb
                          exports him alone, the same bytes every time

He stands at the origin on z = 0, faces +y (glTF's -z) and is 1.82 m tall from boot to cap.  Clips are actions in
NLA tracks named stand, walk, look, run and reach, at 30 frames a second, which build_guard() makes the scene's.
The bone "torch" points where his torch shines, for a level that wants to hang a light on it.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bpy  # noqa: E402
import numpy as np  # noqa: E402
from mathutils import Matrix  # noqa: E402

import guard_clips  # noqa: E402
from guard_bones import REST  # noqa: E402
from guard_coat import coat, trimmings  # noqa: E402
from guard_hands import hands  # noqa: E402
from guard_head import head  # noqa: E402
from guard_legs import legs  # noqa: E402
from guard_shapes import stacked  # noqa: E402

HEIGHT = 1.82
KEPT_OF_CLOTHES, KEPT_OF_HEAD = 0.46, 0.66  # of their triangles
EXPORT_OPTIONS = dict(export_format="GLB", export_extras=True, export_yup=True, export_apply=False,
                      export_animations=True, export_nla_strips=True, export_force_sampling=True,
                      export_optimize_animation_size=True, export_skins=True, export_all_influences=False,
                      export_def_bones=False, export_lights=True, export_cameras=True)

# base colour (linear), metallic, roughness, what ears and feet meet
MATERIALS = {
    "guard_coat": ((.020, .026, .050), 0, .92, "carpet"), "guard_collar": ((.010, .013, .028), 0, .80, "carpet"),
    "guard_trousers": ((.018, .019, .026), 0, .94, "carpet"), "guard_leather": ((.016, .011, .008), 0, .38, "carpet"),
    "guard_sole": ((.010, .009, .008), 0, .75, "carpet"), "guard_glove": ((.055, .032, .018), 0, .62, "carpet"),
    "guard_skin": ((.500, .270, .180), 0, .52, "carpet"), "guard_hair": ((.055, .038, .026), 0, .78, "carpet"),
    "guard_eye": ((.720, .690, .640), 0, .18, "carpet"), "guard_iris": ((.030, .020, .012), 0, .12, "carpet"),
    "guard_brass": ((.780, .520, .180), 1, .28, "metal"), "guard_steel": ((.200, .205, .215), 1, .35, "metal"),
    "guard_cap": ((.016, .020, .040), 0, .90, "carpet"), "guard_capband": ((.010, .010, .014), 0, .80, "carpet"),
    "guard_peak": ((.008, .008, .009), 0, .16, "carpet"), "guard_shirt": ((.480, .490, .520), 0, .85, "carpet"),
    "guard_tie": ((.020, .006, .008), 0, .70, "carpet"), "guard_torch_glow": ((1.0, .86, .62), 0, .30, "glass")}
TORCH_RADIANCE = 40.0


def material(name):
    """The named material of the guard, made once a file."""
    existing = bpy.data.materials.get(name)
    if existing:
        return existing
    colour, metallic, roughness, surface = MATERIALS[name]
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.use_backface_culling = False
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Metallic"].default_value = metallic
    shader.inputs["Roughness"].default_value = roughness
    if name == "guard_torch_glow":
        shader.inputs["Emission"].default_value = (*colour, 1)
        shader.inputs["Emission Strength"].default_value = TORCH_RADIANCE
    made["surface"] = surface
    return made


def build_armature():
    data = bpy.data.armatures.new("guard")
    armature = bpy.data.objects.new("guard", data)
    armature["kind"] = "guard_model"
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    for name, (parent, start, end) in REST.items():
        bone = data.edit_bones.new(name)
        bone.head, bone.tail, bone.roll = start, end, 0.0
        if parent:
            bone.parent = data.edit_bones[parent]
    bpy.ops.object.mode_set(mode="OBJECT")
    for bone in armature.pose.bones:
        bone.rotation_mode = "QUATERNION"
    return armature


def build_body(armature):
    """One mesh of all parts, at most four bones a vertex, their shares summing to one. It is posed and refitted every
    tick, so it is thinned as far as an eye a metre off allows: the head less than the clothes."""
    cloth = coat()
    clothes, face = [cloth, *trimmings(cloth), *legs(), *hands()], head()
    top = max(part.vertices[:, 2].max() for part in face)
    if abs(top - min(part.vertices[:, 2].min() for part in clothes) - HEIGHT) > 0.001:
        raise ValueError(f"the guard is {top:.4f} m tall, not {HEIGHT}")
    body = thinned("guard_body", clothes, KEPT_OF_CLOTHES)
    for node in bpy.context.selected_objects:
        node.select_set(False)
    for node in (thinned("guard_head", face, KEPT_OF_HEAD), body):
        node.select_set(True)
    bpy.context.view_layer.objects.active = body
    bpy.ops.object.join()
    body.data.transform(Matrix.Translation((0, 0, -min(v.co.z for v in body.data.vertices))))
    body.data.polygons.foreach_set("use_smooth", [True] * len(body.data.polygons))
    body.data.use_auto_smooth = True
    body.data.auto_smooth_angle = np.radians(62)
    body.parent = armature
    modifier = body.modifiers.new("guard", "ARMATURE")
    modifier.object = armature
    return body


def thinned(name, parts, kept):
    """The parts as one object, `kept` of their triangles left where they tell most."""
    vertices, faces, names, columns = stacked(parts)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(v) for v in vertices], [], faces)
    order = sorted(set(names))
    for material_name in order:
        mesh.materials.append(material(material_name))
    mesh.polygons.foreach_set("material_index", [order.index(n) for n in names])
    mesh.validate()
    node = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(node)
    add_weights(node, columns)
    node.modifiers.new("thin", "DECIMATE").ratio = kept
    bpy.context.view_layer.objects.active = node
    bpy.ops.object.modifier_apply(modifier="thin")
    return node


def add_weights(body, columns):
    bones = sorted(columns)
    table = np.column_stack([columns[b] for b in bones])
    least_kept = np.sort(table, axis=1)[:, -min(4, len(bones))][:, None]
    table = np.where((table >= least_kept) & (table > 0.01), table, 0.0)
    table /= table.sum(axis=1, keepdims=True)
    for i, name in enumerate(bones):
        group = body.vertex_groups.new(name=name)
        for vertex in np.nonzero(table[:, i])[0]:
            group.add([int(vertex)], float(table[vertex, i]), "REPLACE")


def build_guard():
    """Adds the guard to the current scene; returns his armature object."""
    bpy.context.scene.render.fps = guard_clips.FRAMES_PER_SECOND
    armature = build_armature()
    build_body(armature)
    guard_clips.add_clips(armature)
    return armature


def main(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    build_guard()
    bpy.ops.export_scene.gltf(filepath=path, **EXPORT_OPTIONS)


if __name__ == "__main__":
    main(sys.argv[sys.argv.index("--") + 1])
