#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of the quality levels of tiling, two rows per exemplar; columns: three taps,
# three taps with blend sharpness 4, two taps, one tap. Upper row: half a tile, enlarged. Lower row: a
# far view, 1/16 tile per pixel, enlarged; there one tap starts at that pixel size.
#   samples/taps_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=256
far=64 # pixels a side of a far view, each enlarged to panel / far
farPixels=16 # pixels per tile in a far view

output=$1
shift
panels=()
for exemplar in "$@"; do
  name=$(basename "${exemplar%.*}")
  "$bin/lichen" bake "$exemplar" -o "$work/$name.glb" --name noise --preview none --quiet
  view() { # PANEL [OPTION OF SYNTH...]
    "$bin/lichen" synth "$work/$name.glb" -o "$@" --quiet
    mogrify -filter point -resize "${panel}x${panel}" "$1"
    panels+=("$1")
  }
  near=(--size "$panel" --texels-per-tile 512)
  distant=(--size "$far" --texels-per-tile "$farPixels")
  view "$work/$name-three.png" "${near[@]}"
  view "$work/$name-sharp.png" "${near[@]}" --sharpness 4
  view "$work/$name-two.png" "${near[@]}" --taps 2
  view "$work/$name-one.png" "${near[@]}" --one-tap 0.001
  view "$work/$name-three-far.png" "${distant[@]}"
  view "$work/$name-sharp-far.png" "${distant[@]}" --sharpness 4
  view "$work/$name-two-far.png" "${distant[@]}" --taps 2
  view "$work/$name-one-far.png" "${distant[@]}" --taps 2 --one-tap 0.0625
done
montage "${panels[@]}" -tile 4x -geometry +3+3 -background white -quality 82 "$output"
echo "$output"
