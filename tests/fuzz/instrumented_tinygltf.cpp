// SPDX-License-Identifier: MIT
// tinygltf compiled with the fuzzer's sanitizers: Debian's library has none, and this one comes
// before it. Its image loader is replaced by the renderer and so left out.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <nlohmann/json.hpp>
#define TINYGLTF_NO_INCLUDE_JSON
#include <tiny_gltf.h>
