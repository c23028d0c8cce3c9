# SPDX-License-Identifier: MIT
# Three scenes by Blender's own exporter, and what Blender's cameras see of them:
#   taskset --cpu-list 0 blender --background --factory-startup --python-exit-code 1 \
#     --python tests/scenes/blender/export_scenes.py -- tests/scenes/blender
# Needs Debian's packages blender and python3-numpy; the tests need only what is written here. The
# same version writes the same bytes on one processor, on several a normal may round otherwise; the
# files here are by 3.4.1.
#
# For each scene NAME.glb in the folder, and framing.json with, for each camera:
#   "size"       width and height in pixels
#   "points"     corners of objects, each [x, y, z] in the world as glTF has it (y up, metres), and
#                [u, v], where it is in the picture: 0 to 1, from the left and from the top
#   "materials"  names; and for each pixel of a picture of "size" the place in this list of the
#                material that a ray through the pixel's centre meets first, or -1 for none:
#   "runs"       rows from the top, as pairs of that place and how many pixels it goes on
import argparse
import json
import math
import os
import sys

import bmesh
import bpy
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector, noise


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.world = bpy.data.worlds.new("world")
    bpy.context.scene.world.use_nodes = True
    bpy.context.scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.5, 0.65, 0.9, 1)


def checks(name, color):
    """An image of 8 x 8 light and dark checks about a colour."""
    side = 8
    image = bpy.data.images.new(name, side, side)
    pixels = []
    for i in range(side * side):
        factor = 1.0 if (i // side + i) % 2 else 0.85
        pixels += [(factor * channel) ** (1 / 2.2) for channel in color] + [1.0]
    image.pixels = pixels
    image.pack()
    return image


def material(name, color, roughness=0.8, metallic=0.0, emission=None, strength=0.0):
    """Its colour is in a factor, which also multiplies a noise."""
    result = bpy.data.materials.new(name)
    result.use_nodes = True
    inputs = result.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (*color, 1.0)
    inputs["Roughness"].default_value = roughness
    inputs["Metallic"].default_value = metallic
    if emission:
        inputs["Emission"].default_value = (*emission, 1.0)
        inputs["Emission Strength"].default_value = strength
    return result


def textured(name, color, roughness=0.8):
    """Its colour is in a texture, which a noise replaces."""
    result = material(name, color, roughness)
    texture = result.node_tree.nodes.new("ShaderNodeTexImage")
    texture.image = checks(name, color)
    shader = result.node_tree.nodes["Principled BSDF"]
    result.node_tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    return result


def add(name, data, location=(0, 0, 0), rotation=(0, 0, 0), scale=(1, 1, 1)):
    result = bpy.data.objects.new(name, data)
    result.location = location
    result.rotation_euler = rotation
    result.scale = scale
    bpy.context.collection.objects.link(result)
    return result


def look_at(thing, target):
    thing.rotation_euler = (Vector(target) - thing.location).to_track_quat("-Z", "Y").to_euler()


def camera(name, location, target, lens=None, ortho_scale=None):
    data = bpy.data.cameras.new(name)
    if ortho_scale:
        data.type = "ORTHO"
        data.ortho_scale = ortho_scale
    else:
        data.lens = lens
    result = add(name, data, location)
    look_at(result, target)
    return result


def light(name, kind, energy, location, target=None, color=(1, 1, 1), **settings):
    data = bpy.data.lights.new(name, kind)
    data.energy = energy
    data.color = color
    for key, value in settings.items():
        setattr(data, key, value)
    result = add(name, data, location)
    if target:
        look_at(result, target)
    return result


def mesh_of(name, build):
    shape = bmesh.new()
    build(shape)
    result = bpy.data.meshes.new(name)
    shape.to_mesh(result)
    shape.free()
    return result


# ---- A terrain of two materials, with a mask in its vertex colours, and boulders.

TERRAIN_SIDE = 40.0  # metres
TERRAIN_CELLS = 96


def height_at(x, y):
    """Ridges, lower toward the camera, of metres."""
    ridges = noise.ridged_multi_fractal(Vector((x / 15, y / 15, 3.7)), 0.9, 2.1, 6, 1.0, 2.0)
    rise = 0.5 + 0.5 * math.tanh((y + 2.0) / 9.0)
    hummocks = noise.fractal(Vector((x / 5, y / 5, 9.1)), 1.0, 2.0, 4)
    return 3.4 * rise * max(ridges - 0.4, 0.0) + 0.35 * hummocks


def slope_at(x, y):
    step = TERRAIN_SIDE / TERRAIN_CELLS
    dx = (height_at(x + step, y) - height_at(x - step, y)) / (2 * step)
    dy = (height_at(x, y + step) - height_at(x, y - step)) / (2 * step)
    return math.hypot(dx, dy)


def terrain_mesh():
    n = TERRAIN_CELLS + 1
    places = [((i % n / TERRAIN_CELLS - 0.5) * TERRAIN_SIDE,
               (i // n / TERRAIN_CELLS - 0.5) * TERRAIN_SIDE) for i in range(n * n)]
    points = [(x, y, height_at(x, y)) for x, y in places]
    faces = [(i, i + 1, i + n + 1, i + n)
             for j in range(TERRAIN_CELLS) for i in range(j * n, j * n + TERRAIN_CELLS)]
    mesh = bpy.data.meshes.new("terrain")
    mesh.from_pydata(points, [], faces)
    uvs = mesh.uv_layers.new(name="UVMap")  # metres
    for corner, loop in enumerate(mesh.loops):
        uvs.data[corner].uv = places[loop.vertex_index]
    slopes = [slope_at(x, y) for x, y in places]
    # The exporter writes one set of vertex colours, COLOR_0. It tints: hollows are a little darker.
    # Its alpha, which opaque materials do not use, is a mask: 1 where it is steep.
    colors = mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT")
    for i, (x, y, z) in enumerate(points):
        around = sum(height_at(x + a, y + b) for a, b in ((1.5, 0), (-1.5, 0), (0, 1.5), (0, -1.5)))
        shade = min(max(1.0 - 0.25 * (around / 4 - z), 0.75), 1.0)
        steep = min(max((slopes[i] - 0.35) / 0.5, 0.0), 1.0)
        colors.data[i].color = (shade, shade, shade, steep)
    mesh.color_attributes.render_color_index = 0
    for polygon in mesh.polygons:
        polygon.use_smooth = True
        mean = sum(slopes[v] for v in polygon.vertices) / 4
        polygon.material_index = 1 if mean > 0.7 else 0
    return mesh


def boulder_mesh():
    mesh = mesh_of("boulder", lambda b: bmesh.ops.create_icosphere(b, subdivisions=4, radius=1.0))
    for vertex in mesh.vertices:
        p = Vector(vertex.co)
        vertex.co = p * (1 + 0.3 * noise.fractal(p * 0.9 + Vector((5, 1, 2)), 1.0, 2.0, 4))
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    return mesh


def terrain():
    clear()
    ground = textured("ground", (0.16, 0.2, 0.07))
    rock = textured("rock", (0.33, 0.3, 0.27), roughness=0.7)
    boulder = material("boulder", (0.62, 0.58, 0.52), roughness=0.6)
    mesh = terrain_mesh()
    mesh.materials.append(ground)
    mesh.materials.append(rock)
    add("terrain", mesh)
    stone = boulder_mesh()
    stone.materials.append(boulder)
    for i, (x, y, scale) in enumerate([(-3.2, -10.5, (1.1, 0.9, 0.8)), (3.6, -9.0, (-0.8, 0.8, 0.9)),
                                       (0.8, -4.5, (1.6, 1.2, 1.0))]):  # the second is mirrored
        add(f"boulder {i}", stone, (x, y, height_at(x, y) + 0.3), (0.1 * i, 0.2, 1.3 * i), scale)
    light("sun", "SUN", 3.0, (0, 0, 10), target=(6, 7, 0), color=(1.0, 0.93, 0.82))
    camera("view", (0.5, -19.0, height_at(0.5, -19.0) + 2.4), (0, 0, 1.6), lens=32)
    return ["view"], (320, 180)


# ---- A subdivided monkey without texture coordinates, and one with.

def monkey(name, location, rotation, surface, texture_coordinates):
    mesh = mesh_of(name, lambda b: bmesh.ops.create_monkey(b))
    if texture_coordinates:
        uvs = mesh.uv_layers.new(name="UVMap")
        for corner, loop in enumerate(mesh.loops):  # from the front, as a projector would
            p = mesh.vertices[loop.vertex_index].co
            uvs.data[corner].uv = (0.5 + p.x / 2.8, 0.5 + p.z / 2.8)
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    mesh.materials.append(surface)
    result = add(name, mesh, location, rotation)
    result.modifiers.new("Subdivision", "SUBSURF").levels = 2
    return result


def monkeys():
    clear()
    monkey("without coordinates", (-0.85, 0, 1.0), (-0.45, 0, 0.35),
           material("fur", (0.8, 0.7, 0.55), roughness=0.6), False)
    monkey("with coordinates", (0.95, 0.9, 1.0), (-0.45, 0, -0.3),
           textured("plaster", (0.7, 0.66, 0.6)), True)
    plate = mesh_of("floor", lambda b: bmesh.ops.create_grid(b, x_segments=1, y_segments=1, size=4.0))
    plate.materials.append(material("floor", (0.3, 0.3, 0.32), roughness=0.4))
    add("floor", plate, (0, 1.0, 0.33))
    light("key", "SUN", 2.5, (0, 0, 5), target=(2.0, 3.0, 0.0))
    light("rim", "SPOT", 300.0, (-3.0, 3.0, 4.0), target=(0, 0.5, 1.0), color=(0.6, 0.75, 1.0),
          spot_size=0.9, spot_blend=0.4)
    camera("portrait", (0.1, -6.0, 2.2), (0.05, 0.2, 0.95), lens=50)
    camera("plan", (0, 0.4, 8.0), (0, 0.401, 0), ortho_scale=5.5)
    return ["portrait", "plan"], (200, 250)


# ---- An interior with lights, whose texture coordinates are metres.

ROOM = (5.0, 6.0, 2.8)  # metres: x, y, height
WALL = 0.2  # metres


def quads(name, faces, surface):
    """Rectangles, each as corner, side u, side v: texture coordinates go along these, in metres."""
    points, indices, coordinates = [], [], []
    for corner, u, v in faces:
        corner, u, v = Vector(corner), Vector(u), Vector(v)
        first = len(points)
        points += [corner, corner + u, corner + u + v, corner + v]
        indices.append(tuple(range(first, first + 4)))
        coordinates += [(0, 0), (u.length, 0), (u.length, v.length), (0, v.length)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], indices)
    uvs = mesh.uv_layers.new(name="UVMap")
    for corner, coordinate in enumerate(coordinates):
        uvs.data[corner].uv = coordinate
    mesh.materials.append(surface)
    return add(name, mesh)


def box(name, low, high, surface):
    (a, b, c), (d, e, f) = low, high
    x, y, z = (d - a, 0, 0), (0, e - b, 0), (0, 0, f - c)
    minus_x, minus_y = (a - d, 0, 0), (0, b - e, 0)
    return quads(name, [((a, b, c), x, z), ((d, e, c), minus_x, z), ((d, b, c), y, z),
                        ((a, e, c), minus_y, z), ((a, b, f), x, y), ((a, e, c), x, minus_y)],
                 surface)


def walls(surface):
    """Solid ones: through thin ones shadow maps leak light along their edges."""
    x, y, h = ROOM
    t = WALL
    left, right, low, high = 1.6, 4.0, 0.9, 2.3  # the window of the left wall, along y and z
    for name, low_corner, high_corner in [
            ("back", (-t, y, 0), (x + t, y + t, h)), ("right", (x, 0, 0), (x + t, y, h)),
            ("front", (-t, -t, 0), (x + t, 0, h)), ("below window", (-t, 0, 0), (0, y, low)),
            ("above window", (-t, 0, high), (0, y, h)),
            ("before window", (-t, 0, low), (0, left, high)),
            ("behind window", (-t, right, low), (0, y, high))]:
        box(name, low_corner, high_corner, surface)


def interior():
    clear()
    x, y, h = ROOM
    quads("floor", [((0, 0, 0), (x, 0, 0), (0, y, 0))], textured("boards", (0.35, 0.22, 0.12), 0.5))
    walls(textured("wall", (0.75, 0.7, 0.62), 0.9))
    box("ceiling", (-WALL, -WALL, h), (x + WALL, y + WALL, h + WALL),
        material("ceiling", (0.8, 0.8, 0.78), 0.9))
    wood = material("wood", (0.25, 0.13, 0.06), 0.4)
    box("table top", (1.7, 2.8, 0.7), (3.5, 3.8, 0.76), wood)
    for i, (a, b) in enumerate([(1.75, 2.85), (3.37, 2.85), (1.75, 3.67), (3.37, 3.67)]):
        box(f"leg {i}", (a, b, 0), (a + 0.08, b + 0.08, 0.7), wood)
    box("chest", (3.6, 5.2, 0), (4.8, 5.9, 0.9), material("iron", (0.5, 0.5, 0.52), 0.35, 1.0))
    shade = mesh_of("shade", lambda b: bmesh.ops.create_icosphere(b, subdivisions=4, radius=0.18))
    for polygon in shade.polygons:
        polygon.use_smooth = True
    shade.materials.append(material("lamp", (0.8, 0.8, 0.8), 0.5, 0.0, (1.0, 0.8, 0.5), 6.0))
    add("shade", shade, (2.6, 3.3, 1.9))
    light("lamp", "POINT", 60.0, (2.6, 3.3, 1.9), color=(1.0, 0.8, 0.55))
    light("reading", "SPOT", 90.0, (4.6, 4.6, 2.6), target=(4.2, 5.5, 0.9), color=(1.0, 0.9, 0.75),
          spot_size=1.2, spot_blend=0.5)
    light("sun", "SUN", 4.0, (-5, 0, 6), target=(2.4, 5.0, 0.0), color=(1.0, 0.95, 0.85))
    camera("room", (4.5, 0.4, 1.65), (2.0, 4.4, 1.05), lens=22)
    return ["room"], (240, 160)


SCENES = {"terrain": terrain, "monkeys": monkeys, "interior": interior}


# ---- What a camera sees.

def gltf_axes(point):
    return [round(v, 6) for v in (point.x, point.z, -point.y)]


def corner_points(view):
    """Corners of the boxes around the objects, those that the picture shows."""
    points = []
    for thing in sorted(bpy.data.objects, key=lambda o: o.name):
        if thing.type != "MESH":
            continue
        for corner in thing.bound_box:
            world = thing.matrix_world @ Vector(corner)
            seen = world_to_camera_view(bpy.context.scene, view, world)
            if 0 <= seen.x <= 1 and 0 <= seen.y <= 1 and seen.z > 0:
                points.append([gltf_axes(world), [round(seen.x, 6), round(1 - seen.y, 6)]])
    return points


def ray(view, u, v):
    """Origin and direction through a place of the picture."""
    top_right, bottom_right, bottom_left, top_left = view.data.view_frame(scene=bpy.context.scene)
    place = top_left + u * (top_right - top_left) + v * (bottom_left - top_left)
    world = view.matrix_world
    if view.data.type == "ORTHO":
        return world @ Vector((place.x, place.y, 0)), world.to_3x3() @ Vector((0, 0, -1))
    return world.translation, (world.to_3x3() @ place).normalized()


def seen_material(view, u, v, names, graph):
    origin, direction = ray(view, u, v)
    hit, _, _, face, thing, _ = bpy.context.scene.ray_cast(graph, origin, direction)
    if not hit:
        return -1
    mesh = thing.evaluated_get(graph).data
    return names.index(mesh.materials[mesh.polygons[face].material_index].name)


def framing(view, size):
    bpy.context.scene.camera = view
    bpy.context.view_layer.update()
    graph = bpy.context.evaluated_depsgraph_get()
    names = sorted(m.name for m in bpy.data.materials)
    runs = []
    for row in range(size[1]):
        for column in range(size[0]):
            seen = seen_material(view, (column + 0.5) / size[0], (row + 0.5) / size[1], names, graph)
            if runs and runs[-1][0] == seen:
                runs[-1][1] += 1
            else:
                runs.append([seen, 1])
    return {"size": list(size), "points": corner_points(view), "materials": names,
            "runs": [number for run in runs for number in run]}


def export(name, folder):
    cameras, size = SCENES[name]()
    # Cameras are exported with the aspect ratio of this.
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y = size
    seen = {}
    for camera_name in cameras:
        view = bpy.data.objects[camera_name]
        seen[camera_name] = framing(view, size)
    bpy.ops.export_scene.gltf(filepath=os.path.join(folder, name + ".glb"), export_format="GLB",
                              export_apply=True, export_cameras=True, export_lights=True,
                              export_colors=True, export_animations=False)
    return seen


def main():
    parser = argparse.ArgumentParser(prog="export_scenes.py")
    parser.add_argument("folder")
    options = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
    seen = {name: export(name, options.folder) for name in SCENES}
    with open(os.path.join(options.folder, "framing.json"), "w", encoding="ascii") as file:
        json.dump(seen, file, separators=(",", ":"))
        file.write("\n")


main()
