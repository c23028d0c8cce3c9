// SPDX-License-Identifier: MIT
#include "peer_images.h"

#include "peer_contents.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace lichen::bench {
namespace {

/// The uniform block of peer_inputs.glsl.
struct Parameters {
  PeerColor colorOrigin;
  std::array<PeerColor, 3> colorAxes;
  float rotationStrength = 0.0f; // hextile-demo's
  float contrast = 0.7f;         // hextile-demo's r of colours
};

/// The last binding is the uniform block, those before it are the images.
constexpr std::uint32_t kImages = 5;

void require(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(vulkanError(what, result).message);
}

template <class Value>
Value take(Result<Value> result) {
  if (!result)
    throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

DeviceBuffer filledBuffer(VulkanDevice& device, const void* bytes, std::size_t size,
                          VkBufferUsageFlags usage) {
  DeviceBuffer buffer = take(device.createBuffer(size, usage, true));
  std::memcpy(buffer.mapped, bytes, size);
  return buffer;
}

VkSampler trilinearSampler(VkDevice device, VkSamplerAddressMode mode) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = info.minFilter = VK_FILTER_LINEAR;
  info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  info.addressModeU = info.addressModeV = info.addressModeW = mode;
  info.maxLod = VK_LOD_CLAMP_NONE;
  VkSampler sampler = VK_NULL_HANDLE;
  require(vkCreateSampler(device, &info, nullptr, &sampler), "a sampler");
  return sampler;
}

std::vector<VkBufferImageCopy> copies(const PeerTexels& source) {
  constexpr VkDeviceSize kTexelBytes = 4;
  std::vector<VkBufferImageCopy> regions;
  VkDeviceSize offset = 0;
  for (std::uint32_t level = 0; level < source.mipLevels; ++level) {
    VkBufferImageCopy region{};
    region.bufferOffset = offset;
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
    region.imageExtent = {std::max(1u, source.width >> level), std::max(1u, source.height >> level),
                          source.depth};
    offset += kTexelBytes * region.imageExtent.width * region.imageExtent.height * source.depth;
    regions.push_back(region);
  }
  return regions;
}

VkImageMemoryBarrier transition(const DeviceImage& image, VkImageLayout from, VkImageLayout to) {
  const bool isBefore = from == VK_IMAGE_LAYOUT_UNDEFINED;
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = isBefore ? 0 : VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = isBefore ? VK_ACCESS_TRANSFER_WRITE_BIT : VK_ACCESS_SHADER_READ_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.handle;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, image.info.mipLevels, 0, 1};
  return barrier;
}

} // namespace

PeerImages::PeerImages(VulkanDevice& device, const SrgbImage& exemplar) : device_(device) {
  const PeerContents contents = peerContents(exemplar);
  mean_ = contents.mean;
  upload(contents.exemplar);
  upload(contents.gaussianImage);
  upload(contents.colorTable);
  upload(contents.decorrelatedImage);
  upload(contents.axisTable);
  const Parameters parameters{contents.colorOrigin, contents.colorAxes};
  parameters_ =
      filledBuffer(device, &parameters, sizeof parameters, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  repeats_ = trilinearSampler(device.device(), VK_SAMPLER_ADDRESS_MODE_REPEAT);
  clamps_ = trilinearSampler(device.device(), VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  createSet();
}

PeerImages::~PeerImages() {
  vkDestroyDescriptorPool(device_.device(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.device(), layout_, nullptr);
  vkDestroySampler(device_.device(), clamps_, nullptr);
  vkDestroySampler(device_.device(), repeats_, nullptr);
}

void PeerImages::upload(const PeerTexels& source) {
  DeviceImageInfo info;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  info.extent = {source.width, source.height, source.depth};
  info.mipLevels = source.mipLevels;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  const DeviceImage& image = images_.emplace_back(take(device_.createImage(info)));
  const DeviceBuffer staging = filledBuffer(device_, source.texels.data(), source.texels.size(),
                                            VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  const std::vector<VkBufferImageCopy> regions = copies(source);
  const VkImageMemoryBarrier before =
      transition(image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  const VkImageMemoryBarrier after = transition(image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  const Result<void> uploaded = device_.submit([&](VkCommandBuffer commands) {
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT,
                         VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1, &before);
    vkCmdCopyBufferToImage(commands, staging.handle, image.handle,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, std::uint32_t(regions.size()),
                           regions.data());
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, 0, 0, nullptr, 0, nullptr, 1,
                         &after);
  });
  if (!uploaded)
    throw std::runtime_error(uploaded.error().message);
}

void PeerImages::createSet() {
  const VkDevice device = device_.device();
  // By binding.
  const std::array<VkSampler, kImages> samplers{repeats_, repeats_, clamps_, repeats_, clamps_};
  std::array<VkDescriptorSetLayoutBinding, kImages + 1> bindings{};
  for (std::uint32_t binding = 0; binding <= kImages; ++binding)
    bindings[binding] = {binding,
                         binding < kImages ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                           : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                         1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo layout{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  layout.bindingCount = std::uint32_t(bindings.size());
  layout.pBindings = bindings.data();
  require(vkCreateDescriptorSetLayout(device, &layout, nullptr, &layout_), "a set layout");

  const std::array<VkDescriptorPoolSize, 2> sizes{
      {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, kImages},
       {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1}}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = 1;
  pool.poolSizeCount = std::uint32_t(sizes.size());
  pool.pPoolSizes = sizes.data();
  require(vkCreateDescriptorPool(device, &pool, nullptr, &pool_), "a descriptor pool");
  VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocation.descriptorPool = pool_;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &layout_;
  require(vkAllocateDescriptorSets(device, &allocation, &set_), "a descriptor set");

  std::array<VkDescriptorImageInfo, kImages> images{};
  const VkDescriptorBufferInfo parameters{parameters_.handle, 0, VK_WHOLE_SIZE};
  std::array<VkWriteDescriptorSet, kImages + 1> writes{};
  for (std::uint32_t binding = 0; binding <= kImages; ++binding) {
    VkWriteDescriptorSet& write = writes[binding];
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set_;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = bindings[binding].descriptorType;
    write.pBufferInfo = &parameters;
    if (binding < kImages) {
      images[binding] = {samplers[binding], images_[binding].view,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
      write.pImageInfo = &images[binding];
    }
  }
  vkUpdateDescriptorSets(device, std::uint32_t(writes.size()), writes.data(), 0, nullptr);
}

} // namespace lichen::bench
