#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of patterns that multiple-kernels noise perturbs. One exemplar per row: a part of it,
# its 60 strongest waves alone, the same with --perturb 0.5 and 1, and noise without a pattern. The
# last row has the colours of the last exemplar, with patterns that no photograph has: dots from a
# picture, rings of a spline, waves, and dots and waves with more noise.
#   samples/pattern_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=320
output=$1
shift
panels=()

# Bakes an exemplar with options, and adds a panel of the noise.
add_noise() {
  local exemplar=$1 picture=$work/panel-${#panels[@]}.png
  shift
  "$bin/lichen" bake "$exemplar" -o "$work/noise.glb" --method multiple-kernels "$@" --preview none --quiet
  "$bin/lichen" synth "$work/noise.glb" --size "$panel" --origin 3,5 -o "$picture" --quiet
  panels+=("$picture")
}

for exemplar in "$@"; do
  convert "$exemplar" -crop "${panel}x$panel+0+0" +repage "$work/panel-${#panels[@]}.png"
  panels+=("$work/panel-${#panels[@]}.png")
  for amount in 0 0.5 1; do
    add_noise "$exemplar" --pattern cosines:60 --perturb "$amount"
  done
  add_noise "$exemplar"
done

convert -size 64x64 xc:white -fill black -draw 'circle 32,32 32,14' -blur 0x3 "$work/dot.png"
add_noise "$exemplar" --pattern "$work/dot.png" --pattern-repeats 8 --perturb 0.5
add_noise "$exemplar" --pattern spline:0:6:0:0.2:1:0.3:0.1:0 --perturb 0.4
add_noise "$exemplar" --pattern wave:5:3,wave:5:-3 --perturb 0.5
add_noise "$exemplar" --pattern "$work/dot.png" --pattern-repeats 8 --perturb 1.5
add_noise "$exemplar" --pattern wave:5:3,wave:5:-3 --perturb 1.5

montage "${panels[@]}" -tile 5x -geometry +4+4 -background white -quality 75 "$output"
echo "$output"
