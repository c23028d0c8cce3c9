#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a contact sheet of three mappings of a ball, one exemplar per row: one plane, which smears on
# the sides; three planes averaged, the usual triplanar mapping, which loses contrast between the
# planes; and Lichen's blend, which keeps the histogram.
#   samples/triplanar_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build, a Vulkan device, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"
command -v python3 >/dev/null || { echo "triplanar_sheet: install Python: apt-get install python3" >&2; exit 4; }

panel=420
rings=64
tile=0.8     # metres; the ball's radius is 1
sharpness=4

output=$1
shift

# A ball, and the same ball with one plane's normal at every vertex, which shows only that plane.
python3 - "$work" "$rings" <<'BALL'
import base64, json, math, struct, sys
folder, rings = sys.argv[1], int(sys.argv[2])
columns = 2 * rings
points = [(math.sin(t) * math.sin(p), math.cos(t), math.sin(t) * math.cos(p))
          for t in (math.pi * i / rings for i in range(rings + 1))
          for p in (2 * math.pi * j / columns for j in range(columns + 1))]
indices = []
for i in range(rings):
    for j in range(columns):
        a, b = i * (columns + 1) + j, (i + 1) * (columns + 1) + j
        indices += [a, b, a + 1, a + 1, b, b + 1]
for name, normal in (("ball", None), ("x", (1, 0, 0)), ("y", (0, 1, 0)), ("z", (0, 0, 1))):
    data = b"".join(struct.pack("<3f", *p) for p in points)
    data += b"".join(struct.pack("<3f", *(normal or p)) for p in points)
    data += struct.pack(f"<{len(indices)}H", *indices)
    size = 12 * len(points)
    # The camera looks from above and aside. The ball is not rotated: the planes are in world space.
    yaw, pitch, distance = math.radians(40), math.radians(-25), 4.4
    away = (math.sin(yaw) * math.cos(pitch), -math.sin(pitch), math.cos(yaw) * math.cos(pitch))
    cy, sy, cp, sp = (f(a / 2) for a in (yaw, pitch) for f in (math.cos, math.sin))
    json.dump({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"camera": 0, "translation": [distance * k for k in away],
                                "rotation": [cy * sp, sy * cp, -sy * sp, cy * cp]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
        "materials": [{"name": "ball", "pbrMetallicRoughness": {"metallicFactor": 0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2,
                                    "material": 0}]}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64,"
                     + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 2 * size},
                        {"buffer": 0, "byteOffset": 2 * size, "byteLength": 2 * len(indices)}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
             "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 0, "byteOffset": size, "componentType": 5126, "count": len(points),
             "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}]},
        open(f"{folder}/{name}.gltf", "w"))
BALL

# shot BALL VIEW OUT: renders linear light.
shot() {
  "$bin/lichen-render" "$work/$1-scene.glb" --debug-view "$2" --size "${panel}x${panel}" --frames 4 \
    -o "$work/$3.exr" --quiet
}

panels=()
for exemplar in "$@"; do
  "$bin/lichen" bake "$exemplar" -o "$work/noise.glb" --name noise --preview none --quiet
  for ball in ball x y z; do
    "$bin/lichen" apply "$work/$ball.gltf" --noise "$work/noise.glb" --material all --mapping triplanar \
      --scale "$tile" --plane-sharpness "$sharpness" -o "$work/$ball-scene.glb" --quiet
    shot "$ball" base-color "$ball"
  done
  shot ball planes squares
  # An average needs weights, not their squares, that sum to 1. No step exceeds 1, where images clip.
  convert "$work/squares.exr" -evaluate Pow 0.5 "$work/weights.exr"
  convert "$work/weights.exr" -separate -evaluate-sequence Mean "$work/mean.exr"
  blended=()
  for plane in x:R y:G z:B; do
    part=$work/part-${plane%:*}.exr
    convert "$work/weights.exr" -channel "${plane#*:}" -separate +channel -evaluate Divide 3 \
      "$work/mean.exr" -compose DivideSrc -composite "$work/${plane%:*}.exr" -compose Multiply \
      -composite "$part"
    blended+=("$part")
  done
  convert "${blended[@]}" -evaluate-sequence Add "$work/averaged.exr"
  for kind in z averaged ball; do
    convert "$work/$kind.exr" -colorspace sRGB "$work/panel-$kind.png"
    panels+=("$(mktemp "$work/XXXXXX.png")")
    mv "$work/panel-$kind.png" "${panels[-1]}"
  done
done
montage "${panels[@]}" -tile 3x -geometry +4+4 -background white -quality 88 "$output"
echo "$output"
