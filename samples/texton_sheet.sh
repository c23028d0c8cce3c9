#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A row for each exemplar: the photograph repeated, its Gaussian version by random phases, and the
# texton noise, as the report of a bake shows them.
#   samples/texton_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail

here=$(cd "$(dirname "$0")/.." && pwd)
bin=${LICHEN_BIN:-$here/build/release/bin}
panel=320 # pixels of a picture's side that are shown

if [ $# -lt 2 ]; then
  echo "usage: samples/texton_sheet.sh OUTPUT.jpg EXEMPLAR.png..." >&2
  exit 2
fi
command -v montage >/dev/null || { echo "texton_sheet: install ImageMagick: apt-get install imagemagick" >&2; exit 4; }
[ -x "$bin/lichen" ] || { echo "texton_sheet: $bin/lichen is missing: build it with samples/quickstart.sh" >&2; exit 4; }

output=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

panels=()
for exemplar in "$@"; do
  name=$(basename "${exemplar%.*}")
  "$bin/lichen" bake "$exemplar" --method texton -o "$work/$name.glb" --report "$work/$name.html" \
    --preview none --quiet
  for picture in exemplar gaussian result; do
    grep -o "\"$picture\":{\"png\":\"data:image/png;base64,[^\"]*" "$work/$name.html" | head -n 1 |
      sed 's/.*base64,//' | base64 -d >"$work/whole.png"
    # Of the exemplar, which may be smaller, as much repetition as the noise shows.
    convert -size "${panel}x${panel}" "tile:$work/whole.png" "$work/$name-$picture.png"
    panels+=("$work/$name-$picture.png")
  done
done
montage "${panels[@]}" -tile 3x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
