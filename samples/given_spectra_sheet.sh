#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of local random-phase noise with given spectra and the colours of an exemplar: a ring,
# two rings, a band along one direction, a ring with a band, two crossed bands, and a painted cross.
#   samples/given_spectra_sheet.sh OUTPUT.jpg EXEMPLAR.png
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png' 2 2 "$@"

convert -size 129x129 xc:black -stroke white -strokewidth 3 -draw 'line 24,24 104,104 line 24,104 104,24' \
  -fill black -stroke none -draw 'circle 64,64 64,80' "$work/painted.png"

panels=()
for spectrum in ring:24:27 ring:5:7,ring:40:46 band:10:14:-3:3 ring:30:34,band:4:6:-2:2 \
  band:18:20:-1:1,band:-1:1:18:20 "$work/painted.png"; do
  file=$work/panel-${#panels[@]}
  "$bin/lichen" bake "$2" --method local-random-phase --cosines 16 --spectrum "$spectrum" -o "$file.glb" \
    --preview none --quiet
  "$bin/lichen" synth "$file.glb" --texels-per-tile 320 --size 320 -o "$file.png" --quiet
  panels+=("$file.png")
done
montage "${panels[@]}" -tile 3x -geometry +4+4 -background white -quality 75 "$1"
echo "$1"
