#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of local random-phase noise with more and more structure, one exemplar per row: the
# exemplar, noise with --structure 0, 0.1, 0.3 and 1, and tiling.
#   samples/structure_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=256 # pixels a side, of twice as many

# add_panel EXEMPLAR OPTION...: bakes it and appends a picture of its noise.
add_panel() {
  local exemplar=$1 file
  shift
  file=$work/panel-${#panels[@]}
  "$bin/lichen" bake "$exemplar" -o "$file.glb" --preview none --quiet "$@"
  "$bin/lichen" synth "$file.glb" -o "$file.png" --size "$((2 * panel))" --quiet
  convert "$file.png" -crop "${panel}x${panel}+128+128" +repage "$file.png"
  panels+=("$file.png")
}

output=$1
shift
panels=()
for exemplar in "$@"; do
  crop=$work/exemplar-${#panels[@]}.png
  convert "$exemplar" -crop "${panel}x${panel}+0+0" +repage "$crop"
  panels+=("$crop")
  for structure in 0 0.1 0.3 1; do
    add_panel "$exemplar" --method local-random-phase --structure "$structure"
  done
  add_panel "$exemplar" --method tiling
done
montage "${panels[@]}" -tile 6x -geometry +4+4 -background white -quality 70 "$output"
echo "$output"
