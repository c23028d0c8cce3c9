#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet: a terrain whose mask mixes two exemplars, the first on flat ground and the second on
# steep ground, and below it the ramp from one to the other.
#   samples/mix_sheet.sh OUTPUT.jpg EXEMPLAR.png EXEMPLAR.png
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png EXEMPLAR.png' 3 3 "$@"

output=$1
"$bin/lichen-exemplars" "$work" terrain >/dev/null
"$bin/lichen" mix "$2" "$3" -o "$work/mix.glb" --preview none --quiet
# One exemplar spans a twelfth of the ground, a metre.
"$bin/lichen" apply "$work/terrain.glb" --noise "$work/mix.glb" --material terrain --scale 0.0833 \
  --mix-texture "$work/terrain_mask.png" -o "$work/mixed.glb" --quiet
"$bin/lichen-render" "$work/mixed.glb" --camera view --size 960x640 --frames 8 -o "$work/terrain.png" \
  >/dev/null
"$bin/lichen" synth "$work/mix.glb" -o "$work/ramp.png" --size 960x320 --texels-per-tile 256 --quiet
montage "$work/terrain.png" "$work/ramp.png" -tile 1x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
