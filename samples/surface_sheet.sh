#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of noises on a scanned shape without texture coordinates, one exemplar per row: a
# texton from the front and from behind, then multiple kernels.
#   samples/surface_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"

panel=400

output=$1
shift
"$bin/lichen-exemplars" "$work" scan >/dev/null

panels=()
for exemplar in "$@"; do
  name=$(basename "${exemplar%.*}")
  for method in texton multiple-kernels; do
    file=$work/$name-$method
    "$bin/lichen" bake "$exemplar" --method "$method" -o "$file.glb" --preview none --quiet
    "$bin/lichen" apply "$work/scan.glb" --noise "$file.glb" --material scan --mapping surface \
      --scale 0.35 -o "$file-scan.glb" --quiet
    for side in front back; do
      "$bin/lichen-render" "$file-scan.glb" --camera "$side" --size "${panel}x${panel}" --frames 4 \
        -o "$file-$side.png" --quiet
      panels+=("$file-$side.png")
    done
  done
done
montage "${panels[@]}" -tile 4x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
