#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of noises on a floor that recedes to the horizon, one per row: unfiltered (one
# point per pixel), filtered, and supersampled (64 points per pixel). The floor is oblique to x, y and z.
#   samples/perspective_sheet.sh OUTPUT.jpg EXEMPLAR.png[:METHOD[:MAPPING]]...
# METHOD: tiling or texton (default). MAPPING: uv (default) or triplanar.
# Needs a release build, a Vulkan device and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png[:METHOD[:MAPPING]]...' 2 99 "$@"

width=480
height=300
points=8 # per pixel, along each axis

output=$1
shift

# A floor of 80 x 80 units, one exemplar per unit; the camera is 0.35 above it and looks slightly down.
positions='\x00\x00\x20\xc2\x00\x00\x00\x00\x00\x00\x80\x3f'  # -40 0 1
positions+='\x00\x00\x20\x42\x00\x00\x00\x00\x00\x00\x80\x3f' # 40 0 1
positions+='\x00\x00\x20\xc2\x00\x00\x00\x00\x00\x00\x9e\xc2' # -40 0 -79
positions+='\x00\x00\x20\x42\x00\x00\x00\x00\x00\x00\x9e\xc2' # 40 0 -79
normal='\x00\x00\x00\x00\x00\x00\x80\x3f\x00\x00\x00\x00'
coordinates='\x00\x00\x00\x00\x00\x00\xa0\x42\x00\x00\xa0\x42\x00\x00\xa0\x42'
coordinates+='\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\xa0\x42\x00\x00\x00\x00'
indices='\x00\x00\x01\x00\x02\x00\x02\x00\x01\x00\x03\x00'
printf "$positions$normal$normal$normal$normal$coordinates$indices" >"$work/floor.bin"
cat >"$work/floor.gltf" <<'SCENE'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [2]}],
 "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0.35, 1], "rotation": [-0.13, 0, 0, 0.9915]},
  {"children": [0, 1], "rotation": [0.3015, 0, -0.3015, 0.9045]}],
 "cameras": [{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.01, "zfar": 200}}],
 "materials": [{"name": "floor"}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
   "indices": 3, "material": 0, "mode": 4}]}],
 "buffers": [{"uri": "floor.bin", "byteLength": 140}],
 "bufferViews": [{"buffer": 0, "byteLength": 128}, {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
   "min": [-40, 0, -79], "max": [40, 0, 1]},
  {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"},
  {"bufferView": 0, "byteOffset": 96, "componentType": 5126, "count": 4, "type": "VEC2"},
  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]}
SCENE

panels=()
for row in "$@"; do
  IFS=: read -r exemplar method mapping <<<"$row"
  method=${method:-texton} mapping=${mapping:-uv}
  name=$(basename "${exemplar%.*}")-$method-$mapping
  "$bin/lichen" bake "$exemplar" -o "$work/$name.glb" --name "$name" --method "$method" --preview none --quiet
  "$bin/lichen" apply "$work/floor.gltf" --noise "$work/$name.glb" --material all --mapping "$mapping" \
    -o "$work/scene.glb" --quiet
  shot=("$bin/lichen-render" "$work/scene.glb" --debug-view base-color --frames 1 --quiet)
  "${shot[@]}" --size "${width}x${height}" -o "$work/$name-filtered.png"
  "${shot[@]}" --size "$((width * points))x$((height * points))" -o "$work/$name-fine.png"
  convert "$work/$name-fine.png" -sample "${width}x${height}!" "$work/$name-unfiltered.png"
  # -colorspace RGB: averages light, not sRGB codes.
  convert "$work/$name-fine.png" -colorspace RGB -scale "${width}x${height}!" -colorspace sRGB \
    "$work/$name-supersampled.png"
  for kind in unfiltered filtered supersampled; do
    panels+=("$work/$name-$kind.png")
  done
done
montage "${panels[@]}" -tile 3x -geometry +4+4 -background white -quality 82 "$output"
echo "$output"
