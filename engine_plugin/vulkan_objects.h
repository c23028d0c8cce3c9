// SPDX-License-Identifier: MIT
// What the Vulkan layer's contexts and assets hold.
#pragma once

#include <lichen/lichen_vulkan.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

struct LichenVulkanContext_T {
  LichenVulkanFunctions functions;
  VkPhysicalDevice physicalDevice;
  VkDevice device;
  const VkAllocationCallbacks* callbacks; // points to `ownCallbacks`, or NULL
  VkAllocationCallbacks ownCallbacks;
  bool hostAllocates;
  LichenDeviceAllocator allocator; // the host's, where hostAllocates
  VkPhysicalDeviceMemoryProperties memory;
  VkDescriptorType uniformType;
  std::uint32_t firstBinding;
  VkShaderStageFlags stages;
  std::array<VkSampler, 2> samplers; // by LichenSamplerUse
  LichenVulkanAssets retired;        // first of a list
};

struct LichenVulkanAssets_T {
  struct Image {
    VkImage handle = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    std::uint32_t mipLevels = 0;
    std::size_t batch = 0;
    VkDeviceSize offset = 0;               // in the batch's memory
    std::vector<VkBufferImageCopy> copies; // from the batch's staging buffer
  };
  /// Images that share their memory, and the buffer that they are copied from.
  struct Batch {
    VkMemoryRequirements requirements{0, 1, ~0u};
    std::optional<LichenDeviceMemory> imageMemory;
    VkDeviceSize stagingBytes = 0;
    VkBuffer staging = VK_NULL_HANDLE;
    std::optional<LichenDeviceMemory> stagingMemory;
  };
  /// Before and after the copies; one of each for an image.
  struct Barriers {
    std::vector<VkImageMemoryBarrier> toWrite, toSample;
  };
  struct Noise {
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    std::vector<VkDescriptorImageInfo> imageInfos; // Gaussian, table, Gaussian, table, ...
  };

  explicit LichenVulkanAssets_T(LichenVulkanContext owner) : context(owner) {}
  LichenVulkanAssets_T(const LichenVulkanAssets_T&) = delete;
  LichenVulkanAssets_T& operator=(const LichenVulkanAssets_T&) = delete;
  ~LichenVulkanAssets_T();

  LichenVulkanContext context;
  std::vector<Image> images;
  std::vector<Noise> noises;
  Barriers barriers;
  std::vector<Batch> batches;
  bool hasStaging = false; // until its release
  LichenVulkanAssets nextRetired = nullptr;
  std::uint64_t lastFrame = 0; // of those retired
};

namespace lichen::plugin {

/// The result code of a failed Vulkan call, and its diagnostic.
LichenResult vulkanFailure(const char* what, VkResult result, LichenDiagnostic* diagnostic);

/// Calls a vkCreate function or vkAllocateMemory. What a failed call leaves in the handle is
/// undefined, and must not be destroyed.
template <class Function, class Info, class Handle>
VkResult create(const LichenVulkanContext_T& context, Function function, const Info& info,
                Handle& handle) {
  const VkResult result = function(context.device, &info, context.callbacks, &handle);
  if (result != VK_SUCCESS)
    handle = VK_NULL_HANDLE;
  return result;
}

/// The kinds of memory that the plugin asks for.
enum class MemoryUse { staging, images };

/// The most that one allocation should have, where more than one thing is in it: what every device
/// of Vulkan 1.1 allocates (maxMemoryAllocationSize) and of 1.3 takes for a buffer (maxBufferSize).
inline constexpr VkDeviceSize kMostBlockBytes = VkDeviceSize(1) << 30;

/// Memory from the host's allocator, or a block of the plugin's own; of staging, mapped. `memory`
/// is to be released where it has a value, whatever the result.
LichenResult allocateMemory(const LichenVulkanContext_T& context,
                            const VkMemoryRequirements& requirements, MemoryUse use,
                            std::optional<LichenDeviceMemory>& memory,
                            LichenDiagnostic* diagnostic);
void releaseMemory(const LichenVulkanContext_T& context,
                   std::optional<LichenDeviceMemory>& memory) noexcept;

} // namespace lichen::plugin
