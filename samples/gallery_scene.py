#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a scene for a picture of the gallery, in metres: gallery_scene.py OUTPUT.glb SHAPE [X Y Z]

X Y Z replaces all normals. Shapes: ball, bowl, torus, floor, street, wall.
"""
import json, math, struct, sys


def revolved(profile, columns):
    """The surface of a profile, (radius, height, outward and upward part of the normal), about y."""
    turns = [(math.cos(a), math.sin(a)) for a in (2 * math.pi * j / columns for j in range(columns + 1))]
    indices = []
    for i in range(len(profile) - 1):
        for j in range(columns):
            a, b = i * (columns + 1) + j, (i + 1) * (columns + 1) + j
            indices += [a, b, a + 1, a + 1, b, b + 1]
    return {"POSITION": [(r * c, y, r * s) for r, y, _, _ in profile for c, s in turns],
            "NORMAL": [(out * c, up, out * s) for _, _, out, up in profile for c, s in turns],
            "indices": indices}


def quad(corner, along, up, normal, exemplar=1):
    """A rectangle with texture coordinates, one unit per exemplar."""
    sizes = math.hypot(*along) / exemplar, math.hypot(*up) / exemplar
    places = [(i, j) for j in (0, 1) for i in (0, 1)]
    return {"POSITION": [[c + i * a + j * u for c, a, u in zip(corner, along, up)] for i, j in places],
            "NORMAL": [normal] * 4,
            "TEXCOORD_0": [(i * sizes[0], (1 - j) * sizes[1]) for i, j in places],
            "indices": [0, 1, 2, 2, 1, 3]}


def circle(radius, around, height, first, last, steps):
    """An arc of a profile, angles in half turns."""
    angles = [math.pi * (first + (last - first) * i / steps) for i in range(steps + 1)]
    return [(around + radius * math.cos(a), height + radius * math.sin(a), math.cos(a), math.sin(a))
            for a in angles]


def bowl():
    """From the foot outside over the rim to the bottom inside, closed by a flat foot."""
    quarter = [math.pi / 2 * i / 60 for i in range(61)]
    profile = [(0.42 + 0.58 * math.sin(t) ** 0.8, 0.9 - 0.9 * math.cos(t)) for t in quarter]
    profile += [place[:2] for place in circle(0.05, 0.95, 0.9, 1 / 12, 11 / 12, 10)]
    profile += [(0.9 * math.cos(t), 0.9 - 0.78 * math.sin(t)) for t in quarter]
    foot = [(0.0, 0.0), (0.42, 0.0)]
    rows = [(*place, 0.0, -1.0) for place in foot]
    around = foot + profile + profile[-1:]
    for i in range(2, len(around) - 1):
        out, up = around[i + 1][0] - around[i - 1][0], around[i + 1][1] - around[i - 1][1]
        rows.append((*around[i], up / math.hypot(out, up), -out / math.hypot(out, up)))
    return rows


def turned(to):
    """The rotation that turns -z to a direction, upright."""
    x, y, z = (c / math.hypot(*to) for c in to)
    yaw, pitch = math.atan2(-x, -z) / 2, math.asin(y) / 2
    a, b, c, d = math.sin(pitch), math.cos(pitch), math.sin(yaw), math.cos(yaw)
    return [a * d, b * c, -a * c, b * d]


def camera(eye, to, yfov, name="view"):
    return {"name": name, "translation": eye, "rotation": turned(to)}, yfov


def around(target, yaw, pitch, distance, yfov):
    yaw, pitch = math.radians(yaw), math.radians(pitch)
    to = (-math.sin(yaw) * math.cos(pitch), math.sin(pitch), -math.cos(yaw) * math.cos(pitch))
    return camera([t - distance * k for t, k in zip(target, to)], to, yfov)


def before_wall(name, distance, across, x, y):
    return camera([x, y, distance], (0, 0, -1), 2 * math.atan(across / 2 / distance), name)


ball = circle(1, 0, 0, -1 / 2, 1 / 2, 64)
torus = circle(0.32, 0.68, 0, 0, 2, 80)
# Meshes by material; cameras; other members of the scene's root node.
meshes, cameras, root = {
    "ball": lambda: ({"ball": revolved(ball, 128)}, [around((0, 0, 0), 40, -25, 4.4, 0.5)], {}),
    "bowl": lambda: ({"bowl": revolved(bowl(), 160)}, [around((0, 0.42, 0), 0, -38, 4.6, 0.5)], {}),
    "torus": lambda: ({"torus": revolved(torus, 160)}, [around((0, 0, 0), 0, -40, 4.2, 0.55)], {}),
    # Oblique to x, y and z.
    "floor": lambda: ({"floor": quad((-40, 0, 1), (80, 0, 0), (0, 0, -80), (0, 1, 0))},
                      [camera([0, 0.35, 1], (0, -0.258, -0.966), 0.6)],
                      {"rotation": [0.3015, 0, -0.3015, 0.9045]}),
    "street": lambda: ({"wall": quad((0, 0, 2), (0, 0, -100), (0, 4, 0), (1, 0, 0)),
                        "street": quad((0, 0, 2), (90, 0, 0), (0, 0, -100), (0, 1, 0))},
                       [camera([2.4, 1.5, 1], (-0.3, -0.16, -1), 0.85)], {}),
    "wall": lambda: ({"wall": quad((-50, 0, 0), (100, 0, 0), (0, 8, 0), (0, 0, 1), 1.35)},
                     [before_wall("close", 3, 1.8, 3, 1.5), before_wall("middle", 7, 5, 3, 4),
                      before_wall("whole", 60, 7.8, 0, 4)], {}),
}[sys.argv[2]]()

gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [root], "meshes": [],
        "materials": [], "accessors": [], "bufferViews": [], "cameras": []}
data = b""


def accessor(values, kind, component):
    global data
    flat = values if kind == "SCALAR" else [v for value in values for v in value]
    packed = struct.pack(f"<{len(flat)}{'f' if component == 5126 else 'I'}", *flat)
    gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
    gltf["accessors"].append({"bufferView": len(gltf["bufferViews"]) - 1, "componentType": component,
                              "count": len(values), "type": kind})
    data += packed
    return len(gltf["accessors"]) - 1


for material, mesh in meshes.items():
    if len(sys.argv) > 3:
        mesh["NORMAL"] = [tuple(map(float, sys.argv[3:6]))] * len(mesh["POSITION"])
    attributes = {name: accessor(mesh[name], f"VEC{len(mesh[name][0])}", 5126) for name in mesh if name != "indices"}
    position = gltf["accessors"][attributes["POSITION"]]
    position["min"], position["max"] = ([f(p[k] for p in mesh["POSITION"]) for k in range(3)] for f in (min, max))
    gltf["materials"].append({"name": material, "pbrMetallicRoughness": {
        "metallicFactor": 0, "roughnessFactor": {"bowl": 0.5, "torus": 0.7}.get(material, 1)}})
    gltf["meshes"].append({"primitives": [{"attributes": attributes, "material": len(gltf["meshes"]),
                                           "indices": accessor(mesh["indices"], "SCALAR", 5125)}]})
children = [{"mesh": i} for i in range(len(gltf["meshes"]))]
for i, (node, yfov) in enumerate(cameras):
    gltf["cameras"].append({"type": "perspective", "perspective": {"yfov": yfov, "znear": 0.01, "zfar": 300}})
    children.append({"camera": i, **node})
if sys.argv[2] == "street":  # low light from the far end
    gltf["extensionsUsed"] = ["KHR_lights_punctual"]
    gltf["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "color": [1, 0.86, 0.68], "intensity": 9}]}}
    children.append({"rotation": turned((-0.22, -0.26, 0.9)), "extensions": {"KHR_lights_punctual": {"light": 0}}})
if sys.argv[2] == "wall":
    gltf["images"], gltf["textures"] = [{"uri": "bond-whole.png"}], [{"source": 0}]
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
root["children"] = list(range(1, len(children) + 1))
gltf["nodes"] += children
gltf["buffers"] = [{"byteLength": len(data)}]

text = json.dumps(gltf).encode()
text += b" " * (-len(text) % 4)
with open(sys.argv[1], "wb") as file:
    file.write(struct.pack("<4s2I", b"glTF", 2, 28 + len(text) + len(data)))
    file.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)
