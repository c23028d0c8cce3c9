#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of local random-phase noise with more and more cosines, one exemplar per two rows: the
# exemplar, texton noise, and noise with 6, 16 and 50 cosines and with a structure; below a part of
# the exemplar and of the last two, magnified 32 times, beside tiling.
#   samples/cosines_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=256 # pixels a side
magnified=32

# add_bake EXEMPLAR OPTION...: bakes it into the next file of bakes[].
add_bake() {
  local exemplar=$1 file=$work/noise-${#bakes[@]}.glb
  shift
  "$bin/lichen" bake "$exemplar" -o "$file" --preview none --quiet "$@"
  bakes+=("$file")
}

# add_panel NOISE TEXELS-PER-TILE: appends a picture of a noise.
add_panel() {
  local file=$work/panel-${#panels[@]}.png
  "$bin/lichen" synth "$1" --texels-per-tile "$2" --size "$panel" --origin 3,5 -o "$file" --quiet
  panels+=("$file")
}

# add_crop EXEMPLAR PIXELS: appends its upper left part, as square pixels.
add_crop() {
  local file=$work/panel-${#panels[@]}.png
  convert "$1" -crop "$2x$2+0+0" +repage -filter point -resize "${panel}x${panel}" "$file"
  panels+=("$file")
}

output=$1
shift
panels=()
for exemplar in "$@"; do
  bakes=()
  width=$(identify -format %w "$exemplar")
  add_bake "$exemplar" --method texton
  for cosines in 6 16 50; do
    add_bake "$exemplar" --method local-random-phase --structure 0 --cosines "$cosines"
  done
  add_bake "$exemplar" --method local-random-phase --structure 0.4
  add_bake "$exemplar" --method tiling
  add_crop "$exemplar" "$panel"
  for file in "${bakes[@]:0:5}"; do
    add_panel "$file" "$width"
  done
  add_crop "$exemplar" "$((panel / magnified))"
  for file in "${bakes[@]:5:1}" "${bakes[@]:3:2}"; do
    add_panel "$file" "$((magnified * width))"
  done
  panels+=(null: null:)
done
montage "${panels[@]}" -tile 6x -geometry "${panel}x${panel}+4+4" -background white -quality 72 "$output"
echo "$output"
