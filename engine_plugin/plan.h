// SPDX-License-Identifier: MIT
// A parsed bundle, as used by the plan functions and the Vulkan layer.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lichen.h>

#include <array>
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
  /// Per table: whether the shader fetches single texels of it only.
  std::vector<bool> fetchedOnly;
  /// Per noise: its block, and the index of the image and the table of each role, or slot of a
  /// layered noise, and of the image of each index map, for quilting first the image of its cells:
  /// of placeholders where the noise lacks them.
  struct NoisePlan {
    lichen::shader::LichenNoiseConstants constants{};
    std::array<std::uint32_t, LICHEN_MAX_MAPS> images{}, tables{};
    std::array<std::uint32_t, LICHEN_MAX_LAYER_NODES> indices{};
    /// LichenNoiseProperties::mappings, and the noises that are its layers and index maps.
    std::uint32_t mappings = 0;
    std::uint32_t layerCount = 0;
    std::array<std::uint32_t, LICHEN_MAX_LAYERS> layers{};
    std::array<std::uint32_t, LICHEN_MAX_LAYER_NODES> indexNoises{};
  };
  std::vector<NoisePlan> noises;
  /// Per material: the revision of its noise, at least 1, if its method or revision is unknown,
  /// else 0.
  std::vector<std::uint32_t> unknownRevisions;
};
