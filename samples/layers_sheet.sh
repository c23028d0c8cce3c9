#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of layers, one row an exemplar: the exemplar, one noise of it by tiling, two
# layers by tiling, two layers of multiple kernels that perturb the exemplar's waves, and two layers of
# multiple kernels in a solid, on a torus that has no texture coordinates.
#   samples/layers_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build, a Vulkan device, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"
command -v python3 >/dev/null || { echo "layers_sheet: install Python: apt-get install python3" >&2; exit 4; }

panel=360
tile=1.6 # metres; the torus is 2 wide

output=$1
shift

python3 - "$work/torus.gltf" <<'TORUS'
import base64, json, math, struct, sys
rings, sides, radius, tube = 160, 80, 0.68, 0.32
points, normals, indices = [], [], []
for i in range(rings + 1):
    for j in range(sides + 1):
        a, b = 2 * math.pi * i / rings, 2 * math.pi * j / sides
        n = (math.cos(b) * math.cos(a), math.sin(b), math.cos(b) * math.sin(a))
        points.append((radius * math.cos(a) + tube * n[0], tube * n[1], radius * math.sin(a) + tube * n[2]))
        normals.append(n)
for i in range(rings):
    for j in range(sides):
        a, b = i * (sides + 1) + j, (i + 1) * (sides + 1) + j
        indices += [a, a + 1, b, a + 1, b + 1, b]
data = b"".join(struct.pack("<3f", *p) for p in points + normals)
data += struct.pack(f"<{len(indices)}H", *indices)
size = 12 * len(points)
pitch, distance = math.radians(-40), 4.2
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"camera": 0,
                            "translation": [0, -distance * math.sin(pitch), distance * math.cos(pitch)],
                            "rotation": [math.sin(pitch / 2), 0, 0, math.cos(pitch / 2)]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.55, "znear": 0.1}}],
    "materials": [{"name": "torus", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.7}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0}]}],
    "buffers": [{"byteLength": len(data),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": 2 * size},
                    {"buffer": 0, "byteOffset": 2 * size, "byteLength": 2 * len(indices)}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
         "min": [-1, -tube, -1], "max": [1, tube, 1]},
        {"bufferView": 0, "byteOffset": size, "componentType": 5126, "count": len(points), "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}]},
    open(sys.argv[1], "w"))
TORUS

panels=()
for exemplar in "$@"; do
  file=$work/${#panels[@]}
  convert "$exemplar" -resize "${panel}x${panel}!" "$file-exemplar.png"
  "$bin/lichen" bake "$exemplar" -o "$file-one.glb" --preview none --quiet
  "$bin/lichen" bake "$exemplar" -o "$file-two.glb" --layers 2 --preview none --quiet
  "$bin/lichen" bake "$exemplar" -o "$file-solid.glb" --layers 2 --method multiple-kernels --preview none --quiet
  "$bin/lichen" bake "$exemplar" -o "$file-perturbed.glb" --layers 2 --method multiple-kernels \
    --pattern cosines:60 --perturb 0.5 --preview none --quiet
  for noise in one two perturbed; do
    "$bin/lichen" synth "$file-$noise.glb" -o "$file-$noise.png" --size "$panel" --texels-per-tile "$panel" --quiet
  done
  "$bin/lichen" apply "$work/torus.gltf" --noise "$file-solid.glb" --material all --mapping solid --scale "$tile" \
    -o "$file-scene.glb" --quiet
  "$bin/lichen-render" "$file-scene.glb" --size "${panel}x${panel}" --frames 8 -o "$file-torus.png" --quiet
  panels+=("$file-exemplar.png" "$file-one.png" "$file-two.png" "$file-perturbed.png" "$file-torus.png")
done
montage "${panels[@]}" -tile 5x -geometry +4+4 -background white -quality 82 "$output"
echo "$output"
