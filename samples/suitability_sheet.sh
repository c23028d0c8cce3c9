#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of exemplars that suit tiling and that do not, one per column: the exemplar,
# its noise by tiling with --flatten none, and with --flatten auto.
#   samples/suitability_sheet.sh OUTPUT.jpg
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg' 1 1 "$@"

names="granite bricks paving text sloping_light carpet one_stone"
panel=256

# shellcheck disable=SC2086
"$bin/lichen-exemplars" "$work" --size "$panel" $names >"$work/list"

for name in $names; do
  for flatten in none auto; do
    "$bin/lichen" bake "$work/$name.png" -o "$work/noise.glb" --method tiling --preview none --quiet \
      --flatten "$flatten"
    "$bin/lichen" synth "$work/noise.glb" -o "$work/$name-$flatten.png" --size "$((2 * panel))" --quiet
  done
done
panels=()
for name in $names; do panels+=("$work/$name.png"); done
for name in $names; do panels+=("$work/$name-none.png"); done
for name in $names; do panels+=("$work/$name-auto.png"); done
montage "${panels[@]}" -tile 7x3 -geometry 220x220+3+3 -background white -quality 82 "$1"
echo "$1"
