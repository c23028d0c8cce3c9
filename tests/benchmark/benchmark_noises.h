// SPDX-License-Identifier: MIT
// The noises whose shaders lichen-bench times, and how the plugin makes them ready to be drawn.
#pragma once

#include <lichen/tiling.h>

#include <cstddef>
#include <cstdint>
#include <plugin_host.h>
#include <vector>

namespace lichen::bench {

/// A tiling of a generated exemplar as a GLB.
[[nodiscard]] std::vector<std::byte> tilingGlb(GaussianOnly gaussian);
/// Bilinear textons that reach 64 texels, with the default of 30 impacts.
[[nodiscard]] std::vector<std::byte> textonGlb();
/// Local random-phase noise of the exemplar of tilingGlb(), 50 cosines.
/// With this share of structure, and tiles of any offset.
[[nodiscard]] std::vector<std::byte> localRandomPhaseGlb(double structure);
/// Multiple-kernels noise of the exemplar of tilingGlb().
[[nodiscard]] std::vector<std::byte> multipleKernelsGlb();
/// Two tilings with a few patches of each across a tile, as layers.
[[nodiscard]] std::vector<std::byte> layeredGlb();
/// Bricks as local random-phase noise, which is all structure, with a list of offsets.
[[nodiscard]] std::vector<std::byte> bricksGlb();
/// Bricks as a quilting.
[[nodiscard]] std::vector<std::byte> quiltingGlb();
/// A mix with as many steps as `lichen mix` makes from two exemplars. It goes from one to the other
/// over four tiles.
[[nodiscard]] std::vector<std::byte> mixGlb();
/// A tiling of slopes.
[[nodiscard]] std::vector<std::byte> slopeGlb();

/// How a material uses the noise.
struct NoiseUse {
  LichenMapping mapping = LICHEN_MAPPING_UV;
  std::uint32_t tileRotation = 0;
  bool isLayered = false;
};

/// A noise on the device, uploaded and with its material's block written.
class ReadyNoise {
public:
  ReadyNoise(VulkanDevice& gpu, const std::vector<std::byte>& glb, const NoiseUse& use = {});

  [[nodiscard]] VkDescriptorSetLayout layout() const { return host_.context().layout(); }
  [[nodiscard]] VkDescriptorSet set() const { return host_.set(); }

private:
  test::PluginHost host_;
};

} // namespace lichen::bench
