// SPDX-License-Identifier: MIT
// Every surface supports the present mode FIFO.
#include "swapchain.h"

#include "failure.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kExtentOfWindow = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kNoTimeout = std::numeric_limits<std::uint64_t>::max();

constexpr ImageState kAcquired{VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_NONE, 0};
constexpr ImageState kPresented{VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_NONE, 0};
constexpr VkImageSubresourceRange kWholeImage{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};

} // namespace

Swapchain::Swapchain(VulkanDevice& device, VkSurfaceKHR surface)
    : Swapchain(device, surface, SurfaceOnly()) {
  VkBool32 presents = VK_FALSE;
  check(vkGetPhysicalDeviceSurfaceSupportKHR(device.physicalDevice(), device.queueFamily(), surface,
                                             &presents),
        "cannot query presentation support");
  if (presents == VK_FALSE)
    throw Failure{{ErrorKind::environment, "Vulkan device \"" +
                                               std::string(device.properties().deviceName) +
                                               "\" cannot present to this window"}};
  chooseFormat();
}

Swapchain::~Swapchain() {
  vkDeviceWaitIdle(device_.device());
  vkDestroySwapchainKHR(device_.device(), swapchain_, nullptr);
  vkDestroySurfaceKHR(device_.instance(), surface_, nullptr);
}

/// Chooses a format that stores sRGB-encoded values unchanged and can be the target of a blit.
void Swapchain::chooseFormat() {
  std::uint32_t count = 0;
  check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), surface_, &count, nullptr),
        "cannot query the window's formats");
  std::vector<VkSurfaceFormatKHR> formats(count);
  check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), surface_, &count,
                                             formats.data()),
        "cannot query the window's formats");
  for (const VkSurfaceFormatKHR& format : formats) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device_.physicalDevice(), format.format, &properties);
    const bool isUnorm8 = format.format == VK_FORMAT_B8G8R8A8_UNORM ||
                          format.format == VK_FORMAT_R8G8B8A8_UNORM ||
                          format.format == VK_FORMAT_A8B8G8R8_UNORM_PACK32;
    if (isUnorm8 && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR &&
        (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_BLIT_DST_BIT) != 0) {
      format_ = format;
      return;
    }
  }
  throw Failure{{ErrorKind::environment, "the window supports no format with 8 bits per channel"}};
}

bool Swapchain::resize(VkExtent2D window) {
  VkSurfaceCapabilitiesKHR can{};
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physicalDevice(), surface_, &can),
        "cannot query the window's capabilities");
  if ((can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT) == 0)
    throw Failure{{ErrorKind::environment, "the window's images do not support copying to them"}};
  extent_ = can.currentExtent;
  if (extent_.width == kExtentOfWindow)
    extent_ = {std::clamp(window.width, can.minImageExtent.width, can.maxImageExtent.width),
               std::clamp(window.height, can.minImageExtent.height, can.maxImageExtent.height)};
  if (extent_.width == 0 || extent_.height == 0)
    return false;
  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_;
  info.minImageCount = can.minImageCount + 1; // one more than the window system may hold
  if (can.maxImageCount > 0)
    info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = (can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0
                            ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                            : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_;
  vkDeviceWaitIdle(device_.device()); // finish presenting the old images
  VkSwapchainKHR created = VK_NULL_HANDLE;
  const VkResult result = vkCreateSwapchainKHR(device_.device(), &info, nullptr, &created);
  vkDestroySwapchainKHR(device_.device(), swapchain_, nullptr);
  swapchain_ = created;
  check(result, "cannot create the window's images");
  std::uint32_t count = 0;
  check(vkGetSwapchainImagesKHR(device_.device(), swapchain_, &count, nullptr),
        "cannot query the window's images");
  images_.resize(count);
  check(vkGetSwapchainImagesKHR(device_.device(), swapchain_, &count, images_.data()),
        "cannot query the window's images");
  return true;
}

bool Swapchain::acquire() {
  const VkResult result = vkAcquireNextImageKHR(device_.device(), swapchain_, kNoTimeout,
                                                VK_NULL_HANDLE, acquired_, &index_);
  if (result == VK_ERROR_OUT_OF_DATE_KHR)
    return false;
  if (result != VK_SUBOPTIMAL_KHR)
    check(result, "cannot acquire an image of the window");
  check(vkWaitForFences(device_.device(), 1, &acquired_, VK_TRUE, kNoTimeout),
        "cannot wait for an image of the window");
  check(vkResetFences(device_.device(), 1, &acquired_), "cannot reset a fence");
  return true;
}

/// Blits instead of copying, because the order of the channels may differ.
void Swapchain::recordCopy(VkCommandBuffer commands, const DeviceImage& picture) const {
  const VkImage target = images_[index_];
  transition(commands, target, kWholeImage, kAcquired, kCopyTarget);
  VkImageBlit region{};
  region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.srcOffsets[1] = {std::int32_t(picture.info.extent.width),
                          std::int32_t(picture.info.extent.height), 1};
  region.dstOffsets[1] = {std::int32_t(extent_.width), std::int32_t(extent_.height), 1};
  vkCmdBlitImage(commands, picture.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                 kCopyTarget.layout, 1, &region, VK_FILTER_NEAREST);
  transition(commands, target, kWholeImage, kCopyTarget, kPresented);
}

bool Swapchain::present() {
  VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.swapchainCount = 1;
  info.pSwapchains = &swapchain_;
  info.pImageIndices = &index_;
  const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR)
    return false;
  check(result, "cannot present a picture");
  return true;
}

} // namespace lichen::renderer
