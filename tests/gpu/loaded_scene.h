// SPDX-License-Identifier: MIT
// A glTF scene of a test, as the renderer reads it from a file.
#pragma once

#include "render_gltf.h"
#include "scene.h"

#include <catch2/catch.hpp>

namespace lichen::test {

inline Result<renderer::Scene> readGltf(const GltfScene& scene) {
  const TemporaryFolder folder;
  return renderer::readScene(writeInto(folder, "scene.glb", scene.glb()));
}

/// Requires that it can be read.
inline renderer::Scene loaded(const GltfScene& scene) {
  Result<renderer::Scene> read = readGltf(scene);
  if (!read)
    FAIL(read.error().message);
  return std::move(read).value();
}

} // namespace lichen::test
