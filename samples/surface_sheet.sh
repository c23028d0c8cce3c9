#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of textons on a scanned shape without texture coordinates, one exemplar per row, from
# the front and from behind.
#   samples/surface_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=512

output=$1
shift
"$bin/lichen-exemplars" "$work" scan >/dev/null

panels=()
for exemplar in "$@"; do
  name=$(basename "${exemplar%.*}")
  "$bin/lichen" bake "$exemplar" --method texton -o "$work/$name.glb" --preview none --quiet
  "$bin/lichen" apply "$work/scan.glb" --noise "$work/$name.glb" --material scan --mapping surface \
    --scale 0.35 -o "$work/scan_$name.glb" --quiet
  for side in front back; do
    "$bin/lichen-render" "$work/scan_$name.glb" --camera "$side" --size "${panel}x${panel}" --frames 4 \
      -o "$work/$name-$side.png" >/dev/null
    panels+=("$work/$name-$side.png")
  done
done
montage "${panels[@]}" -tile 2x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
