"""Renders a glTF scene with Blender's Cycles and says what it took: blender -b ... --python cycles.py -- SETTINGS.json

SETTINGS: scene, folder, width, height, threads, samples, reference_samples, position [x, y, z], yaw, pitch, roll, fov_y
(metres and radians, +y up, as render/camera.h has them). Leaves folder/a.exr and b.exr (independent, `samples` each),
folder/reference.exr and folder/timing.json: core seconds of a picture of one sample and of each of the others.

Unfiltered and unclamped, every bounce and caustic that the path tracer has too; a black world; a box for a pixel.
"""
import json
import math
import resource
import sys

import bpy
import numpy

if not hasattr(numpy, "bool"):  # Blender 3.4 asks for a name that newer numpys have dropped
    numpy.bool = bool


def core_seconds():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def open_scene(settings):
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=settings["scene"])
    scene = bpy.context.scene
    world = bpy.data.worlds.new("night")
    world.color = (0.0, 0.0, 0.0)
    scene.world = world
    data = bpy.data.cameras.new("eye")
    eye = bpy.data.objects.new("eye", data)
    scene.collection.objects.link(eye)
    x, y, z = settings["position"]
    eye.location = (x, -z, y)
    eye.rotation_mode = "XYZ"
    eye.rotation_euler = (math.pi / 2 + settings["pitch"], 0.0, settings["yaw"])
    eye.rotation_euler.rotate_axis("Z", settings["roll"])
    data.sensor_fit = "VERTICAL"
    data.lens_unit = "FOV"
    data.angle = settings["fov_y"]
    data.clip_start, data.clip_end = 1e-3, 1e6
    scene.camera = eye
    return scene


def set_up(scene, settings):
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = settings["width"], settings["height"]
    render.resolution_percentage = 100
    render.threads_mode, render.threads = "FIXED", settings["threads"]
    render.use_persistent_data = True
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.image_settings.exr_codec = "ZIP"
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    for kind in ["max", "diffuse", "glossy", "transmission"]:
        setattr(cycles, "max_bounces" if kind == "max" else f"{kind}_bounces", 24)
    cycles.transparent_max_bounces = 32
    cycles.pixel_filter_type = "BOX"


def render(scene, path, samples, seed):
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.filepath = path
    begun = core_seconds()
    bpy.ops.render.render(write_still=True)
    return core_seconds() - begun


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
        settings = json.load(file)
    scene = open_scene(settings)
    set_up(scene, settings)
    folder = settings["folder"]
    render(scene, f"{folder}/first.exr", 1, 1)  # builds what later pictures find built
    timing = {
        "one": render(scene, f"{folder}/first.exr", 1, 1),
        "a": render(scene, f"{folder}/a.exr", settings["samples"], 2),
        "b": render(scene, f"{folder}/b.exr", settings["samples"], 3),
        "reference": render(scene, f"{folder}/reference.exr", settings["reference_samples"], 4),
    }
    with open(f"{folder}/timing.json", "w", encoding="utf-8") as file:
        json.dump(timing, file)


main()
