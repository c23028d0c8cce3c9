#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Renders a set of maps as noise: rusted sheet metal whose remains of paint are smooth. The maps come
# from a generated exemplar: normals and occlusion from its lightness, roughness from its hue. On the
# right the maps: base colour, normals, roughness.
#   samples/material_sheet.sh OUTPUT.jpg
# Needs a release build, a Vulkan device, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg' 1 1 "$@"
command -v python3 >/dev/null || { echo "material_sheet: install Python: apt-get install python3" >&2; exit 4; }

output=$1
width=780 # of the picture, in pixels
height=500
mkdir "$work/rust"
"$bin/lichen-exemplars" "$work" rust >/dev/null
cp "$work/rust.png" "$work/rust/rust_color.png"
convert "$work/rust.png" -depth 8 "$work/rust.ppm"

python3 - "$work/rust.ppm" "$work/rust" <<'PYTHON'
import math, re, sys

RELIEF = 7.0  # pixels from black to white
with open(sys.argv[1], "rb") as file:
    data = file.read()
header = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
side, data = int(header[1]), data[header.end():]


def smoothed(values, radius):
    """A box filter along both axes of a tile that repeats."""
    for _ in range(2):
        rows = [values[y * side:(y + 1) * side] for y in range(side)]
        mean = [[sum(row[(x + d) % side] for d in range(-radius, radius + 1)) / (2 * radius + 1)
                 for row in rows] for x in range(side)]
        values = [value for column in mean for value in column]
    return values


colors = [[channel / 255 for channel in data[3 * i:3 * i + 3]] for i in range(side * side)]
light = smoothed([0.3 * r + 0.6 * g + 0.1 * b for r, g, b in colors], 1)
around = smoothed(light, 8)
# Paint is as blue as red, rust is not.
paint = smoothed([min(1.0, max(0.0, 2.5 * (b / max(r, 0.02) - 0.45))) for r, g, b in colors], 1)


def write(name, kind, pixels):
    with open(f"{sys.argv[2]}/{name}.ppm", "wb") as file:
        file.write(b"P%d %d %d 255\n" % (kind, side, side) + bytes(pixels))


normal = bytearray()
for y in range(side):
    for x in range(side):
        right = RELIEF * (light[y * side + (x + 1) % side] - light[y * side + x - 1]) / 2
        down = RELIEF * (light[(y + 1) % side * side + x] - light[(y - 1) * side + x]) / 2
        length = math.sqrt(right * right + down * down + 1)
        normal += bytes(round(127.5 + 127.5 * part / length) for part in (-right, down, 1))
write("rust_normal_gl", 6, normal)
write("rust_roughness", 5, (round(255 * (0.85 - 0.6 * p)) for p in paint))
write("rust_ao", 5, (round(255 * min(1.0, max(0.3, 1 - 2.5 * (a - l)))) for a, l in zip(around, light)))
PYTHON
for map in normal_gl roughness ao; do
  convert "$work/rust/rust_$map.ppm" "$work/rust/rust_$map.png"
  rm "$work/rust/rust_$map.ppm"
done

# One exemplar spans three times as much as in the preview, so that the relief shows.
"$bin/lichen" bake "$work/rust" -o "$work/material.glb" --name rust --quiet
"$bin/lichen" apply "$work/material.glb" --noise "$work/material.glb" --material rust --scale 3 \
  -o "$work/scene.glb" --quiet
"$bin/lichen-render" "$work/scene.glb" --size "${width}x${height}" --frames 32 -o "$work/scene.png" --quiet
third=$(((height - 8) / 3))
for map in color normal_gl roughness; do
  convert "$work/rust/rust_$map.png" -resize "${third}x${third}!" "$work/$map.png"
done
montage "$work/color.png" "$work/normal_gl.png" "$work/roughness.png" -tile 1x -geometry +0+2 \
  -background white "$work/maps.png"
montage "$work/scene.png" "$work/maps.png" -tile 2x1 -geometry +2+0 -background white -quality 80 "$output"
echo "$output"
