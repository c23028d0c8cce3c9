#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of a wall of bricks of a hundred by eight metres: an exemplar that tiles, repeated;
# blended by Mikkelsen's "Practical Real-Time Hex-Tiling" (JCGT 11(3), 2022); and by quilting. Upper
# rows: from close by and from farther away. Below: the whole wall, repeated, hex-tiled, quilted.
#   samples/wall_sheet.sh OUTPUT.jpg
# lichen-render draws the first and the last unlit, with mips. This script draws the second, with 64
# points per pixel averaged as light, so that its filtering is no worse.
# Needs a release build, a Vulkan device, Python 3 with NumPy, and ImageMagick (Debian packages
# python3-numpy, imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg' 1 1 "$@"
python3 -c 'import numpy' 2>/dev/null ||
  { echo "wall_sheet: install NumPy: apt-get install python3-numpy" >&2; exit 4; }

output=$1
metres=1.35 # width of the exemplar
width=360 # of a panel, in pixels
height=240
whole_width=$((3 * width + 16)) # of the whole wall, as wide as the upper rows
whole_height=$((whole_width * 8 / 100))

"$bin/lichen-test-exemplars" "$work" 512 bond-whole >/dev/null
exemplar=$work/bond-whole.png

# The wall, three cameras straight before it, and the exemplar repeated on it.
python3 - "$work/wall.gltf" "$metres" <<'SCENE'
import base64, json, math, struct, sys
tile = float(sys.argv[2])
corners = [(-50, 0), (50, 0), (-50, 8), (50, 8)]
data = b"".join(struct.pack("<3f", x, y, 0) for x, y in corners)
data += struct.pack("<3f", 0, 0, 1) * 4
data += b"".join(struct.pack("<2f", (x + 50) / tile, (8 - y) / tile) for x, y in corners)
data += struct.pack("<6H", 0, 1, 2, 2, 1, 3)


def camera(name, distance, across, x, y):
    yfov = 2 * math.atan(across / 2 / distance)
    return ({"name": name, "type": "perspective", "perspective": {"yfov": yfov, "znear": 0.1}},
            {"name": name, "translation": [x, y, distance]})


views = [camera("close", 3, 1.8, 3, 1.5), camera("middle", 7, 5, 3, 4), camera("whole", 60, 7.8, 0, 4)]
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
    "nodes": [{"mesh": 0}] + [dict(node, camera=i) for i, (_, node) in enumerate(views)],
    "cameras": [camera for camera, _ in views],
    "materials": [{"name": "wall", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "bond-whole.png"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
                                "indices": 3, "material": 0}]}],
    "buffers": [{"byteLength": len(data),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": 128}, {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
         "min": [-50, 0, 0], "max": [50, 8, 0]},
        {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 0, "byteOffset": 96, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]},
    open(sys.argv[1], "w"))
SCENE
"$bin/lichen" bake "$exemplar" -o "$work/noise.glb" --method quilting --preview none --quiet
"$bin/lichen" apply "$work/wall.gltf" --noise "$work/noise.glb" --material all --factors one \
  -o "$work/quilted.glb" --quiet

# draw VIEW WIDTH HEIGHT METRES X Y: three pictures of the wall around (X, Y), so many metres high.
draw() {
  local shot=(--camera "$1" --size "$2x$3" --debug-view base-color --quiet)
  "$bin/lichen-render" "$work/wall.gltf" "${shot[@]}" -o "$work/$1-repeated.png"
  "$bin/lichen-render" "$work/quilted.glb" "${shot[@]}" -o "$work/$1-quilted.png"
  python3 - "$work/bond.ppm" "$work/$1-hextile.ppm" "$metres" "${@:2}" <<'HEXTILE'
import re, sys
import numpy as np

tile, width, height, across, left, top = map(float, sys.argv[3:])
width, height = int(width), int(height)
with open(sys.argv[1], "rb") as file:
    data = file.read()
header = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
side_x, side_y = int(header[1]), int(header[2])
code = np.frombuffer(data, np.uint8, offset=header.end()).reshape(side_y, side_x, 3) / 255
image = np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)  # light

POINTS = 8  # per pixel, along each axis
step = across / (height * POINTS) / tile  # between points, in tiles
while step * image.shape[1] >= 2:  # mips
    image = image.reshape(image.shape[0] // 2, 2, image.shape[1] // 2, 2, 3).mean((1, 3))


def fetched(u, v):
    """Bilinear, repeats."""
    rows, columns = image.shape[:2]
    x, y = u * columns - 0.5, v * rows - 0.5
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    x1, y1, fx, fy = x0 + 1, y0 + 1, (x - x0)[:, None], (y - y0)[:, None]
    row = lambda i: (1 - fx) * image[i % rows, x0 % columns] + fx * image[i % rows, x1 % columns]
    return (1 - fy) * row(y0) + fy * row(y1)


def hextiled(u, v):
    """The colours of hextile-demo with its defaults: no rotation, exponent 7, contrast 0.7."""
    scale = 2 * 3**0.5
    x, y = scale * (u - v / 3**0.5), scale * v * 2 / 3**0.5
    cell_x, cell_y = np.floor(x), np.floor(y)
    x, y = x - cell_x, y - cell_y
    rest = 1 - x - y
    upper = rest <= 0
    side = 1 - 2 * upper
    vertices = [(upper, upper, side * rest), (upper, 1 - upper, upper + side * y),
                (1 - upper, upper, upper + side * x)]
    colors, weights = [], []
    for i, j, weight in vertices:
        i, j = cell_x + i, cell_y + j
        offset_u = 43758.5453 * np.sin(127.1 * i + 311.7 * j)
        offset_v = 43758.5453 * np.sin(269.5 * i + 183.3 * j)
        color = fetched(u + offset_u % 1, v + offset_v % 1)
        colors.append(color)
        weights.append((0.4 + 0.6 * color @ [0.299, 0.587, 0.114]) * weight**7)
    weights = np.array(weights) / sum(weights)
    power = np.log(1 - 0.7) / np.log(0.5)
    weights = np.where(weights < 0.5, 0.5 * (2 * weights) ** power, 1 - 0.5 * (2 - 2 * weights) ** power)
    return sum(w[:, None] * c for w, c in zip(weights / weights.sum(0), colors))


u = (left + 50) / tile + step * (np.arange(width * POINTS) + 0.5 - width * POINTS / 2)
light = np.empty((height, width, 3))
for y in range(height):
    v = (8 - top) / tile + step * (np.arange(y * POINTS, (y + 1) * POINTS) + 0.5 - height * POINTS / 2)
    points = hextiled(np.tile(u, POINTS), np.repeat(v, u.size))
    light[y] = points.reshape(POINTS, width, POINTS, 3).mean((0, 2))
code = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
with open(sys.argv[2], "wb") as file:
    file.write(b"P6 %d %d 255\n" % (width, height) + np.rint(255 * code.clip(0, 1)).astype(np.uint8).tobytes())
HEXTILE
}

convert "$exemplar" -depth 8 "$work/bond.ppm"
draw close "$width" "$height" 1.8 3 1.5
draw middle "$width" "$height" 5 3 4
draw whole "$whole_width" "$whole_height" 7.8 0 4
upper=() lower=() whole=()
for method in repeated.png hextile.ppm quilted.png; do
  upper+=("$work/close-$method") lower+=("$work/middle-$method") whole+=("$work/whole-$method")
done
montage "${upper[@]}" "${lower[@]}" -tile 3x -geometry +4+4 -background white "$work/upper.png"
montage "${whole[@]}" -tile 1x -geometry +4+4 -background white "$work/whole.png"
convert "$work/upper.png" "$work/whole.png" -background white -append -quality 70 "$output"
echo "$output"
