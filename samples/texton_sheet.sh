#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet, one exemplar per row: the photograph repeated, its Gaussian version (random
# phases), and the texton noise, as the bake's report shows them.
#   samples/texton_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=320 # pixels a side

output=$1
shift

panels=()
for exemplar in "$@"; do
  bake_textons "$exemplar"
  for picture in Exemplar "Gaussian version" Result; do
    report_picture "$picture" "$work/whole.png"
    # Repeats an exemplar that is smaller than the panel.
    convert -size "${panel}x${panel}" "tile:$work/whole.png" "$work/$name-$picture.png"
    panels+=("$work/$name-$picture.png")
  done
done
montage "${panels[@]}" -tile 3x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
