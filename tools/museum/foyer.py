"""Builds assets/levels/foyer.glb: the Foyer and the Hall of Mirrors wing of the Museum of Light at night.

blender -b --factory-startup -noaudio --python tools/museum/foyer.py -- OUT.glb [--blend OUT.blend]
Takes a minute or two. The same scripts give the same bytes every time; a mistake in the plan stops with a sentence."""
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bpy

import dress_entrance
import dress_galleries
import dress_north
import doors
import gameplay
import lamps
import light
import mouldings
import palette
import plan
import scene


def build(folder):
    scene.clear()
    palette.begin(folder)
    lamps.begin()
    scene.mesh("museum", plan.shell_mesh(), kind="shell")
    mouldings.trim_rooms()
    mouldings.surround_openings()
    mouldings.steps_and_ramp()
    mouldings.low_doorway()
    mouldings.skylights()
    mouldings.coffers("foyer", [-7.86, -5.25, -2.64, 0.0, 2.64, 5.25, 7.86], [-10.86, -8.75, -6.64, -4.0, -1.36, 0.75, 2.86],
                      6.6, plan.SKYLIGHTS["foyer"])
    mouldings.coffers("stair", [-2.46, -0.9, 0.9, 2.46], [3.54, 4.6, 6.2, 7.86], 5.4)
    mouldings.coffers("vestibule", [-2.86, -0.95, 0.95, 2.86], [-15.26, -14.1, -12.5, -11.54], 3.9)
    mouldings.coffers("library", [-12.86, -10.9, -8.5, -6.1, -4.14], [18.74, 20.8, 22.9, 24.86], 4.6)
    mouldings.joists("cloakroom", (-10.1, -8.75, -7.35), True)
    mouldings.joists("lodge", (-10.1, -8.75, -7.35), True)
    mouldings.joists("store", (4.15, 5.8, 7.0), True, depth=0.16)
    mouldings.joists("workshop", (5.2, 6.6, 10.2, 11.6), False, depth=0.24)
    light.skies()
    light.stars()
    doors.hang()
    dress_entrance.carve_busts()
    dress_entrance.dress()
    dress_galleries.dress()
    dress_north.dress()
    gameplay.place()
    _dress_guard()


def _dress_guard():
    """The guard has his own script; without it the level has no body for its guard to wear."""
    try:
        import guard
    except ImportError:
        print("foyer: no guard.py, so the level has no guard_model")
        return
    guard.build_guard()


def export(path):
    options = dict(filepath=path, export_format="GLB", export_yup=True, export_extras=True, export_lights=True, export_cameras=True,
                   export_animations=True, export_skins=True, export_apply=False, export_image_format="AUTO")
    bpy.ops.export_scene.gltf(**options)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if not arguments:
        sys.exit("usage: blender -b --factory-startup -noaudio --python foyer.py -- OUT.glb [--blend OUT.blend]")
    with tempfile.TemporaryDirectory() as folder:
        build(folder)
        print(f"foyer: {scene.triangles()} triangles, {len(bpy.context.scene.objects)} nodes")
        if "--blend" in arguments:
            bpy.ops.file.pack_all()
            bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(arguments[arguments.index("--blend") + 1]))
        export(os.path.abspath(arguments[0]))


if __name__ == "__main__":
    try:
        main()
    except Exception:
        import traceback
        traceback.print_exc()
        sys.exit(1)
