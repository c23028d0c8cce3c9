// SPDX-License-Identifier: MIT
// Sizes and formats of the targets, and the device features they need.
#include "frame_targets.h"

#include "failure.h"
#include "frame_data.h"
#include "pipelines.h"

#include <algorithm>

namespace lichen::renderer {
namespace {

DeviceImage target(VulkanDevice& device, VkFormat format, VkImageUsageFlags usage,
                   std::uint32_t width, std::uint32_t height) {
  DeviceImageInfo info;
  info.format = format;
  info.extent = {width, height, 1};
  info.usage = usage;
  if (format == kDepthFormat)
    info.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
  return take(device.createImage(info));
}

} // namespace

FrameTargets createFrameTargets(VulkanDevice& device, std::uint32_t width, std::uint32_t height) {
  const std::uint32_t longest = device.properties().limits.maxImageDimension2D;
  if (std::max(width, height) > longest)
    throw Failure{
        {ErrorKind::usage, "--size " + std::to_string(width) + "x" + std::to_string(height) +
                               " is too large; this device supports up to " +
                               std::to_string(longest) + " x " + std::to_string(longest)}};
  FrameTargets targets;
  targets.color =
      target(device, kColorFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
             width, height);
  targets.depth =
      target(device, kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, width, height);
  targets.sum = target(device, kSumFormat,
                       VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, width, height);
  return targets;
}

LightMaps createLightMaps(VulkanDevice& device, ObjectOwner& objects) {
  constexpr VkImageUsageFlags kDepthMap =
      VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  LightMaps maps;
  maps.sunDepth = target(device, kDepthFormat, kDepthMap, kSunDepthSide, kSunDepthSide);
  DeviceImageInfo sky;
  sky.format = kDepthFormat;
  sky.extent = {kSkyDepthSide, kSkyDepthSide, 1};
  sky.layers = MAX_SKY_DIRECTIONS;
  sky.usage = kDepthMap;
  sky.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
  sky.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
  maps.skyDepth = take(device.createImage(sky));
  VkImageViewCreateInfo layer{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  layer.image = maps.skyDepth.handle;
  layer.viewType = VK_IMAGE_VIEW_TYPE_2D;
  layer.format = kDepthFormat;
  for (std::uint32_t k = 0; k < MAX_SKY_DIRECTIONS; ++k) {
    layer.subresourceRange = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, k, 1};
    maps.skyLayers[k] = objects.view(layer);
  }
  return maps;
}

// Vulkan guarantees the required features of the colour formats, but of depth formats only that one
// of them can be rendered to.
VkFilter depthFilter(const VulkanDevice& device) {
  VkFormatProperties depth{};
  vkGetPhysicalDeviceFormatProperties(device.physicalDevice(), kDepthFormat, &depth);
  constexpr VkFormatFeatureFlags kNeeded =
      VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
  if ((depth.optimalTilingFeatures & kNeeded) != kNeeded)
    throw Failure{
        {ErrorKind::environment,
         "Vulkan device \"" + std::string(device.properties().deviceName) +
             "\" cannot render to and sample VK_FORMAT_D32_SFLOAT, which shadows require"}};
  const bool linear =
      (depth.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
  return linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST; // nearest gives harder shadow edges
}

} // namespace lichen::renderer
