#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of tile rotation; columns: none, half turns, quarter turns. Upper row: the
# exemplar's colours, two tiles wide. Lower row: generated bumps lit from the upper left; they must
# look lit from there in every tile.
#   samples/rotation_sheet.sh OUTPUT.jpg EXEMPLAR.png
# Needs a release build, ImageMagick (Debian package imagemagick) and Python.
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png' 2 2 "$@"

panel=384
output=$1
mkdir "$work/bumps"

# Bumps that change under a half turn: round, with a notch on the right.
python3 - >"$work/bumps.ppm" <<'PYTHON'
import math
import random
import sys

side, count = 256, 16
random.seed(7)
height = [[0.0] * side for _ in range(side)]
for _ in range(count):
    radius, left, top = random.uniform(16, 26), random.randrange(side), random.randrange(side)
    reach = int(radius) + 1
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            squared = (dx * dx + dy * dy) / radius**2
            if squared >= 1:
                continue
            bump = 0.8 * radius * (1 - squared) ** 2
            from_notch = ((dx - 0.4 * radius) ** 2 + dy * dy) / (0.22 * radius) ** 2
            row, column = (top + dy) % side, (left + dx) % side
            bump -= 0.6 * radius * math.exp(-from_notch) * (1 - squared) ** 2
            height[row][column] = max(height[row][column], bump)
pixels = bytearray()
for y in range(side):
    for x in range(side):
        right = (height[y][(x + 1) % side] - height[y][x - 1]) / 2
        down = (height[(y + 1) % side][x] - height[y - 1][x]) / 2
        length = math.sqrt(right * right + down * down + 1)
        pixels += bytes(round(127.5 + 127.5 * part / length) for part in (-right, down, 1))
sys.stdout.buffer.write(b"P6 %d %d 255\n" % (side, side) + pixels)
PYTHON
convert "$work/bumps.ppm" "$work/bumps/bumps_normal_gl.png"

"$bin/lichen" bake "$2" -o "$work/colours.glb" --name colours --preview none --quiet
"$bin/lichen" bake "$work/bumps" -o "$work/bumps.glb" --name bumps --preview none --quiet
panels=()
for angles in none 2 4; do
  "$bin/lichen" synth "$work/colours.glb" -o "$work/colours-$angles.png" --size "$panel" \
    --texels-per-tile $((panel / 2)) --tile-rotation "$angles" --quiet
  panels+=("$work/colours-$angles.png")
done
for angles in none 2 4; do
  "$bin/lichen" synth "$work/bumps.glb" --map normal -o "$work/normal-$angles.png" --size "$panel" \
    --texels-per-tile $((panel / 2)) --tile-rotation "$angles" --quiet
  # Lambert's law, light from the upper left: (-1, 1, 1) in tangent space. The matrix scales by 0.6
  # so that nothing clips.
  convert "$work/normal-$angles.png" \
    -color-matrix '-0.693 0.693 0.693  -0.693 0.693 0.693  -0.693 0.693 0.693' \
    -evaluate subtract 34.6% -evaluate multiply 1.4 "$work/lit-$angles.png"
  panels+=("$work/lit-$angles.png")
done
montage "${panels[@]}" -tile 3x -geometry +3+3 -background white -quality 85 "$output"
echo "$output"
