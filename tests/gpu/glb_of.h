// SPDX-License-Identifier: MIT
// The bytes of a bundle that a test made.
#pragma once

#include <lichen/bundle_writer.h>

#include <stdexcept>
#include <vector>

namespace lichen::test {

/// Throws std::runtime_error with the writer's message.
[[nodiscard]] inline std::vector<std::byte> glbOf(const BundleFile& file) {
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  if (!glb)
    throw std::runtime_error(glb.error().message);
  return std::move(glb).value();
}

} // namespace lichen::test
