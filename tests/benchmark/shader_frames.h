// SPDX-License-Identifier: MIT
// Times shaders by frames that they draw in turn, so that a change in the machine's speed affects
// all of them alike.
#pragma once

#include "screen_pass.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lichen::bench {

inline constexpr std::uint32_t kScreenWidth = 1920;
inline constexpr std::uint32_t kScreenHeight = 1080;
/// The side of the exemplars that the shaders read.
inline constexpr int kShaderExemplarSide = 256;

/// One texel per pixel.
inline constexpr ScreenView kFlat{float(kScreenWidth) / kShaderExemplarSide,
                                  float(kScreenHeight) / kShaderExemplarSide, 1.0f};
/// A floor with 1/4 of a texel per pixel at the near edge; the far edge is 16 times as far.
inline constexpr ScreenView kFloor{0.25f * kFlat.uvPerScreenX, 0.25f * kFlat.uvPerScreenX, 16.0f};

/// A device and the image that all shaders draw into.
class Screen {
public:
  /// Throws std::runtime_error with the device's message.
  Screen();

  [[nodiscard]] VulkanDevice& gpu() const { return *gpu_; }
  [[nodiscard]] const DeviceImage& image() const { return image_; }
  /// The device's name and the number of frames, for notes.
  [[nodiscard]] std::string note() const;

private:
  std::unique_ptr<VulkanDevice> gpu_;
  DeviceImage image_;
};

/// A shader and the set that it reads.
struct Drawn {
  ScreenPass& pass;
  VkDescriptorSet set;
};

/// Draws each shader once per round, and returns the median time of each in seconds.
[[nodiscard]] std::vector<double> frameSeconds(const Screen& screen, std::span<const Drawn> shaders,
                                               const ScreenView& view);

/// The mean of the red, green and blue that a shader draws.
[[nodiscard]] std::array<double, 3> meanDrawn(const Screen& screen, Drawn shader,
                                              const ScreenView& view);

} // namespace lichen::bench
