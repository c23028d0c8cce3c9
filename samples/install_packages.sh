# SPDX-License-Identifier: MIT
# Sourced by quickstart.sh and tests/run.sh: installs Debian packages, prints steps and failures.

# Needed to build. Catch2 is only a header; with it the same build folder can add the tests later.
build_packages=(
  cmake ninja-build g++ pkg-config
  catch2 glslang-tools libcli11-dev libeigen3-dev libexif-dev libfftw3-dev libfmt-dev libglfw3-dev
  libglm-dev libjpeg-dev libkissfft-dev libnanoflann-dev libopenexr-dev libpng-dev libtbb-dev
  libvulkan-dev libvulkan-volk-dev mesa-vulkan-drivers nlohmann-json3-dev
  spirv-tools)
test_packages=(assimp-testmodels ccache libx11-dev spirv-cross vulkan-validationlayers xvfb)

step() { printf '\n== %s\n' "$1"; }

# die REASON CURE
die() {
  printf '\n%s: %s\n%s\n' "$(basename "$0")" "$1" "$2" >&2
  exit 1
}

# install_packages PACKAGE...: installs those that are missing, as root or with sudo.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system. Lichen needs the content of these Debian packages; install it yourself: $*"
    return
  fi
  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
      missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    return
  fi

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null ||
      die "packages are missing, and this user is not root and has no sudo" \
          "Run as root: apt-get update && apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing Debian packages: ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c \
    'apt-get -q -o Acquire::Retries=3 update &&
     apt-get -q -o Acquire::Retries=3 install -y --no-install-recommends "$@"' sh "${missing[@]}" ||
    die "apt-get failed" \
        "Read its message above. Lichen needs the packages of Debian 12 and a network to get them."
}

# install_node: installs node and npm unless npm is there; Debian's npm does not work with another node.
install_node() {
  if ! command -v npm >/dev/null; then
    install_packages ca-certificates nodejs npm
  fi
}
