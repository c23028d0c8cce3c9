# SPDX-License-Identifier: MIT
# Sourced by the scripts that make contact sheets: checks their needs and makes a work folder.

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
