// SPDX-License-Identifier: MIT
// A parsed bundle, as used by the plan functions and the Vulkan layer.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lichen.h>

#include <cstdint>
#include <lichen_interface.h>
#include <vector>

struct LichenBundle_T {
  lichen::Bundle bundle;
  /// Extent of table i as an image.
  struct Extent {
    std::uint32_t width = 1, height = 1, depth = 1;
    std::uint32_t dimensionality = 2;
  };
  std::vector<Extent> extents;
  /// Per table: whether its image view shows green as alpha.
  std::vector<bool> showsGreenAsAlpha;
  /// maps[n][k]: the shader constants of map k of noise n.
  std::vector<std::vector<lichen::shader::LichenMap>> maps;
  /// tables[n][k]: the image index of that map's inverse table, or of a placeholder that is never
  /// read.
  std::vector<std::vector<std::uint32_t>> tables;
  /// Per material: the revision of its noise, at least 1, if its method or revision is unknown,
  /// else 0.
  std::vector<std::uint32_t> unknownRevisions;
};
