#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of the kinds of inverse table, one exemplar per row: the exemplar, and the
# noise with a joint table, and with none (blank where the colours span fewer than three
# dimensions). The last two rows are the first exemplar in grey and in two colours.
#   samples/table_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=192

output=$1
shift

convert "$1" -colorspace Gray "PNG24:$work/grey.png"
convert "$1" -colorspace Gray -threshold 45% -colorspace sRGB -type TrueColor +level-colors "#40342a","#c8b48a" "PNG24:$work/two.png"

noise() { # EXEMPLAR PANEL [OPTION OF BAKE...]
  "$bin/lichen" bake "$1" -o "$work/noise.glb" --name noise --preview none --quiet "${@:3}" &&
    "$bin/lichen" synth "$work/noise.glb" -o "$2" --size "${panel}x${panel}" --quiet
}

panels=()
for exemplar in "$@" "$work/grey.png" "$work/two.png"; do
  row=$work/${#panels[@]}
  convert "$exemplar" -crop "${panel}x${panel}+0+0" +repage "$row-exemplar.png"
  noise "$exemplar" "$row-joint.png" --gaussian no
  noise "$exemplar" "$row-none.png" --gaussian yes 2>/dev/null ||
    convert -size "${panel}x${panel}" xc:white "$row-none.png"
  panels+=("$row-exemplar.png" "$row-joint.png" "$row-none.png")
done
montage "${panels[@]}" -tile 3x -geometry +3+3 -background white -quality 78 "$output"
echo "$output"
