#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of exemplars, one per column: a part of the exemplar, and as much of the noise by each
# method.
#   samples/quilting_sheet.sh OUTPUT.jpg TEXELS METHODS NAME...
# TEXELS: the side of the part. METHODS: with commas between them, such as quilting,tiling.
# NAME: an exemplar of lichen-exemplars, or one of lichen-test-exemplars, such as knit-whole.
# Needs a release build and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg TEXELS METHODS NAME...' 4 99 "$@"

panel=224 # pixels a side

output=$1
texels=$2
IFS=, read -ra methods <<<"$3"
shift 3
for name in "$@"; do
  case $name in
    *-*) "$bin/lichen-test-exemplars" "$work" 512 "$name" ;;
    *) "$bin/lichen-exemplars" "$work" "$name" >/dev/null ;;
  esac
done
panels=()
for method in exemplar "${methods[@]}"; do
  for name in "$@"; do
    picture=$work/panel-${#panels[@]}.png
    if [ "$method" = exemplar ]; then
      convert "$work/$name.png" -crop "${texels}x$texels+0+0" +repage "$picture"
    else
      "$bin/lichen" bake "$work/$name.png" -o "$work/noise.glb" --method "$method" --preview none --quiet
      "$bin/lichen" synth "$work/noise.glb" -o "$picture" --size "$texels" --origin 3,5 --quiet
    fi
    # -colorspace RGB: averages light, not sRGB codes.
    convert "$picture" -colorspace RGB -filter Box -resize "${panel}x$panel" -colorspace sRGB "$picture"
    panels+=("$picture")
  done
done
montage "${panels[@]}" -tile "$#x" -geometry +3+3 -background white -quality 70 "$output"
echo "$output"
