// SPDX-License-Identifier: MIT
// Ownership of Vulkan objects, uploads, and barriers.
#pragma once

#include <lichen/vulkan_device.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen::renderer {

/// Owns Vulkan objects that have no class of their own, and destroys them in reverse order of
/// creation.
class ObjectOwner {
public:
  explicit ObjectOwner(VkDevice device) : device_(device) {}
  ObjectOwner(const ObjectOwner&) = delete;
  ObjectOwner& operator=(const ObjectOwner&) = delete;
  ~ObjectOwner();

  [[nodiscard]] VkDevice device() const { return device_; }
  /// Each function creates one object, or throws a Failure.
  VkSampler sampler(const VkSamplerCreateInfo& info);
  VkImageView view(const VkImageViewCreateInfo& info);
  /// A layout whose binding i has type types[i] and is visible to `stages`.
  VkDescriptorSetLayout setLayout(std::span<const VkDescriptorType> types,
                                  VkShaderStageFlags stages);
  /// A pool for `count` sets with bindings of these types.
  VkDescriptorPool pool(std::size_t count, std::span<const VkDescriptorType> types);
  VkPipelineLayout pipelineLayout(std::span<const VkDescriptorSetLayout> sets,
                                  VkShaderStageFlags pushStages, std::uint32_t pushBytes);
  VkShaderModule shader(std::span<const std::uint32_t> code);
  VkPipeline graphicsPipeline(const VkGraphicsPipelineCreateInfo& info);
  VkPipeline computePipeline(const VkComputePipelineCreateInfo& info);
  VkDescriptorSet set(VkDescriptorPool pool, VkDescriptorSetLayout layout); ///< freed with its pool
  VkFence fence();

private:
  struct Owned {
    std::uint64_t handle = 0;
    void (*destroy)(VkDevice, std::uint64_t) = nullptr; ///< null if creation failed
  };

  template <class Handle, auto& kDestroy, class Create>
  Handle own(const char* what, const Create& create);

  VkDevice device_;
  std::vector<Owned> owned_;
};

/// One binding of a descriptor set: a buffer range or an image, depending on the type.
struct Descriptor {
  VkDescriptorType type;
  VkDescriptorBufferInfo buffer{};
  VkDescriptorImageInfo image{};
};

/// An image in SHADER_READ_ONLY_OPTIMAL.
[[nodiscard]] inline Descriptor sampledImage(VkSampler sampler, VkImageView view) {
  return {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
          {},
          {sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
}

/// An image in GENERAL.
[[nodiscard]] inline Descriptor storageImage(VkImageView view) {
  return {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, {}, {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL}};
}

/// Writes descriptors[i] to binding i of the set.
void writeSet(VkDevice device, VkDescriptorSet set, std::span<const Descriptor> descriptors);

/// A device-local vertex or index buffer, according to `usage`.
[[nodiscard]] DeviceBuffer uploadBuffer(VulkanDevice& device, std::span<const std::byte> bytes,
                                        VkBufferUsageFlags usage);

/// A sampled image in SHADER_READ_ONLY_OPTIMAL. `texels` holds level 0 of every layer, then level
/// 1, and so on. With `makeMips` it holds level 0 only, and the GPU computes the other levels by
/// averaging.
[[nodiscard]] DeviceImage uploadImage(VulkanDevice& device, DeviceImageInfo info,
                                      std::span<const std::byte> texels, bool makeMips);

[[nodiscard]] std::uint32_t fullMipCount(std::uint32_t width, std::uint32_t height);

struct ImageState {
  VkImageLayout layout;
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
};

/// Layout, stages and access of each use of an image in the renderer.
inline constexpr ImageState kUndefined{VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_NONE, 0};
inline constexpr ImageState kCopyTarget{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                        VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                        VK_ACCESS_2_TRANSFER_WRITE_BIT};
inline constexpr ImageState kCopySource{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                        VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                        VK_ACCESS_2_TRANSFER_READ_BIT};
inline constexpr ImageState kSampled{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                     VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT |
                                         VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                         VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                     VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
inline constexpr ImageState kColorTarget{
    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
inline constexpr ImageState kDepthTarget{
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
inline constexpr ImageState kStorage{
    VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};

/// The contents after this use are not needed: what comes next waits for the use, in this
/// submission or an earlier one, and overwrites them.
[[nodiscard]] constexpr ImageState discarded(const ImageState& state) {
  return {VK_IMAGE_LAYOUT_UNDEFINED, state.stages, state.access};
}

/// Records a barrier for a subresource range.
void transition(VkCommandBuffer commands, VkImage image, const VkImageSubresourceRange& range,
                const ImageState& from, const ImageState& to);

/// Records a barrier for `levels` mip levels starting at `level`, all layers.
void transition(VkCommandBuffer commands, const DeviceImage& image, const ImageState& from,
                const ImageState& to, std::uint32_t level = 0,
                std::uint32_t levels = VK_REMAINING_MIP_LEVELS);

} // namespace lichen::renderer
