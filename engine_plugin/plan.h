// SPDX-License-Identifier: MIT
// A parsed bundle, as the plan functions and the Vulkan layer see it.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lichen.h>

#include <cstdint>
#include <lichen_interface.h>
#include <vector>

struct LichenBundle_T {
  lichen::Bundle bundle;
  /// Of table i as an image: tables hold 2-D inverse tables, which are 3-D images on the device.
  struct Extent {
    std::uint32_t width = 1, height = 1, depth = 1;
    std::uint32_t dimensionality = 2;
  };
  std::vector<Extent> extents;
  /// maps[n][k]: the constants of map k of noise n.
  std::vector<std::vector<lichen::shader::LichenMap>> maps;
  /// tables[n][k]: the image of that map's inverse table, or one that is not read.
  std::vector<std::vector<std::uint32_t>> tables;
  /// For each material the revision of its noise, at least 1, where that is ignored; else 0.
  std::vector<std::uint32_t> unknownRevisions;
};
