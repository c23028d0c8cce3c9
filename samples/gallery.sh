#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/gallery, whose README.md says what they show.
#   samples/gallery.sh [-o FOLDER] [PICTURE...]
# FOLDER: out/gallery by default. PICTURE: a name such as moss or wall; all of them by default.
# Needs a release build with the target lichen-test-exemplars (in the folder LICHEN_BIN,
# build/release/bin by default), a Vulkan device, and the Debian packages imagemagick and python3.
set -euo pipefail

all=(granite lichen_on_stone moss rust sand terrazzo front suitability defaults methods quilting
  quilting_limits wall street rotation triplanar perspective landscape blender surface mix structure cosines
  kernels patterns layers solid)

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=${LICHEN_BIN:-$root/build/release/bin}
folder=$root/out/gallery
if [ "${1:-}" = -o ] && [ $# -ge 2 ]; then
  folder=$2
  shift 2
fi
for picture in "$@"; do
  [[ " ${all[*]} " == *" $picture "* ]] ||
    { printf 'usage: samples/gallery.sh [-o FOLDER] [PICTURE...]\nPICTURE: %s\n' "${all[*]}" >&2; exit 2; }
done
for program in montage python3 "$bin"/lichen "$bin"/lichen-{render,exemplars,test-exemplars}; do
  command -v "$program" >/dev/null ||
    { echo "gallery: $program is missing: apt-get install imagemagick python3, samples/quickstart.sh, and cmake --build --preset release --target lichen-test-exemplars" >&2; exit 4; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$folder"

# Steps. Those that draw append a file to panels[]. An exemplar is a name of lichen-exemplars, one of
# lichen-test-exemplars, or the name of a .png file in $work.

# generate NAME...: writes exemplars or meshes into $work.
generate() {
  local name
  for name in "$@"; do
    case $name in
      *-* | carpet | landscape | one_stone | paving | planks | sloping_light | text | weave | wood)
        "$bin/lichen-test-exemplars" "$work" 512 "$name" >/dev/null ;;
      *) "$bin/lichen-exemplars" "$work" "$name" >/dev/null ;;
    esac
  done
}

# file_of EXEMPLAR: prints its file or folder.
file_of() {
  local file=$work/$1
  [[ $1 == *-maps ]] || file+=.png
  [ -e "$file" ] || generate "$1"
  echo "$file"
}

# bake EXEMPLAR OPTION...: writes $work/noise.glb.
bake() { "$bin/lichen" bake "$(file_of "$1")" -o "$work/noise.glb" --preview none --quiet "${@:2}"; }

# next: sets `panel`, a file for one more panel.
next() {
  panel=$work/panel-${#panels[@]}.png
  panels+=("$panel")
}

# synth OPTION...: draws noise.glb.
synth() { next && "$bin/lichen" synth "$work/noise.glb" -o "$panel" --quiet "$@"; }

# part EXEMPLAR SIDE: draws its upper left part.
part() { next && convert "$(file_of "$1")" -crop "$2x$2+0+0" +repage "$panel"; }

# shrink FROM GEOMETRY TO: averages light, not sRGB codes.
shrink() { convert "$1" -colorspace RGB -filter Box -resize "$2" -colorspace sRGB "$3"; }

# scene SHAPE [NORMAL]: writes $work/scene.glb.
scene() { python3 "$root/samples/gallery_scene.py" "$work/scene.glb" "$@"; }

# put MATERIAL OPTION...: puts noise.glb on a material of scene.glb.
put() {
  "$bin/lichen" apply "$work/scene.glb" --noise "$work/noise.glb" --material "$1" "${@:2}" \
    -o "$work/scene.glb" --quiet
}

# render OPTION...: renders scene.glb.
render() { next && "$bin/lichen-render" "$work/scene.glb" -o "$panel" --quiet "$@"; }

# sheet COLUMNS MARGIN QUALITY: puts the panels together.
sheet() {
  montage "${panels[@]}" -tile "$1" -geometry "+$2+$2" -background white -quality "$3" "$output"
  panels=()
}

# columns TEXELS METHODS EXEMPLAR...: an exemplar per column, its part above noises of the methods.
columns() {
  local method exemplar
  for method in exemplar $2; do
    for exemplar in "${@:3}"; do
      if [ "$method" = exemplar ]; then
        part "$exemplar" "$1"
      else
        bake "$exemplar" --method "$method"
        synth --size "$1" --origin 3,5
      fi
      shrink "$panel" 224x224 "$panel"
    done
  done
  sheet "$(($# - 2))x" 3 70
}

# mended EXEMPLAR OPTION...: a photograph, its noise with options that switch a step off, and without.
mended() {
  local options
  part "$1" 512
  for options in "${*:2}" ''; do
    # shellcheck disable=SC2086 # options are words
    bake "$1" $options
    synth --size 1024x512
  done
}

draw() {
  local exemplar method options texels plane view kind
  case $1 in
    granite | lichen_on_stone | moss | rust | sand | terrazzo)
      bake "$1"
      for texels in 256 64 16; do
        shrink "$(file_of "$1")" "${texels}x$texels!" "$work/tile.png"
        next && convert -size 480x480 "tile:$work/tile.png" "$panel"
      done
      for texels in 256 64 16; do synth --size 480 --texels-per-tile "$texels"; done
      sheet 3x2 4 88 ;;

    front)
      "$bin/lichen" bake "$(file_of rust)" -o "$work/scene.glb" --quiet
      render --size 1280x800
      convert "$panel" \( "$(file_of rust)" -resize 280x280 -bordercolor '#fcf7e6' -border 5 \) \
        -geometry +28+28 -composite -quality 90 "$output" ;;

    suitability)
      local names=(granite bricks paving text sloping_light carpet one_stone)
      "$bin/lichen-exemplars" "$work" --size 256 granite bricks >/dev/null
      "$bin/lichen-test-exemplars" "$work" 256 "${names[@]:2}" >/dev/null
      for exemplar in "${names[@]}"; do part "$exemplar" 256; done
      for options in none auto; do
        for exemplar in "${names[@]}"; do
          bake "$exemplar" --method tiling --flatten "$options"
          synth --size 512
        done
      done
      mogrify -resize 220x220 "${panels[@]}"
      sheet 7x3 3 82 ;;

    defaults)
      "$bin/lichen-test-exemplars" "$work" 512 photographs >/dev/null
      convert "$(file_of rust-even)" -shave 8x8 -bordercolor black -border 8 "$work/framed.png"
      mended concrete-vignette-58 --flatten none
      mended concrete-fold-58 --keep-outliers
      mended wood_grain-even --periodic yes
      mended framed --crop 0,0,512,512
      mogrify -resize 60% "${panels[@]}"
      sheet 3x 3 80 ;;

    methods)
      for exemplar in granite moss rust bricks; do
        part "$exemplar" 224
        for method in tiling quilting texton local-random-phase multiple-kernels; do
          bake "$exemplar" --method "$method"
          synth --size 224 --origin 3,5
        done
      done
      sheet 6x 4 70 ;;

    quilting)
      columns 448 'quilting tiling' floor-whole cobbles-whole knit-whole basket-whole herringbone-whole ;;

    quilting_limits)
      columns 336 quilting bond-irregular-15 floor-even shingles-irregular-15 cobbles-irregular-15 text wood ;;

    wall)
      file_of bond-whole >/dev/null
      scene wall
      local shots=('close --size 360x240' 'middle --size 360x240' 'whole --size 1096x87')
      for method in repeated tiling quilting; do
        if [ "$method" != repeated ]; then
          bake bond-whole --method "$method"
          put all --factors one --scale 1
        fi
        # shellcheck disable=SC2086 # a camera and an option
        for view in "${shots[@]}"; do render --debug-view base-color --camera $view; done
      done
      montage "${panels[@]:0:1}" "${panels[@]:3:1}" "${panels[@]:6:1}" "${panels[@]:1:1}" \
        "${panels[@]:4:1}" "${panels[@]:7:1}" -tile 3x -geometry +4+4 "$work/upper.png"
      panels=("$work/upper.png" "${panels[@]:2:1}" "${panels[@]:5:1}" "${panels[@]:8:1}")
      convert "${panels[0]}" \( "${panels[@]:1}" -bordercolor white -border 4 \) -append -quality 70 "$output" ;;

    street)
      scene street
      bake bond-whole-maps --method quilting
      put wall --scale 1.35 --factors one
      bake cobbles-whole-maps --method quilting
      put street --scale 1.6 --factors one
      render --size 900x500 --frames 32 --exposure -0.2
      montage "$work"/{bond,cobbles}-whole-maps/{color,normal_gl,height}.png -tile 6x1 -resize 146x146 \
        -geometry +2+2 "$work/maps.png"
      convert "$panel" "$work/maps.png" -background white -gravity center -append -quality 70 "$output" ;;

    rotation)
      bake terrazzo
      for options in none 2 4; do synth --size 384 --texels-per-tile 192 --tile-rotation "$options"; done
      mkdir "$work/relief-maps"
      cp "$(file_of cobbles-whole-maps)/normal_gl.png" "$work/relief-maps"
      bake relief-maps --method tiling
      for options in none 2 4; do
        synth --map normal --size 384 --texels-per-tile 192 --tile-rotation "$options"
        # Lambert's law, light from the upper left: (-1, 1, 1) in tangent space. The matrix scales by
        # 0.6 so that nothing clips.
        convert "$panel" -color-matrix '-0.693 0.693 0.693  -0.693 0.693 0.693  -0.693 0.693 0.693' \
          -evaluate subtract 34.6% -evaluate multiply 1.4 "$panel"
      done
      sheet 3x 3 85 ;;

    triplanar) # one plane; three averaged: the average of each plane's ball by the weights; Lichen's
      for exemplar in lichen_on_stone rust; do
        bake "$exemplar"
        for plane in 'x 1 0 0' 'y 0 1 0' 'z 0 0 1' ball; do
          kind=${plane#ball}
          # shellcheck disable=SC2086 # with a normal, a ball shows only one plane
          scene ball ${kind:2}
          put all --mapping triplanar --scale 0.8 --plane-sharpness 4
          for view in base-color planes; do
            "$bin/lichen-render" "$work/scene.glb" --debug-view "$view" --size 420x420 --frames 4 \
              -o "$work/${plane%% *}-$view.exr" --quiet
          done
        done
        # An average needs weights, not their squares, that sum to 1. No step exceeds 1, where images clip.
        convert "$work/ball-planes.exr" -evaluate Pow 0.5 "$work/weights.exr"
        convert "$work/weights.exr" -separate -evaluate-sequence Mean "$work/mean.exr"
        for plane in x:R y:G z:B; do
          convert "$work/weights.exr" -channel "${plane#*:}" -separate +channel -evaluate Divide 3 \
            "$work/mean.exr" -compose DivideSrc -composite "$work/${plane%:*}-base-color.exr" \
            -compose Multiply -composite "$work/part-${plane%:*}.exr"
        done
        convert "$work"/part-[xyz].exr -evaluate-sequence Add "$work/averaged-base-color.exr"
        for kind in z averaged ball; do
          next && convert "$work/$kind-base-color.exr" -colorspace sRGB "$panel"
        done
      done
      sheet 3x 4 88 ;;

    perspective) # one point per pixel, filtered, 64 points per pixel
      for options in 'moss texton uv' 'rust texton uv' 'moss tiling uv' 'rust tiling triplanar'; do
        read -r exemplar method kind <<<"$options"
        bake "$exemplar" --method "$method"
        scene floor
        put all --mapping "$kind"
        "$bin/lichen-render" "$work/scene.glb" --debug-view base-color --frames 1 --size 3840x2400 \
          -o "$work/fine.png" --quiet
        next && convert "$work/fine.png" -sample '480x300!' "$panel"
        render --debug-view base-color --frames 1 --size 480x300
        next && shrink "$work/fine.png" '480x300!' "$panel"
      done
      sheet 3x 4 82 ;;

    landscape)
      generate landscape
      mv "$work/landscape.glb" "$work/scene.glb"
      bake moss
      put ground --mapping triplanar --scale 1.5
      bake granite
      put rock --mapping triplanar --scale 1.5
      put 'rock edge' --mapping triplanar --scale 1.5
      render --camera view --size 1600x900
      convert "$panel" -quality 86 "$output" ;;

    blender)
      # SCENE EXEMPLAR MATERIAL OPTION..., and SCENE shot OPTION...
      while read -r kind exemplar options; do
        [ -e "$work/$kind.glb" ] || cp "$root/tests/scenes/blender/$kind.glb" "$work"
        cp "$work/$kind.glb" "$work/scene.glb"
        # shellcheck disable=SC2086 # a material and options
        if [ "$exemplar" = shot ]; then
          render --frames 32 $options
        else
          bake "$exemplar" --name "$exemplar"
          put $options --factors one
          mv "$work/scene.glb" "$work/$kind.glb"
        fi
      done <<'ROWS'
terrain moss ground --scale 2
terrain granite rock --mapping triplanar --scale 2
terrain lichen_on_stone boulder --mapping triplanar --scale 1.5
terrain shot --camera view --size 800x400
interior terrazzo boards --scale 1.5
interior granite wall --scale 1
interior lichen_on_stone wood --mapping triplanar --scale 0.5
interior shot --camera room --size 424x340 --exposure 1
monkeys moss fur --mapping triplanar --scale 0.8
monkeys granite plaster --mapping triplanar --space object --scale 0.8
monkeys sand floor --mapping triplanar --scale 1.5
monkeys shot --camera portrait --size 368x340
ROWS
      montage "${panels[@]:1}" -tile 2x1 -geometry +4+4 "$work/lower.png"
      convert "${panels[0]}" "$work/lower.png" -background white -gravity center -append -quality 80 "$output" ;;

    surface)
      generate scan
      for exemplar in moss rust; do
        for method in texton multiple-kernels; do
          cp "$work/scan.glb" "$work/scene.glb"
          bake "$exemplar" --method "$method"
          put scan --mapping surface --scale 0.35
          for view in front back; do render --camera "$view" --size 400x400 --frames 4; done
        done
      done
      sheet 4x 4 88 ;;

    mix)
      generate terrain
      mv "$work/terrain.glb" "$work/scene.glb"
      "$bin/lichen" mix "$(file_of moss)" "$(file_of sand)" -o "$work/noise.glb" --preview none --quiet
      # One exemplar spans a twelfth of the ground, a metre.
      put terrain --scale 0.0833 --mix-texture "$work/terrain_mask.png"
      render --camera view --size 960x640 --frames 8
      synth --size 960x320 --texels-per-tile 256
      sheet 1x 4 88 ;;

    structure)
      for exemplar in bricks weave wood rust; do
        part "$exemplar" 256
        for options in 'local-random-phase --structure '{0,0.1,0.3,1} tiling; do
          # shellcheck disable=SC2086 # a method and an option
          bake "$exemplar" --method $options
          synth --size 512
          convert "$panel" -crop 256x256+128+128 +repage "$panel"
        done
      done
      sheet 6x 4 70 ;;

    cosines) # below, magnified 32 times
      for exemplar in wood moss rust; do
        local magnified=()
        part "$exemplar" 256
        for options in texton 'local-random-phase --structure 0 --cosines '{6,16,50} \
          'local-random-phase --structure 0.4' tiling; do
          # shellcheck disable=SC2086 # a method and options
          bake "$exemplar" --method $options
          [ "$options" = tiling ] || synth --size 256 --texels-per-tile 512 --origin 3,5
          "$bin/lichen" synth "$work/noise.glb" --size 256 --texels-per-tile 16384 --origin 3,5 \
            -o "$work/${#panels[@]}-near.png" --quiet
          magnified+=("$work/${#panels[@]}-near.png")
        done
        part "$exemplar" 8
        convert "$panel" -filter point -resize 256x256 "$panel"
        panels+=("${magnified[@]:5}" "${magnified[@]:3:2}" null: null:)
      done
      sheet 6x 4 72 ;;

    kernels)
      local black=(-size 129x129 xc:black)
      convert "${black[@]}" -fill white -draw 'circle 64,64 64,92' -fill black -draw 'circle 64,64 64,89' \
        "$work/ring.png"
      convert "${black[@]}" -fill white -draw 'ellipse 64,64 30,10 0,360' "$work/ellipse.png"
      convert "${black[@]}" -fill white -draw 'circle 84,64 84,69 circle 74,82 74,87 circle 54,82 54,87' \
        -blur 0x2 "$work/lobes.png"
      convert "${black[@]}" -fill white -draw 'rectangle 84,58 94,70 rectangle 58,84 70,94' "$work/cross.png"
      convert "${black[@]}" -fill '#ff8040' -draw 'circle 64,64 64,74' -fill '#2040ff' \
        -draw 'rectangle 96,62 112,66' -draw 'rectangle 62,96 66,112' "$work/colors.png"
      for kind in ring ellipse lobes cross colors; do
        next && convert "$work/$kind.png" -filter point -resize 320x320 "$panel"
        for options in 'multiple-kernels --kernel gabor' \
          'multiple-kernels --max-kernels 25 --impacts 150 --kernel '{sinc,gaussian-sinc} \
          local-random-phase; do
          # shellcheck disable=SC2086 # a method and options
          bake rust --spectrum "$work/$kind.png" --method $options
          synth --texels-per-tile 320 --size 320
        done
      done
      sheet 5x 4 75 ;;

    patterns)
      convert -size 64x64 xc:white -fill black -draw 'circle 32,32 32,14' -blur 0x3 "$work/dot.png"
      local dots="--pattern $work/dot.png:8" waves='--pattern wave:5:3,wave:5:-3'
      local perturbed=('--pattern cosines:60 --perturb '{0,0.5,1} '')
      local given=("$dots --perturb 0.5" '--pattern spline:0:6:0:0.2:1:0.3:0.1:0 --perturb 0.4'
        "$waves --perturb 0.5" "$dots --perturb 1.5" "$waves --perturb 1.5")
      for exemplar in weave bricks terrazzo; do
        part "$exemplar" 320
        [ "$exemplar" != terrazzo ] || perturbed+=("${given[@]}")
        for options in "${perturbed[@]}"; do
          # shellcheck disable=SC2086 # options are words
          bake "$exemplar" --method multiple-kernels $options
          synth --size 320 --origin 3,5
        done
      done
      sheet 5x 4 75 ;;

    layers)
      for exemplar in lichen_on_stone rust terrazzo; do
        next && convert "$(file_of "$exemplar")" -resize '360x360!' "$panel"
        for options in '' '--layers 2' \
          '--layers 2 --method multiple-kernels --pattern cosines:60 --perturb 0.5'; do
          # shellcheck disable=SC2086 # options are words
          bake "$exemplar" $options
          synth --size 360 --texels-per-tile 360
        done
        bake "$exemplar" --layers 2 --method multiple-kernels
        scene torus
        put all --mapping solid --scale 1.6
        render --size 360x360 --frames 8
      done
      sheet 5x 4 82 ;;

    solid)
      for method in 'local-random-phase --structure 0' multiple-kernels; do
        for exemplar in wood granite terrazzo; do
          # shellcheck disable=SC2086 # a method and its option
          bake "$exemplar" --method $method
          scene bowl
          put all --mapping solid --scale 1.2 --rotation 90
          render --size 440x440 --frames 8
        done
      done
      sheet 3x 4 85 ;;
  esac
}

[ $# -gt 0 ] || set -- "${all[@]}"
for picture in "$@"; do
  panels=()
  output=$folder/$picture.jpg
  draw "$picture"
  rm -rf "${work:?}"/*
  echo "$output"
done
