#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Renders a landscape of a million triangles, all triplanar: one exemplar on the ground, the other on
# the rocks and, blended, on their edges. Prints the frame time and the program's memory.
#   samples/landscape_sheet.sh OUTPUT.jpg GROUND.png ROCK.png
# Needs a release build, a Vulkan device, ImageMagick and GNU time (Debian packages imagemagick, time).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg GROUND.png ROCK.png' 3 3 "$@"
[ -x /usr/bin/time ] || { echo "landscape_sheet: install GNU time: apt-get install time" >&2; exit 4; }

output=$1
"$bin/lichen-exemplars" "$work" landscape >/dev/null
"$bin/lichen" bake "$2" -o "$work/ground.glb" --name ground --preview none --quiet
"$bin/lichen" bake "$3" -o "$work/rock.glb" --name rock --preview none --quiet
"$bin/lichen" apply "$work/landscape.glb" --noise "$work/ground.glb" --material ground \
  --mapping triplanar --scale 1.5 -o "$work/half.glb" --quiet
"$bin/lichen" apply "$work/half.glb" --noise "$work/rock.glb" --material rock \
  --mapping triplanar --scale 1.5 -o "$work/most.glb" --quiet
"$bin/lichen" apply "$work/most.glb" --noise "$work/rock.glb" --material "rock edge" \
  --mapping triplanar --scale 1.5 -o "$work/scene.glb" --quiet
/usr/bin/time -f '%M KiB at most' "$bin/lichen-render" "$work/scene.glb" --camera view \
  --size 1600x900 -o "$work/landscape.png" --json
convert "$work/landscape.png" -quality 86 "$output"
echo "$output"
