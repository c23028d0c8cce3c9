// SPDX-License-Identifier: MIT
// Creation and destruction of Vulkan objects, descriptor writes, uploads through staging buffers.
#include "gpu_objects.h"

#include "failure.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace lichen::renderer {
namespace {

VkExtent3D levelExtent(VkExtent3D extent, std::uint32_t level) {
  return {std::max(extent.width >> level, 1u), std::max(extent.height >> level, 1u),
          std::max(extent.depth >> level, 1u)};
}

DeviceBuffer stagingBuffer(VulkanDevice& device, std::span<const std::byte> bytes) {
  DeviceBuffer staging =
      take(device.createBuffer(bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, true));
  std::memcpy(staging.mapped, bytes.data(), bytes.size());
  return staging;
}

/// Computes each level from the one before; leaves all levels in the sampled state.
void recordMips(VkCommandBuffer commands, const DeviceImage& image) {
  const auto corner = [](VkExtent3D e) {
    return VkOffset3D{std::int32_t(e.width), std::int32_t(e.height), std::int32_t(e.depth)};
  };
  for (std::uint32_t level = 1; level < image.info.mipLevels; ++level) {
    transition(commands, image, kCopyTarget, kCopySource, level - 1, 1);
    VkImageBlit blit{};
    blit.srcSubresource = {image.info.aspect, level - 1, 0, image.info.layers};
    blit.dstSubresource = {image.info.aspect, level, 0, image.info.layers};
    blit.srcOffsets[1] = corner(levelExtent(image.info.extent, level - 1));
    blit.dstOffsets[1] = corner(levelExtent(image.info.extent, level));
    vkCmdBlitImage(commands, image.handle, kCopySource.layout, image.handle, kCopyTarget.layout, 1,
                   &blit, VK_FILTER_LINEAR);
    transition(commands, image, kCopySource, kSampled, level - 1, 1);
  }
  transition(commands, image, kCopyTarget, kSampled, image.info.mipLevels - 1, 1);
}

} // namespace

ObjectOwner::~ObjectOwner() {
  for (auto owned = owned_.rbegin(); owned != owned_.rend(); ++owned)
    if (owned->destroy != nullptr)
      owned->destroy(device_, owned->handle);
}

template <class Handle, auto& kDestroy, class Create>
Handle ObjectOwner::own(const char* what, const Create& create) {
  Owned& owned = owned_.emplace_back(); // allocated first: if this throws, no object leaks
  Handle handle = VK_NULL_HANDLE;
  check(create(&handle), what);
  owned.handle = reinterpret_cast<std::uint64_t>(handle);
  owned.destroy = [](VkDevice device, std::uint64_t object) {
    kDestroy(device, reinterpret_cast<Handle>(object), nullptr);
  };
  return handle;
}

VkSampler ObjectOwner::sampler(const VkSamplerCreateInfo& info) {
  return own<VkSampler, vkDestroySampler>("cannot create a sampler", [&](VkSampler* handle) {
    return vkCreateSampler(device_, &info, nullptr, handle);
  });
}

VkImageView ObjectOwner::view(const VkImageViewCreateInfo& info) {
  return own<VkImageView, vkDestroyImageView>(
      "cannot create an image view",
      [&](VkImageView* handle) { return vkCreateImageView(device_, &info, nullptr, handle); });
}

VkDescriptorSetLayout ObjectOwner::setLayout(std::span<const VkDescriptorType> types,
                                             VkShaderStageFlags stages) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const VkDescriptorType type : types)
    bindings.push_back({std::uint32_t(bindings.size()), type, 1, stages, nullptr});
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = std::uint32_t(bindings.size());
  info.pBindings = bindings.data();
  return own<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>(
      "cannot create a descriptor set layout", [&](VkDescriptorSetLayout* handle) {
        return vkCreateDescriptorSetLayout(device_, &info, nullptr, handle);
      });
}

VkDescriptorPool ObjectOwner::pool(std::size_t count, std::span<const VkDescriptorType> types) {
  std::vector<VkDescriptorPoolSize> sizes;
  for (const VkDescriptorType type : types)
    sizes.push_back({type, std::uint32_t(count)}); // Vulkan allows repeated types
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = std::uint32_t(count);
  info.poolSizeCount = std::uint32_t(sizes.size());
  info.pPoolSizes = sizes.data();
  return own<VkDescriptorPool, vkDestroyDescriptorPool>(
      "cannot create a descriptor pool", [&](VkDescriptorPool* handle) {
        return vkCreateDescriptorPool(device_, &info, nullptr, handle);
      });
}

VkPipelineLayout ObjectOwner::pipelineLayout(std::span<const VkDescriptorSetLayout> sets,
                                             VkShaderStageFlags pushStages,
                                             std::uint32_t pushBytes) {
  const VkPushConstantRange range{pushStages, 0, pushBytes};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = std::uint32_t(sets.size());
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = pushBytes != 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  return own<VkPipelineLayout, vkDestroyPipelineLayout>(
      "cannot create a pipeline layout", [&](VkPipelineLayout* handle) {
        return vkCreatePipelineLayout(device_, &info, nullptr, handle);
      });
}

VkShaderModule ObjectOwner::shader(std::span<const std::uint32_t> code) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  return own<VkShaderModule, vkDestroyShaderModule>(
      "cannot create a shader module", [&](VkShaderModule* handle) {
        return vkCreateShaderModule(device_, &info, nullptr, handle);
      });
}

VkPipeline ObjectOwner::graphicsPipeline(const VkGraphicsPipelineCreateInfo& info) {
  return own<VkPipeline, vkDestroyPipeline>(
      "cannot create a graphics pipeline", [&](VkPipeline* handle) {
        return vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, handle);
      });
}

VkPipeline ObjectOwner::computePipeline(const VkComputePipelineCreateInfo& info) {
  return own<VkPipeline, vkDestroyPipeline>(
      "cannot create a compute pipeline", [&](VkPipeline* handle) {
        return vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, handle);
      });
}

VkDescriptorSet ObjectOwner::set(VkDescriptorPool pool, VkDescriptorSetLayout layout) {
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pool;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet handle = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device_, &info, &handle), "cannot allocate a descriptor set");
  return handle;
}

VkFence ObjectOwner::fence() {
  const VkFenceCreateInfo info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  return own<VkFence, vkDestroyFence>("cannot create a fence", [&](VkFence* handle) {
    return vkCreateFence(device_, &info, nullptr, handle);
  });
}

void writeSet(VkDevice device, VkDescriptorSet set, std::span<const Descriptor> descriptors) {
  std::vector<VkWriteDescriptorSet> writes;
  for (const Descriptor& descriptor : descriptors) {
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = std::uint32_t(writes.size());
    write.descriptorCount = 1;
    write.descriptorType = descriptor.type;
    write.pBufferInfo = &descriptor.buffer;
    write.pImageInfo = &descriptor.image;
    writes.push_back(write);
  }
  vkUpdateDescriptorSets(device, std::uint32_t(writes.size()), writes.data(), 0, nullptr);
}

std::uint32_t fullMipCount(std::uint32_t width, std::uint32_t height) {
  return std::uint32_t(std::bit_width(std::max(width, height)));
}

void transition(VkCommandBuffer commands, VkImage image, const VkImageSubresourceRange& range,
                const ImageState& from, const ImageState& to) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = from.stages;
  barrier.srcAccessMask = from.access;
  barrier.dstStageMask = to.stages;
  barrier.dstAccessMask = to.access;
  barrier.oldLayout = from.layout;
  barrier.newLayout = to.layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = range;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

void transition(VkCommandBuffer commands, const DeviceImage& image, const ImageState& from,
                const ImageState& to, std::uint32_t level, std::uint32_t levels) {
  transition(commands, image.handle,
             {image.info.aspect, level, levels, 0, VK_REMAINING_ARRAY_LAYERS}, from, to);
}

DeviceBuffer uploadBuffer(VulkanDevice& device, std::span<const std::byte> bytes,
                          VkBufferUsageFlags usage) {
  const DeviceBuffer staging = stagingBuffer(device, bytes);
  DeviceBuffer buffer =
      take(device.createBuffer(bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, false));
  take(device.submit([&](VkCommandBuffer commands) {
    const VkBufferCopy region{0, 0, bytes.size()};
    vkCmdCopyBuffer(commands, staging.handle, buffer.handle, 1, &region);
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
  }));
  return buffer;
}

DeviceImage uploadImage(VulkanDevice& device, DeviceImageInfo info,
                        std::span<const std::byte> texels, bool makeMips) {
  info.usage |= VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (makeMips)
    info.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const DeviceBuffer staging = stagingBuffer(device, texels);
  DeviceImage image = take(device.createImage(info));

  // `texels` holds all given levels, so its size determines the bytes per texel.
  const std::uint32_t givenLevels = makeMips ? 1 : info.mipLevels;
  std::vector<VkBufferImageCopy> regions;
  VkDeviceSize texelCount = 0;
  for (std::uint32_t level = 0; level < givenLevels; ++level) {
    const VkExtent3D extent = levelExtent(info.extent, level);
    texelCount += VkDeviceSize(extent.width) * extent.height * extent.depth * info.layers;
  }
  const VkDeviceSize texelBytes = texels.size() / texelCount;
  VkDeviceSize offset = 0;
  for (std::uint32_t level = 0; level < givenLevels; ++level) {
    VkBufferImageCopy region{};
    region.bufferOffset = offset;
    region.imageSubresource = {info.aspect, level, 0, info.layers};
    region.imageExtent = levelExtent(info.extent, level);
    regions.push_back(region);
    offset += texelBytes * region.imageExtent.width * region.imageExtent.height *
              region.imageExtent.depth * info.layers;
  }
  take(device.submit([&](VkCommandBuffer commands) {
    transition(commands, image, kUndefined, kCopyTarget);
    vkCmdCopyBufferToImage(commands, staging.handle, image.handle, kCopyTarget.layout,
                           std::uint32_t(regions.size()), regions.data());
    if (makeMips)
      recordMips(commands, image);
    else
      transition(commands, image, kCopyTarget, kSampled);
  }));
  return image;
}

} // namespace lichen::renderer
