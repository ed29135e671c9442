"""The museum's materials by name. A material is glTF metallic-roughness plus a `surface` (what it is to feet and
ears), made in Blender on first use. Textured ones name a picture of textures.py or paintings.py and the metres one
repeat covers."""
import bpy

import paintings
import textures

WARM = (1.0, 0.66, 0.35)    # a 2700 K filament, as linear colour with red = 1
MOON = (0.42, 0.62, 1.0)    # what the night's adapted eye makes of moonlight


def _m(surface, colour=(0.8, 0.8, 0.8), rough=0.6, metal=0.0, **more):
    return dict(surface=surface, colour=colour, rough=rough, metal=metal, **more)


MATERIALS = {
    # floors, walls and ceilings
    "floor_foyer": _m("marble", rough=0.12, image="marble_checker", tile=4.0),
    "floor_hall": _m("marble", rough=0.10, image="marble_star", tile=3.2),
    "floor_gallery": _m("parquet", rough=0.28, image="parquet_herringbone", tile=1.8, bump=True),
    "floor_cabinet": _m("parquet", rough=0.22, image="parquet_squares", tile=1.6, bump=True),
    "floor_boards": _m("parquet", rough=0.4, image="boards", tile=1.6, bump=True),
    "floor_service": _m("concrete", rough=0.7, image="flagstones", tile=2.4, bump=True),
    "wall_foyer": _m("plaster", rough=0.7, image="ashlar", tile=2.4, bump=True),
    "wall_cream": _m("plaster", rough=0.8, image="plaster_cream", tile=2.0, bump=True),
    "wall_red": _m("plaster", rough=0.7, image="damask_red", tile=1.2, bump=True),
    "wall_green": _m("plaster", rough=0.7, image="damask_green", tile=1.2, bump=True),
    "wall_blue": _m("plaster", rough=0.65, image="damask_blue", tile=1.2, bump=True),
    "wall_violet": _m("plaster", rough=0.65, image="damask_violet", tile=1.0, bump=True),
    "wall_paper": _m("plaster", rough=0.8, image="paper_stripe", tile=1.2, bump=True),
    "wall_service": _m("plaster", rough=0.85, image="plaster_lime", tile=2.0, bump=True),
    "ceiling": _m("plaster", rough=0.85, image="plaster_white", tile=2.0),
    "statuary": _m("marble", rough=0.38, image="marble_white", tile=1.2),
    "night": _m("plaster", (0.01, 0.015, 0.03), 1.0, glow=((0.10, 0.22, 0.55), 0.035)),
    "star": _m("plaster", (0.0, 0.0, 0.0), 1.0, glow=((0.8, 0.9, 1.0), 1.5)),
    # stone and plaster that stands
    "stucco": _m("plaster", rough=0.7, image="plaster_white", tile=2.0),
    "marble_white": _m("marble", rough=0.32, image="marble_white", tile=1.2),
    "marble_green": _m("marble", rough=0.12, image="marble_green", tile=1.0),
    "marble_rose": _m("marble", rough=0.15, image="marble_rose", tile=1.2),
    "marble_black": _m("marble", rough=0.1, image="marble_black", tile=1.0),
    "limestone": _m("marble", rough=0.5, image="plaster_stone", tile=2.0),
    "bronze": _m("metal", (0.21, 0.13, 0.07), 0.35, 1.0),
    "pebble": _m("marble", (0.32, 0.31, 0.30), 0.8),
    # wood, cloth, metal
    "oak": _m("oak", rough=0.45, image="oak", tile=1.0, grain=True, bump=True),
    "oak_dark": _m("oak", rough=0.35, image="oak_dark", tile=1.0, grain=True, bump=True),
    "gilt": _m("metal", (0.95, 0.66, 0.25), 0.42, 1.0),
    "brass": _m("metal", (0.88, 0.62, 0.27), 0.28, 1.0),
    "iron": _m("metal", (0.10, 0.10, 0.11), 0.45, 1.0),
    "copper": _m("metal", (0.72, 0.33, 0.18), 0.35, 1.0),
    "speculum": _m("metal", (0.78, 0.76, 0.72), 0.14, 1.0),
    "iron_green": _m("metal", (0.05, 0.085, 0.07), 0.5),
    "steel": _m("metal", (0.55, 0.56, 0.58), 0.3, 1.0),
    "velvet_red": _m("curtain", (0.30, 0.015, 0.02), 0.95),
    "velvet_blue": _m("curtain", (0.02, 0.03, 0.14), 0.95),
    "leather": _m("curtain", (0.16, 0.045, 0.02), 0.5),
    "leather_green": _m("curtain", (0.02, 0.09, 0.05), 0.5),
    "carpet": _m("carpet", rough=0.95, image="carpet", tile=1.6),
    "paper": _m("plaster", (0.75, 0.70, 0.58), 0.9),
    "book_red": _m("curtain", rough=0.5, image="spine_red", tile=0.36),
    "book_green": _m("curtain", rough=0.5, image="spine_green", tile=0.36),
    "book_blue": _m("curtain", rough=0.5, image="spine_blue", tile=0.36),
    "book_tan": _m("curtain", rough=0.5, image="spine_tan", tile=0.36),
    "leaf": _m("curtain", (0.045, 0.12, 0.035), 0.5),
    "earth": _m("carpet", (0.05, 0.035, 0.02), 0.95),
    "coat": _m("curtain", (0.05, 0.05, 0.06), 0.95),
    "dark_cloth": _m("curtain", (0.10, 0.08, 0.05), 0.95),
    # light
    "mirror": _m("glass", (0.93, 0.93, 0.92), 0.0, 1.0),
    "glass": _m("glass", (1.0, 1.0, 1.0), 0.0, clear=True, absorb=((0.85, 0.95, 0.92), 0.5)),
    "pane": _m("pane", (1.0, 1.0, 1.0), 0.0, clear=True, absorb=((0.80, 0.90, 0.95), 0.3)),
    "lens_glass": _m("glass", (1.0, 1.0, 1.0), 0.0, clear=True, absorb=((0.92, 0.97, 1.0), 0.4)),
    "amber_glass": _m("glass", (1.0, 1.0, 1.0), 0.0, clear=True, absorb=((1.0, 0.55, 0.15), 0.12)),
    "enamel_lit": _m("metal", (0.85, 0.80, 0.70), 0.6, glow=(WARM, 0.9)),
    "enamel_green": _m("metal", (0.02, 0.16, 0.07), 0.15),
    "exit_sign": _m("metal", (0.0, 0.0, 0.0), 0.5, glow=((1.0, 1.0, 1.0), 0.55), glow_image="exit_sign"),
    "ember": _m("metal", (0.1, 0.02, 0.01), 0.8, glow=((1.0, 0.25, 0.05), 1.2)),
}
for _name in paintings.NAMES:
    MATERIALS["art_" + _name] = _m("plaster", rough=0.45, image=_name, tile=1.0)

_folder = None
_made = {}


def begin(folder):
    """Starts afresh; pictures are written to and loaded from `folder`."""
    global _folder
    _folder = folder
    _made.clear()


def tile_of(name):
    return MATERIALS[name].get("tile", 0.0) if name in MATERIALS else 0.0


def has_grain(name):
    return name in MATERIALS and MATERIALS[name].get("grain", False)


def lamp_material(name, colour, radiance):
    """An emitter of its own name: `radiance` (W/m2/sr) times a colour whose largest part is 1."""
    MATERIALS[name] = _m("glass", (0.0, 0.0, 0.0), 1.0, glow=(colour, radiance))
    return name


def material(name):
    if name not in _made:
        _made[name] = _build(name, MATERIALS[name])
    return _made[name]


def _build(name, recipe):
    made = bpy.data.materials.new(name)
    made["surface"] = recipe["surface"]
    made.use_nodes = True
    made.use_backface_culling = bool(recipe.get("clear"))  # glass is solid; glTF wants its skin one-sided
    nodes, links = made.node_tree.nodes, made.node_tree.links
    surface = nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value = (*recipe["colour"], 1.0)
    surface["Roughness"].default_value = recipe["rough"]
    surface["Metallic"].default_value = recipe["metal"]
    if "image" in recipe:
        node = nodes.new("ShaderNodeTexImage")
        node.image = _image(recipe["image"])
        links.new(node.outputs["Color"], surface["Base Color"])
        if recipe.get("bump"):
            _raise(nodes, links, recipe["image"])
    if "glow" in recipe:
        surface["Emission"].default_value = (*recipe["glow"][0], 1.0)
        surface["Emission Strength"].default_value = recipe["glow"][1]
    if "glow_image" in recipe:
        node = nodes.new("ShaderNodeTexImage")
        node.image = _image(recipe["glow_image"])
        links.new(node.outputs["Color"], surface["Emission"])
    if recipe.get("clear"):
        surface["Transmission"].default_value = 1.0
        surface["IOR"].default_value = 1.5
        tint, distance = recipe["absorb"]
        volume = nodes.new("ShaderNodeVolumeAbsorption")
        volume.inputs["Color"].default_value = (*tint, 1.0)
        volume.inputs["Density"].default_value = 1.0 / distance
        links.new(volume.outputs["Volume"], nodes["Material Output"].inputs["Volume"])
        _mark_as_solid(nodes)
    return made


def _mark_as_solid(nodes):
    """Blender's exporter writes absorption only for a material that says it has a thickness."""
    group = bpy.data.node_groups.get("glTF Material Output")
    if group is None:
        group = bpy.data.node_groups.new("glTF Material Output", "ShaderNodeTree")
        group.inputs.new("NodeSocketFloat", "Occlusion")
        group.inputs.new("NodeSocketFloat", "Thickness").default_value = 0.0
        group.nodes.new("NodeGroupInput")
    node = nodes.new("ShaderNodeGroup")
    node.node_tree = group
    node.inputs["Thickness"].default_value = 0.01


def _raise(nodes, links, name):
    """Joins the normal map that textures.relief makes of the picture's own lights and darks."""
    node = nodes.new("ShaderNodeTexImage")
    node.image = _image(name + "_normal")
    bent = nodes.new("ShaderNodeNormalMap")
    links.new(node.outputs["Color"], bent.inputs["Color"])
    links.new(bent.outputs["Normal"], nodes["Principled BSDF"].inputs["Normal"])


def _image(name):
    image = bpy.data.images.get(name)
    if image is None:
        if name.endswith("_normal"):
            pixels = textures.relief(name[:-len("_normal")])
        else:
            pixels = paintings.paint(name) if name in paintings.NAMES else textures.weave(name)
        path = textures.save(pixels, name, _folder)
        image = bpy.data.images.load(path)
        image.name = name
        if name.endswith("_normal"):
            image.colorspace_settings.name = "Non-Color"
    return image
