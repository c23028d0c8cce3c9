#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet per exemplar: repetition (upper row) and noise (lower row) at three distances.
#   samples/gallery.sh OUTPUT_FOLDER EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT_FOLDER EXEMPLAR.png...' 2 99 "$@"

panel=480
distances="256 64 16" # pixels across one exemplar

output=$1
shift
mkdir -p "$output"

for exemplar in "$@"; do
  name=$(basename "${exemplar%.*}")
  [ "$name" = base_color ] && name=$(basename "$(dirname "$exemplar")")
  "$bin/lichen" bake "$exemplar" -o "$work/$name.glb" --name "$name" --preview none
  panels=()
  for texels in $distances; do
    # -colorspace RGB: averages light, not sRGB codes.
    convert "$exemplar" -colorspace RGB -filter Box -resize "${texels}x${texels}!" -colorspace sRGB \
      "$work/tile.png"
    convert -size "${panel}x${panel}" "tile:$work/tile.png" "$work/repeated-$texels.png"
    panels+=("$work/repeated-$texels.png")
  done
  for texels in $distances; do
    "$bin/lichen" synth "$work/$name.glb" -o "$work/noise-$texels.png" --size "${panel}x${panel}" \
      --texels-per-tile "$texels" --quiet
    panels+=("$work/noise-$texels.png")
  done
  montage "${panels[@]}" -tile 3x2 -geometry +4+4 -background white -quality 88 "$output/$name.jpg"
  echo "$output/$name.jpg"
done
