#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet that zooms in on a ball, one exemplar per row: tiling at 1, 8 and 64 times the size,
# then local random-phase noise with a structure.
#   samples/zoom_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build, a Vulkan device, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"
command -v python3 >/dev/null || { echo "zoom_sheet: install Python: apt-get install python3" >&2; exit 4; }

panel=360
output=$1
shift

# A ball with a radius of one metre, whose seam is at the back, and a camera per zoom.
python3 - "$work/ball.gltf" 1 8 64 <<'BALL'
import base64, json, math, struct, sys
columns, rows = 240, 120
points, coordinates, indices = [], [], []
for i in range(rows + 1):
    for j in range(columns + 1):
        latitude, longitude = math.pi * i / rows, 2 * math.pi * j / columns
        points.append((-math.sin(latitude) * math.sin(longitude), math.cos(latitude),
                       -math.sin(latitude) * math.cos(longitude)))
        coordinates.append((4 * j / columns, 2 * i / rows))
for i in range(rows):
    for j in range(columns):
        a, b = i * (columns + 1) + j, (i + 1) * (columns + 1) + j
        indices += [a, b, a + 1, a + 1, b, b + 1]
data = b"".join(struct.pack("<3f", *p) for p in points)
data += b"".join(struct.pack("<2f", *p) for p in coordinates)
data += struct.pack(f"<{len(indices)}H", *indices)
size = 12 * len(points)
zooms = [int(zoom) for zoom in sys.argv[2:]]
pitch, distance = math.radians(-30), 4.6
nodes, cameras = [{"mesh": 0}], []
for zoom in zooms:
    cameras.append({"name": f"zoom{zoom}", "type": "perspective",
                    "perspective": {"yfov": 2 * math.atan(math.tan(0.25) / zoom), "znear": 0.1}})
    nodes.append({"camera": len(cameras) - 1, "name": f"zoom{zoom}",
                  "translation": [0, -distance * math.sin(pitch), distance * math.cos(pitch)],
                  "rotation": [math.sin(pitch / 2), 0, 0, math.cos(pitch / 2)]})
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
    "nodes": nodes, "cameras": cameras,
    "materials": [{"name": "ball", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.6}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0, "TEXCOORD_0": 1},
                                "indices": 2, "material": 0}]}],
    "buffers": [{"byteLength": len(data),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": size},
                    {"buffer": 0, "byteOffset": size, "byteLength": 8 * len(points)},
                    {"buffer": 0, "byteOffset": size + 8 * len(points), "byteLength": 2 * len(indices)}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
         "min": [-1, -1, -1], "max": [1, 1, 1]},
        {"bufferView": 1, "componentType": 5126, "count": len(points), "type": "VEC2"},
        {"bufferView": 2, "componentType": 5123, "count": len(indices), "type": "SCALAR"}]},
    open(sys.argv[1], "w"))
BALL

panels=()
for exemplar in "$@"; do
  for method in tiling 'local-random-phase --structure 0.3'; do
    file=$work/noise-${#panels[@]}
    # shellcheck disable=SC2086 # the method and its option are words of their own
    "$bin/lichen" bake "$exemplar" -o "$file.glb" --method $method --preview none --quiet
    "$bin/lichen" apply "$work/ball.gltf" --noise "$file.glb" --material all -o "$file-scene.glb" --quiet
    for zoom in 1 8 64; do
      "$bin/lichen-render" "$file-scene.glb" --camera "zoom$zoom" --size "${panel}x${panel}" --frames 8 \
        -o "$file-$zoom.png" --quiet
      panels+=("$file-$zoom.png")
    done
  done
done
montage "${panels[@]}" -tile 6x -geometry +4+4 -background white -quality 82 "$output"
echo "$output"
