# SPDX-License-Identifier: MIT
# Sourced by the scripts that make contact sheets: checks their needs, makes a work folder, and takes
# pictures out of bake reports.

# begin_sheet USAGE LEAST MOST ARGUMENT...: exits unless there are LEAST to MOST arguments,
# ImageMagick and a release build. Sets bin, the folder of the programs (LICHEN_BIN overrides it),
# and work, a folder that is removed at exit.
begin_sheet() {
  local usage=$1 least=$2 most=$3 name program
  name=$(basename "$0" .sh)
  shift 3
  if [ $# -lt "$least" ] || [ $# -gt "$most" ]; then
    echo "usage: samples/$name.sh $usage" >&2
    exit 2
  fi
  command -v montage >/dev/null || { echo "$name: install ImageMagick: apt-get install imagemagick" >&2; exit 4; }
  bin=${LICHEN_BIN:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build/release/bin}
  for program in lichen lichen-render lichen-exemplars; do
    [ -x "$bin/$program" ] || { echo "$name: $bin/$program is missing: build it with samples/quickstart.sh" >&2; exit 4; }
  done
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
}

# bake_textons EXEMPLAR: bakes it as textons. Sets name, and writes $work/$name.glb and .html.
bake_textons() {
  name=$(basename "${1%.*}")
  "$bin/lichen" bake "$1" --method texton -o "$work/$name.glb" --report "$work/$name.html" \
    --preview none --quiet
}

# report_picture TITLE OUTPUT.png: writes the first picture with this title in $work/$name.html.
report_picture() {
  grep -o "<img alt=\"$1\" src=\"data:image/png;base64,[^\"]*" "$work/$name.html" | head -n 1 |
    sed 's/.*base64,//' | base64 -d >"$2"
}
