// SPDX-License-Identifier: MIT
// The contexts and assets of the Vulkan layer.
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
  LichenDeviceAllocator allocator; // the host's allocator if hostAllocates
  VkPhysicalDeviceMemoryProperties memory;
  VkDescriptorType materialType;
  std::uint32_t firstBinding;
  VkShaderStageFlags stages;
  bool hasLayers;                    // LICHEN_VULKAN_LAYERS
  std::array<VkSampler, 2> samplers; // indexed by LichenSamplerUse
  VkDescriptorSetLayout setLayout;   // null where the host has given no functions for sets
  LichenVulkanAssets retired;        // head of a linked list
};

struct LichenVulkanAssets_T {
  struct Image {
    VkImage handle = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    std::uint32_t mipLevels = 0;
    std::size_t batch = 0;
    VkDeviceSize offset = 0;               // offset in the batch's memory
    std::vector<VkBufferImageCopy> copies; // copies from the batch's staging buffer
  };
  /// Images that share one allocation, and the staging buffer for their copies.
  struct Batch {
    VkMemoryRequirements requirements{0, 1, ~0u};
    std::optional<LichenDeviceMemory> imageMemory;
    VkDeviceSize stagingBytes = 0;
    VkBuffer staging = VK_NULL_HANDLE;
    std::optional<LichenDeviceMemory> stagingMemory;
  };
  struct Noise {
    std::array<VkDescriptorImageInfo, LICHEN_LAYERED_SET_IMAGES> imageInfos{}; // by binding
    bool isLayered = false;
  };

  explicit LichenVulkanAssets_T(LichenVulkanContext owner) : context(owner) {}
  LichenVulkanAssets_T(const LichenVulkanAssets_T&) = delete;
  LichenVulkanAssets_T& operator=(const LichenVulkanAssets_T&) = delete;
  ~LichenVulkanAssets_T();

  LichenVulkanContext context;
  std::vector<Image> images;
  std::vector<Noise> noises;
  VkBuffer constants = VK_NULL_HANDLE; // LICHEN_NOISE_BYTES of each noise
  std::optional<LichenDeviceMemory> constantsMemory;
  VkBufferCopy constantsCopy{}; // from the last batch's staging buffer
  std::vector<Batch> batches;
  bool hasStaging = false; // true until lichenVulkanReleaseStaging()
  LichenVulkanAssets nextRetired = nullptr;
  std::uint64_t lastFrame = 0; // of retired assets
};

namespace lichen::plugin {

/// Sampled images of a set.
inline std::uint32_t setImages(const LichenVulkanContext_T& context) {
  return context.hasLayers ? LICHEN_LAYERED_SET_IMAGES : LICHEN_SET_IMAGES;
}

/// Returns the result code for a failed Vulkan call, and writes its diagnostic.
LichenResult vulkanFailure(const char* what, VkResult result, LichenDiagnostic* diagnostic);

/// Calls a vkCreate function or vkAllocateMemory. On failure Vulkan leaves the handle undefined, so
/// this sets it to null: destructors may then destroy it safely.
template <class Function, class Info, class Handle>
VkResult create(const LichenVulkanContext_T& context, Function function, const Info& info,
                Handle& handle) {
  const VkResult result = function(context.device, &info, context.callbacks, &handle);
  if (result != VK_SUCCESS)
    handle = VK_NULL_HANDLE;
  return result;
}

/// The kinds of memory that the plugin allocates.
enum class MemoryUse { staging, images, constants };

/// Maximum size of an allocation that holds several images. Every Vulkan 1.1 device can allocate
/// this much (maxMemoryAllocationSize), and every Vulkan 1.3 device supports buffers of this size
/// (maxBufferSize).
inline constexpr VkDeviceSize kMostBlockBytes = VkDeviceSize(1) << 30;

/// Allocates from the host's allocator, or a block of the plugin's own; maps staging memory. If
/// `memory` has a value, the caller must release it, whatever the result.
LichenResult allocateMemory(const LichenVulkanContext_T& context,
                            const VkMemoryRequirements& requirements, MemoryUse use,
                            std::optional<LichenDeviceMemory>& memory,
                            LichenDiagnostic* diagnostic);
void releaseMemory(const LichenVulkanContext_T& context,
                   std::optional<LichenDeviceMemory>& memory) noexcept;

} // namespace lichen::plugin
