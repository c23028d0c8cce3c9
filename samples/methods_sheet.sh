#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of exemplars under the methods, one exemplar per row: a part of it, and as much
# of the noise by each method.
#   samples/methods_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=224 # pixels a side
output=$1
shift
panels=()
for exemplar in "$@"; do
  convert "$exemplar" -crop "${panel}x$panel+0+0" +repage "$work/panel-${#panels[@]}.png"
  panels+=("$work/panel-${#panels[@]}.png")
  for method in tiling quilting texton local-random-phase multiple-kernels; do
    "$bin/lichen" bake "$exemplar" -o "$work/noise.glb" --method "$method" --preview none --quiet
    picture=$work/panel-${#panels[@]}.png
    "$bin/lichen" synth "$work/noise.glb" --size "$panel" --origin 3,5 -o "$picture" --quiet
    panels+=("$picture")
  done
done
montage "${panels[@]}" -tile 6x -geometry "${panel}x${panel}+4+4" -background white -quality 70 "$output"
echo "$output"
