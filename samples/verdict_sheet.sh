#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of the sixty generated photographs, and of the middle square of any others
# given, each beside its noise as `lichen bake` makes it by default, in a border of the verdict's
# colour: green (good), orange (acceptable) or red (unsuitable). Prints the verdicts.
#   samples/verdict_sheet.sh OUTPUT.jpg [PHOTOGRAPH]...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg [PHOTOGRAPH]...' 1 1000 "$@"
output=$1
shift

side=512
"$bin/lichen-test-exemplars" "$work" "$side" photographs >/dev/null
photographs=("$work"/*.png)
for photograph in "$@"; do
  square=$work/${photograph//\//_}
  convert "$photograph" -resize "${side}x$side^" -gravity center -extent "${side}x$side" "png:$square"
  photographs+=("$square")
done

panels=()
for photograph in "${photographs[@]}"; do
  name=$(basename "${photograph%.*}")
  verdict=$("$bin/lichen" bake "$photograph" -o "$work/noise.glb" --preview none | grep '^verdict')
  echo "$name: $verdict"
  case $verdict in
    "verdict: good"*) color=green3 ;;
    "verdict: acceptable"*) color=orange ;;
    *) color=red ;;
  esac
  "$bin/lichen" synth "$work/noise.glb" -o "$work/noise.png" --size "$((2 * side))x$side" --quiet
  panel=$work/panels/$name.png
  mkdir -p "$work/panels"
  convert "$photograph" -background white -gravity east -splice 16x0 "$work/noise.png" +append \
    -resize 25% -bordercolor "$color" -border 3 "$panel"
  panels+=("$panel")
done
montage "${panels[@]}" -tile 5x -geometry +3+3 -background white -quality 75 "$output"
