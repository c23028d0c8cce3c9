// SPDX-License-Identifier: MIT
#include "shader_frames.h"

#include "rows.h"

#include <cstdio>
#include <stdexcept>
#include <utility>

namespace lichen::bench {
namespace {

constexpr int kFrames = 31;
/// A pipeline's first draws compile it.
constexpr int kWarmUpFrames = 3;

template <class Value>
Value take(Result<Value> result) {
  if (!result)
    throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

} // namespace

Screen::Screen() : gpu_(take(VulkanDevice::create({}))) {
  DeviceImageInfo info;
  info.format = kScreenFormat;
  info.extent = {kScreenWidth, kScreenHeight, 1};
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  image_ = take(gpu_->createImage(info));
}

std::string Screen::note() const {
  return std::string(gpu_->properties().deviceName) + "; medians of " + std::to_string(kFrames);
}

std::vector<double> frameSeconds(const Screen& screen, std::span<const Drawn> shaders,
                                 const ScreenView& view) {
  std::vector<std::vector<double>> seconds(shaders.size());
  for (int frame = -kWarmUpFrames; frame < kFrames; ++frame)
    for (std::size_t i = 0; i < shaders.size(); ++i) {
      const double time = shaders[i].pass.draw(screen.image(), shaders[i].set, view);
      if (frame >= 0)
        seconds[i].push_back(time);
    }
  std::vector<double> medians;
  for (std::vector<double>& times : seconds)
    medians.push_back(median(std::move(times)));
  return medians;
}

std::array<double, 3> meanDrawn(const Screen& screen, Drawn shader, const ScreenView& view) {
  constexpr std::size_t kTexelBytes = 4; // kScreenFormat
  (void)shader.pass.draw(screen.image(), shader.set, view);
  const std::vector<std::byte> texels = take(screen.gpu().readImage(
      screen.image(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, kTexelBytes));
  std::array<double, 3> mean{};
  for (std::size_t i = 0; i < texels.size(); i += kTexelBytes)
    for (std::size_t c = 0; c < mean.size(); ++c)
      mean[c] += double(texels[i + c]) / 255.0;
  for (double& channel : mean)
    channel /= double(texels.size() / kTexelBytes);
  return mean;
}

} // namespace lichen::bench
