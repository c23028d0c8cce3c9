#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puts noises on scenes that Blender exported (tests/scenes/blender) and renders them: a terrain, a
# room, and two heads of which one has no texture coordinates.
#   samples/blender_sheet.sh OUTPUT.jpg
# Needs a release build, a Vulkan device and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg' 1 1 "$@"

output=$1
scenes=$(cd "$(dirname "$0")/../tests/scenes/blender" && pwd)

"$bin/lichen-exemplars" "$work" >/dev/null
for name in granite lichen_on_stone moss rust sand terrazzo; do
  "$bin/lichen" bake "$work/$name.png" -o "$work/$name.glb" --name "$name" --preview none --quiet
done

# put SCENE NOISE MATERIAL OPTION...: the noise replaces the material's texture and its factors.
put() {
  "$bin/lichen" apply "$work/$1.gltf.glb" --noise "$work/$2.glb" --material "$3" --factors one \
    "${@:4}" -o "$work/$1.gltf.glb" --quiet
}
# shot SCENE CAMERA SIZE EXPOSURE
shot() {
  "$bin/lichen-render" "$work/$1.gltf.glb" --camera "$2" --size "$3" --exposure "$4" --frames 32 \
    -o "$work/$1.png" --quiet
}

for scene in terrain interior monkeys; do
  cp "$scenes/$scene.glb" "$work/$scene.gltf.glb"
done
put terrain moss ground --scale 2
put terrain granite rock --mapping triplanar --scale 2
put terrain lichen_on_stone boulder --mapping triplanar --scale 1.5
put interior terrazzo boards --scale 1.5
put interior granite wall --scale 1
put interior lichen_on_stone wood --mapping triplanar --scale 0.5
put monkeys moss fur --mapping triplanar --scale 0.8
put monkeys granite plaster --mapping triplanar --space object --scale 0.8
put monkeys sand floor --mapping triplanar --scale 1.5

shot terrain view 800x400 0
shot interior room 424x340 1
shot monkeys portrait 368x340 0
montage "$work/interior.png" "$work/monkeys.png" -tile 2x1 -geometry +4+4 -background white "$work/lower.png"
convert "$work/terrain.png" "$work/lower.png" -background white -gravity center -append -quality 80 "$output"
echo "$output"
