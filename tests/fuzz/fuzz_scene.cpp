// SPDX-License-Identifier: MIT
// Any bytes -> parseScene(): a scene that satisfies the loader's contract, or a one-line error.
// Needs no Vulkan device, only lichen::scene. To run a campaign with Clang:
//   export CC=clang CXX=clang++
//   cmake -B build/fuzz -G Ninja -DLICHEN_FUZZ=ON -DLICHEN_SANITIZE=address,undefined
//   ninja -C build/fuzz fuzz_scene fuzz_scene_replay
//   mkdir corpus && build/fuzz/bin/fuzz_scene_replay corpus corpus
//   build/fuzz/bin/fuzz_scene corpus -timeout=10 -rss_limit_mb=2500 -max_len=120000
// Fixed findings go to tests/fuzz/regressions/scene/.
#include "scene_promises.h"

#include <lichen/escaped.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace lichen;

namespace {

void require(bool condition, const char* what) {
  if (condition)
    return;
  std::fprintf(stderr, "parseScene: %s\n", what);
  std::abort();
}

/// The message may quote the file, escaped.
bool isOneLine(const std::string& text) { return !text.empty() && escaped(text) == text; }

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  // The folder does not exist, so files that the scene refers to are not read.
  const Result<renderer::Scene> scene =
      renderer::parseScene({bytes, bytes + size}, "absent-folder/scene.glb");
  if (!scene) {
    require(isOneLine(scene.error().message), "an error message that is not one line");
    return 0;
  }
  const std::string broken = test::brokenPromise(scene.value());
  require(broken.empty(), broken.c_str());
  for (const std::string& note : scene.value().notes)
    require(isOneLine(note), "a note of more or less than one line");
  return 0;
}
