#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of what the defaults of `lichen bake` mend. Columns: a generated photograph,
# its noise without the step, its noise by default. Rows: uneven light kept and removed, a fold kept
# and filled, borders taken for fitting and blended, a frame kept and cut off.
#   samples/defaults_sheet.sh OUTPUT.jpg
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg' 1 1 "$@"

side=512
"$bin/lichen-test-exemplars" "$work" "$side" photographs >/dev/null
convert "$work/rust-even.png" -shave 8x8 -bordercolor black -border 8 "$work/rust-frame.png"

# noise PHOTOGRAPH OUTPUT OPTION...: bakes with these options, and writes a picture of two tiles.
noise() {
  "$bin/lichen" bake "$1" -o "$work/noise.glb" --preview none --quiet "${@:3}"
  "$bin/lichen" synth "$work/noise.glb" -o "$2" --size "$((2 * side))x$side" --quiet
}

rows=()
# row PHOTOGRAPH OPTION...: adds a row of the sheet.
row() {
  local photograph=$work/$1.png
  noise "$photograph" "$work/$1-without.png" "${@:2}"
  noise "$photograph" "$work/$1-default.png"
  convert "$photograph" "$work/$1-without.png" "$work/$1-default.png" \
    -bordercolor white -border 4 +append "$work/$1-row.png"
  rows+=("$work/$1-row.png")
}

row concrete-vignette-58 --flatten none
row concrete-fold-58 --keep-outliers
row wood_grain-even --periodic yes
row rust-frame --crop "0,0,$side,$side"
convert "${rows[@]}" -append -resize 60% -quality 80 "$1"
