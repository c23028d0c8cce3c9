#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A terrain whose mask mixes two exemplars: the first where it is flat, the second where it is
# steep; below it the ramp from one to the other.
#   samples/mix_sheet.sh OUTPUT.jpg EXEMPLAR.png EXEMPLAR.png
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail

here=$(cd "$(dirname "$0")/.." && pwd)
bin=${LICHEN_BIN:-$here/build/release/bin}

if [ $# -ne 3 ]; then
  echo "usage: samples/mix_sheet.sh OUTPUT.jpg EXEMPLAR.png EXEMPLAR.png" >&2
  exit 2
fi
command -v montage >/dev/null || { echo "mix_sheet: install ImageMagick: apt-get install imagemagick" >&2; exit 4; }
[ -x "$bin/lichen" ] || { echo "mix_sheet: $bin/lichen is missing: build it with samples/quickstart.sh" >&2; exit 4; }

output=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$bin/lichen-exemplars" "$work" terrain >/dev/null
"$bin/lichen" mix "$2" "$3" -o "$work/mix.glb" --preview none --quiet
# An exemplar on a twelfth of the ground: a metre.
"$bin/lichen" apply "$work/terrain.glb" --noise "$work/mix.glb" --material terrain --scale 0.0833 \
  --mix-texture "$work/terrain_mask.png" -o "$work/mixed.glb" --quiet
"$bin/lichen-render" "$work/mixed.glb" --camera view --size 960x640 --frames 8 -o "$work/terrain.png" \
  >/dev/null
"$bin/lichen" synth "$work/mix.glb" -o "$work/ramp.png" --size 960x320 --texels-per-tile 256 --quiet
montage "$work/terrain.png" "$work/ramp.png" -tile 1x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
