#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# samples/quickstart.sh [PHOTOGRAPH]
# Takes a bare Debian 12 to pictures of a material that never repeats: installs missing packages,
# builds, bakes PHOTOGRAPH (default: a generated example) and renders it.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/samples/install_packages.sh"
out=$root/out/quickstart

case ${1:-} in
  '') photograph= ;;
  -h | --help)
    echo "usage: $0 [PHOTOGRAPH]    a PNG, JPEG or EXR image of a material"
    exit ;;
  *)
    [[ -f $1 ]] || die "$1: no such file" "Give a PNG, JPEG or EXR image, or no argument for an example."
    photograph=$(realpath "$1") ;;
esac

step 'Packages'
install_packages "${build_packages[@]}"

step 'Build (minutes the first time)'
cd "$root"
{ cmake --preset release && cmake --build --preset release --target lichen lichen-exemplars lichen-render; } ||
  die 'the build failed' 'Read the reason above. If build/ comes from another checkout, remove it and try again.'
export PATH=$root/build/release/bin:$PATH
mkdir -p "$out"

step 'Exemplar'
if [[ -z $photograph ]]; then
  lichen-exemplars "$out" lichen_on_stone
  photograph=$out/lichen_on_stone.png
fi
name=$(basename "${photograph%.*}")

step 'Bake'
lichen bake "$photograph" -o "$out/$name.glb"

step 'Render'
lichen-render "$out/$name.glb" -o "$out/${name}_scene.png"
lichen synth "$out/$name.glb" --size 2048x2048 -o "$out/${name}_flat.png"

step 'Done'
cat <<END
exemplar: $photograph
pictures: $out/${name}_scene.png
          $out/${name}_flat.png
scene:    $out/$name.glb (other glTF viewers show it with a repeating texture)
Next:     README.md, docs/baking.md
END
