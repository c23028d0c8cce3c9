#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Contact sheet of what suits and what does not, one picture a column: the exemplar, its noise, and
# its noise with --flatten auto.
#   samples/suitability_sheet.sh OUTPUT.jpg
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail

here=$(cd "$(dirname "$0")/.." && pwd)
programs=${LICHEN_BIN:-$here/build/release/bin}
names="granite bricks paving text sloping_light carpet one_stone"
panel=256

if [ $# -ne 1 ]; then
  echo "usage: samples/suitability_sheet.sh OUTPUT.jpg" >&2
  exit 2
fi
command -v montage >/dev/null || { echo "suitability_sheet: install ImageMagick: apt-get install imagemagick" >&2; exit 4; }
[ -x "$programs/lichen" ] || { echo "suitability_sheet: $programs/lichen is missing: build it with samples/quickstart.sh" >&2; exit 4; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck disable=SC2086
"$programs/lichen-exemplars" "$work" --size "$panel" $names >"$work/list"

for name in $names; do
  for flatten in none auto; do
    "$programs/lichen" bake "$work/$name.png" -o "$work/noise.glb" --preview none --quiet --flatten "$flatten"
    "$programs/lichen" synth "$work/noise.glb" -o "$work/$name-$flatten.png" --size "$((2 * panel))" --quiet
  done
done
panels=()
for name in $names; do panels+=("$work/$name.png"); done
for name in $names; do panels+=("$work/$name-none.png"); done
for name in $names; do panels+=("$work/$name-auto.png"); done
montage "${panels[@]}" -tile 7x3 -geometry 220x220+3+3 -background white -quality 82 "$1"
echo "$1"
