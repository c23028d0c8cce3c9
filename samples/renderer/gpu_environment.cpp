// SPDX-License-Identifier: MIT
// Environment -> panorama, cube maps and BRDF table on the device, as half floats.
#include "gpu_environment.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>

namespace lichen::renderer {
namespace {

constexpr float kHalfMax = 65504.0f;

/// Appends RGB as RGBA16F, a format that every device can filter.
void appendHalf(std::vector<glm::u16vec4>& out, glm::vec3 light) {
  out.push_back(glm::packHalf(glm::vec4(glm::min(light, kHalfMax), 1.0f)));
}

DeviceImageInfo halfImage(std::uint32_t width, std::uint32_t height) {
  DeviceImageInfo info;
  info.format = VK_FORMAT_R16G16B16A16_SFLOAT;
  info.extent = {width, height, 1};
  return info;
}

DeviceImage uploadCube(VulkanDevice& device, std::span<const CubeLevel> levels) {
  std::vector<glm::u16vec4> texels;
  for (const CubeLevel& level : levels)
    for (const glm::vec3 value : level.texels)
      appendHalf(texels, value);
  const auto side = std::uint32_t(levels.front().side);
  DeviceImageInfo info = halfImage(side, side);
  info.mipLevels = std::uint32_t(levels.size());
  info.layers = 6;
  info.viewType = VK_IMAGE_VIEW_TYPE_CUBE;
  info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
  return uploadImage(device, info, std::as_bytes(std::span(texels)), false);
}

} // namespace

GpuEnvironment uploadEnvironment(VulkanDevice& device, ObjectOwner& objects,
                                 const Environment& environment) {
  GpuEnvironment gpu;
  std::vector<glm::u16vec4> texels;
  const LinearImage& panorama = environment.panorama;
  for (std::size_t i = 0; i < panorama.pixelCount(); ++i)
    appendHalf(texels,
               {panorama.values[3 * i], panorama.values[3 * i + 1], panorama.values[3 * i + 2]});
  gpu.panorama =
      uploadImage(device, halfImage(std::uint32_t(panorama.width), std::uint32_t(panorama.height)),
                  std::as_bytes(std::span(texels)), false);
  gpu.specular = uploadCube(device, environment.specular);
  gpu.diffuse = uploadCube(device, std::span(&environment.diffuse, 1));
  texels.clear();
  for (const glm::vec4 value : environment.brdf)
    texels.push_back(glm::packHalf(value));
  gpu.brdf =
      uploadImage(device, halfImage(kBrdfSide, kBrdfSide), std::as_bytes(std::span(texels)), false);

  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  sampler.maxLod = VK_LOD_CLAMP_NONE;
  sampler.addressModeU = sampler.addressModeV = sampler.addressModeW =
      VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  gpu.clampSampler = objects.sampler(sampler);
  sampler.addressModeU = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  gpu.panoramaSampler = objects.sampler(sampler);
  return gpu;
}

} // namespace lichen::renderer
