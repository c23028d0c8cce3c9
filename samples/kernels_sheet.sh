#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of multiple-kernels noise with given spectra and the colours of an exemplar, one
# spectrum per row: a ring, an ellipse, three lobes, a painted cross, and one in colours. The columns
# are the picture of the spectrum, the kernels gabor, sinc and gaussian-sinc, and 50 cosines of local
# random phase.
#   samples/kernels_sheet.sh OUTPUT.jpg EXEMPLAR.png
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png' 2 2 "$@"

panel=320
painted() { convert -size 129x129 xc:black "$@"; }
painted -fill white -draw 'circle 64,64 64,92' -fill black -draw 'circle 64,64 64,89' "$work/ring.png"
painted -fill white -draw 'ellipse 64,64 30,10 0,360' "$work/ellipse.png"
painted -fill white -draw 'circle 84,64 84,69 circle 74,82 74,87 circle 54,82 54,87' -blur 0x2 "$work/lobes.png"
painted -fill white -draw 'rectangle 84,58 94,70 rectangle 58,84 70,94' "$work/cross.png"
painted -fill '#ff8040' -draw 'circle 64,64 64,74' -fill '#2040ff' -draw 'rectangle 96,62 112,66' \
  -draw 'rectangle 62,96 66,112' "$work/colors.png"

panels=()
for spectrum in ring ellipse lobes cross colors; do
  convert "$work/$spectrum.png" -filter point -resize "${panel}x$panel" "$work/panel-${#panels[@]}.png"
  panels+=("$work/panel-${#panels[@]}.png")
  for options in '--kernel gabor' '--kernel sinc --max-kernels 25 --kernel-impacts 150' \
    '--kernel gaussian-sinc --max-kernels 25 --kernel-impacts 150' \
    '--method local-random-phase'; do
    method=--method=multiple-kernels
    [[ $options == *--method* ]] && method=
    picture=$work/panel-${#panels[@]}.png
    # shellcheck disable=SC2086 # options and an absent method are words
    "$bin/lichen" bake "$2" $method $options --spectrum "$work/$spectrum.png" -o "$work/noise.glb" \
      --preview none --quiet
    "$bin/lichen" synth "$work/noise.glb" --texels-per-tile "$panel" --size "$panel" -o "$picture" --quiet
    panels+=("$picture")
  done
done
montage "${panels[@]}" -tile 5x -geometry +4+4 -background white -quality 75 "$1"
echo "$1"
