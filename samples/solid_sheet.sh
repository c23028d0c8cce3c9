#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of noise in a solid: a bowl that is turned from a block of each exemplar. It
# has no texture coordinates. Upper row: local random phase; lower row: multiple kernels.
#   samples/solid_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build, a Vulkan device, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"
command -v python3 >/dev/null || { echo "solid_sheet: install Python: apt-get install python3" >&2; exit 4; }

panel=440
tile=1.2 # metres; the bowl is 2 wide

output=$1
shift

python3 - "$work/bowl.gltf" <<'BOWL'
import base64, json, math, struct, sys
columns = 160
# From the foot outside over the rim to the bottom inside: (radius, height), closed by a flat foot.
outside = [(0.42 + 0.58 * math.sin(t) ** 0.8, 0.9 - 0.9 * math.cos(t))
           for t in (math.pi / 2 * i / 60 for i in range(61))]
rim = [(0.95 + 0.05 * math.cos(t), 0.9 + 0.05 * math.sin(t)) for t in (math.pi * i / 12 for i in range(1, 12))]
inside = [(0.9 * math.cos(t), 0.9 - 0.78 * math.sin(t)) for t in (math.pi / 2 * i / 60 for i in range(61))]
profile = [(0.0, 0.0), (0.42, 0.0)] + outside + rim + inside
def normal(i):
    a, b = profile[max(i - 1, 0)], profile[min(i + 1, len(profile) - 1)]
    along = (b[0] - a[0], b[1] - a[1])
    length = math.hypot(*along) or 1.0
    return along[1] / length, -along[0] / length
points, normals, indices = [], [], []
for i, (radius, height) in enumerate(profile):
    out, up = (0.0, -1.0) if i < 2 else normal(i)
    for j in range(columns + 1):
        c, s = math.cos(2 * math.pi * j / columns), math.sin(2 * math.pi * j / columns)
        points.append((radius * c, height, radius * s))
        normals.append((out * c, up, out * s))
for i in range(len(profile) - 1):
    for j in range(columns):
        a, b = i * (columns + 1) + j, (i + 1) * (columns + 1) + j
        indices += [a, b, a + 1, a + 1, b, b + 1]
data = b"".join(struct.pack("<3f", *p) for p in points + normals)
data += struct.pack(f"<{len(indices)}H", *indices)
size = 12 * len(points)
pitch, distance = math.radians(-38), 4.6
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"camera": 0,
                            "translation": [0, 0.42 - distance * math.sin(pitch), distance * math.cos(pitch)],
                            "rotation": [math.sin(pitch / 2), 0, 0, math.cos(pitch / 2)]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
    "materials": [{"name": "bowl", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0}]}],
    "buffers": [{"byteLength": len(data),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": 2 * size},
                    {"buffer": 0, "byteOffset": 2 * size, "byteLength": 2 * len(indices)}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
         "min": [-1, 0, -1], "max": [1, 0.95, 1]},
        {"bufferView": 0, "byteOffset": size, "componentType": 5126, "count": len(points), "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}]},
    open(sys.argv[1], "w"))
BOWL

panels=()
for method in 'local-random-phase --structure 0' multiple-kernels; do
  for exemplar in "$@"; do
    file=$work/bowl-${#panels[@]}
    # shellcheck disable=SC2086 # a method and its options
    "$bin/lichen" bake "$exemplar" -o "$file.glb" --method $method --preview none --quiet
    "$bin/lichen" apply "$work/bowl.gltf" --noise "$file.glb" --material all --mapping solid --scale "$tile" \
      --rotation 90 -o "$file-scene.glb" --quiet
    "$bin/lichen-render" "$file-scene.glb" --size "${panel}x${panel}" --frames 8 -o "$file.png" --quiet
    panels+=("$file.png")
  done
done
montage "${panels[@]}" -tile "${#}x" -geometry +4+4 -background white -quality 85 "$output"
echo "$output"
