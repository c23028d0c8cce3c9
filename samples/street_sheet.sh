#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Renders sets of maps as noise by quilting: a wall of bricks, a hundred metres long, beside cobbles, in
# the built-in sky and a low light from the far end. Below: base colour, normals and height of
# both exemplars.
#   samples/street_sheet.sh OUTPUT.jpg
# Needs a release build, a Vulkan device, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg' 1 1 "$@"
command -v python3 >/dev/null || { echo "street_sheet: install Python: apt-get install python3" >&2; exit 4; }

output=$1
width=900 # of the picture, in pixels
height=500

python3 - "$work/street.gltf" <<'SCENE'
import base64, json, math, struct, sys


def quad(corner, along, up, normal):
    """Positions, normals and texture coordinates in metres."""
    points = [[c + i * a + j * u for c, a, u in zip(corner, along, up)] for j in (0, 1) for i in (0, 1)]
    sizes = math.hypot(*along), math.hypot(*up)
    data = b"".join(struct.pack("<3f", *p) for p in points) + struct.pack("<3f", *normal) * 4
    data += b"".join(struct.pack("<2f", i * sizes[0], (1 - j) * sizes[1]) for j in (0, 1) for i in (0, 1))
    low, high = [list(f(p[k] for p in points) for k in range(3)) for f in (min, max)]
    return data, low, high


quads = [quad((0, 0, 2), (0, 0, -100), (0, 4, 0), (1, 0, 0)),  # facing +x
         quad((0, 0, 2), (90, 0, 0), (0, 0, -100), (0, 1, 0))]
data = b"".join(d for d, _, _ in quads) + struct.pack("<6H", 0, 1, 2, 2, 1, 3)
accessors = [{"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]
for i, (_, low, high) in enumerate(quads):
    accessors += [
        {"bufferView": 0, "byteOffset": 128 * i, "componentType": 5126, "count": 4, "type": "VEC3",
         "min": low, "max": high},
        {"bufferView": 0, "byteOffset": 128 * i + 48, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 0, "byteOffset": 128 * i + 96, "componentType": 5126, "count": 4, "type": "VEC2"}]


def turned(to):
    """The rotation that turns -z to a direction, upright."""
    x, y, z = (c / math.hypot(*to) for c in to)
    yaw, pitch = math.atan2(-x, -z) / 2, math.asin(y) / 2
    a, b, c, d = math.sin(pitch), math.cos(pitch), math.sin(yaw), math.cos(yaw)
    return [a * d, b * c, -a * c, b * d]


json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "color": [1, 0.86, 0.68], "intensity": 9}]}},
    "nodes": [{"mesh": 0}, {"mesh": 1},
              {"camera": 0, "translation": [2.4, 1.5, 1], "rotation": turned((-0.3, -0.16, -1))},
              {"rotation": turned((-0.22, -0.26, 0.9)),
               "extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.85, "znear": 0.05, "zfar": 300}}],
    "materials": [{"name": name, "pbrMetallicRoughness": {"metallicFactor": 0}} for name in ("wall", "street")],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 3 * i + 1, "NORMAL": 3 * i + 2, "TEXCOORD_0": 3 * i + 3},
                                "indices": 0, "material": i}]} for i in (0, 1)],
    "buffers": [{"byteLength": len(data),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": 256}, {"buffer": 0, "byteOffset": 256, "byteLength": 12}],
    "accessors": accessors}, open(sys.argv[1], "w"))
SCENE

"$bin/lichen-test-exemplars" "$work" 512 bond-whole-maps cobbles-whole-maps >/dev/null
"$bin/lichen" bake "$work/bond-whole-maps" -o "$work/bricks.glb" --method quilting --preview none --quiet
"$bin/lichen" bake "$work/cobbles-whole-maps" -o "$work/cobbles.glb" --method quilting --preview none --quiet
"$bin/lichen" apply "$work/street.gltf" --noise "$work/bricks.glb" --material wall --scale 1.35 \
  --factors one -o "$work/half.glb" --quiet
"$bin/lichen" apply "$work/half.glb" --noise "$work/cobbles.glb" --material street --scale 1.6 \
  --factors one -o "$work/scene.glb" --quiet
"$bin/lichen-render" "$work/scene.glb" --size "${width}x$height" --frames 32 --exposure -0.2 \
  -o "$work/scene.png" --quiet
maps=()
for exemplar in bond cobbles; do
  for map in color normal_gl height; do maps+=("$work/$exemplar-whole-maps/$map.png"); done
done
side=$(((width - 5 * 4) / 6))
montage "${maps[@]}" -tile 6x1 -resize "${side}x$side" -geometry +2+2 -background white "$work/maps.png"
convert "$work/scene.png" "$work/maps.png" -background white -gravity center -append -quality 70 "$output"
echo "$output"
