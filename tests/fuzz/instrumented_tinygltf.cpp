// SPDX-License-Identifier: MIT
// tinygltf compiled with the fuzzer's sanitizers: Debian's library has none, and the linker prefers
// this copy. Omits its image loader, which the renderer replaces.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <nlohmann/json.hpp>
#define TINYGLTF_NO_INCLUDE_JSON
#include <tiny_gltf.h>
