// SPDX-License-Identifier: MIT
// Creates a bundle's images and constants on the host's device, and uploads them.
#include "abi.h"
#include "vulkan_objects.h"

#include <array>
#include <lichen_interface.h>
#include <memory>

using namespace lichen::plugin;

namespace {

/// Bytes; a multiple of every texel size and of the alignment that buffer copies require.
constexpr VkDeviceSize kCopyAlignment = 16;

VkDeviceSize alignedUp(VkDeviceSize value, VkDeviceSize alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

LichenImageProperties imageProperties(LichenBundle bundle, std::uint32_t image) {
  LichenImageProperties properties;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
  (void)lichenGetImageProperties(bundle, image, &properties); // image is in range
  return properties;
}

LichenCopy copyOf(LichenBundle bundle, std::uint32_t image, std::uint32_t level) {
  LichenCopy copy;
  LICHEN_INIT(copy, LICHEN_STRUCTURE_COPY);
  (void)lichenGetCopy(bundle, image, level, &copy); // image and level are in range
  return copy;
}

VkImageCreateInfo imageInfo(const LichenImageProperties& properties) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = properties.dimensionality == 3 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
  info.format = VkFormat(properties.vkFormat);
  info.extent = {properties.width, properties.height, properties.depth};
  info.mipLevels = properties.mipLevels;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return info;
}

LichenResult checkFormat(const LichenVulkanContext_T& context,
                         const LichenImageProperties& properties, LichenDiagnostic* diagnostic) {
  const VkImageCreateInfo info = imageInfo(properties);
  VkFormatProperties format{};
  context.functions.getPhysicalDeviceFormatProperties(context.physicalDevice, info.format, &format);
  // Without TRANSFER_DST, which Vulkan 1.0 does not report; the usage below includes it.
  VkFormatFeatureFlags needed = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
  if (properties.fetchedOnly == 0)
    needed |= VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  VkImageFormatProperties most{};
  const VkResult result = context.functions.getPhysicalDeviceImageFormatProperties(
      context.physicalDevice, info.format, info.imageType, info.tiling, info.usage, info.flags,
      &most);
  if (result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY)
    return vulkanFailure("querying a format's properties", result, diagnostic);
  if (result == VK_SUCCESS && (format.optimalTilingFeatures & needed) == needed &&
      info.extent.width <= most.maxExtent.width && info.extent.height <= most.maxExtent.height &&
      info.extent.depth <= most.maxExtent.depth && info.mipLevels <= most.maxMipLevels)
    return LICHEN_SUCCESS;
  writeDiagnostic(
      diagnostic,
      "table \"%s\": the device cannot filter an image with VkFormat %u and %u x %u x %u texels",
      properties.name, properties.vkFormat, properties.width, properties.height, properties.depth);
  return LICHEN_ERROR_UNSUPPORTED;
}

/// Assigns an image an offset after the other images of the last batch, or starts a new batch.
void placeImage(LichenVulkanAssets_T& assets, LichenVulkanAssets_T::Image& image,
                const VkMemoryRequirements& own) {
  const auto fits = [&](const LichenVulkanAssets_T::Batch& batch) {
    return alignedUp(batch.requirements.size, own.alignment) + own.size <= kMostBlockBytes;
  };
  if (assets.batches.empty() || !fits(assets.batches.back()))
    assets.batches.emplace_back();
  VkMemoryRequirements& all = assets.batches.back().requirements;
  image.batch = assets.batches.size() - 1;
  image.offset = alignedUp(all.size, own.alignment);
  all.size = image.offset + own.size;
  all.alignment = std::max(all.alignment, own.alignment);
  all.memoryTypeBits &= own.memoryTypeBits; // equal for all images, according to the specification
}

LichenResult createImages(LichenVulkanAssets_T& assets, LichenBundle bundle,
                          LichenDiagnostic* diagnostic) {
  const LichenVulkanContext_T& context = *assets.context;
  for (std::uint32_t i = 0; i < assets.images.size(); ++i) {
    LichenVulkanAssets_T::Image& image = assets.images[i];
    const LichenImageProperties properties = imageProperties(bundle, i);
    if (const LichenResult result = checkFormat(context, properties, diagnostic);
        result != LICHEN_SUCCESS)
      return result;
    const VkImageCreateInfo info = imageInfo(properties);
    image.mipLevels = info.mipLevels;
    if (const VkResult result = create(context, context.functions.createImage, info, image.handle);
        result != VK_SUCCESS)
      return vulkanFailure("creating an image", result, diagnostic);
    VkMemoryRequirements own{};
    context.functions.getImageMemoryRequirements(context.device, image.handle, &own);
    placeImage(assets, image, own);
  }
  for (LichenVulkanAssets_T::Batch& batch : assets.batches)
    if (const LichenResult result = allocateMemory(context, batch.requirements, MemoryUse::images,
                                                   batch.imageMemory, diagnostic);
        result != LICHEN_SUCCESS)
      return result;
  for (const LichenVulkanAssets_T::Image& image : assets.images) {
    const LichenDeviceMemory& memory = *assets.batches[image.batch].imageMemory;
    if (const VkResult result = context.functions.bindImageMemory(
            context.device, image.handle, memory.memory, memory.offset + image.offset);
        result != VK_SUCCESS)
      return vulkanFailure("binding an image to its memory", result, diagnostic);
  }
  return LICHEN_SUCCESS;
}

LichenResult createViews(LichenVulkanAssets_T& assets, LichenBundle bundle,
                         LichenDiagnostic* diagnostic) {
  const LichenVulkanContext_T& context = *assets.context;
  for (std::uint32_t i = 0; i < assets.images.size(); ++i) {
    const LichenImageProperties properties = imageProperties(bundle, i);
    VkImageViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = assets.images[i].handle;
    info.viewType = properties.dimensionality == 3 ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
    info.format = VkFormat(properties.vkFormat);
    const std::uint32_t* swizzle = properties.vkSwizzle;
    info.components = {VkComponentSwizzle(swizzle[0]), VkComponentSwizzle(swizzle[1]),
                       VkComponentSwizzle(swizzle[2]), VkComponentSwizzle(swizzle[3])};
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, properties.mipLevels, 0, 1};
    if (const VkResult result =
            create(context, context.functions.createImageView, info, assets.images[i].view);
        result != VK_SUCCESS)
      return vulkanFailure("creating an image view", result, diagnostic);
  }
  return LICHEN_SUCCESS;
}

/// Assigns each mip level an offset in its batch's staging buffer.
void planCopies(LichenVulkanAssets_T& assets, LichenBundle bundle) {
  for (std::uint32_t i = 0; i < assets.images.size(); ++i) {
    VkDeviceSize& size = assets.batches[assets.images[i].batch].stagingBytes;
    for (std::uint32_t level = 0; level < assets.images[i].mipLevels; ++level) {
      const LichenCopy copy = copyOf(bundle, i, level);
      VkBufferImageCopy region{};
      region.bufferOffset = alignedUp(size, kCopyAlignment);
      region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
      region.imageExtent = {copy.width, copy.height, copy.depth};
      assets.images[i].copies.push_back(region);
      size = region.bufferOffset + copy.byteCount;
    }
  }
  if (!assets.noises.empty()) {
    VkDeviceSize& size = assets.batches.back().stagingBytes;
    assets.constantsCopy.srcOffset = alignedUp(size, kCopyAlignment);
    assets.constantsCopy.size = assets.noises.size() * LICHEN_NOISE_BYTES;
    size = assets.constantsCopy.srcOffset + assets.constantsCopy.size;
  }
}

LichenResult createStaging(const LichenVulkanContext_T& context, LichenVulkanAssets_T::Batch& batch,
                           LichenDiagnostic* diagnostic) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = batch.stagingBytes;
  info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
  if (const VkResult result = create(context, context.functions.createBuffer, info, batch.staging);
      result != VK_SUCCESS)
    return vulkanFailure("creating a staging buffer", result, diagnostic);
  VkMemoryRequirements requirements{};
  context.functions.getBufferMemoryRequirements(context.device, batch.staging, &requirements);
  if (const LichenResult result = allocateMemory(context, requirements, MemoryUse::staging,
                                                 batch.stagingMemory, diagnostic);
      result != LICHEN_SUCCESS)
    return result;
  if (const VkResult result = context.functions.bindBufferMemory(
          context.device, batch.staging, batch.stagingMemory->memory, batch.stagingMemory->offset);
      result != VK_SUCCESS)
    return vulkanFailure("binding a staging buffer to its memory", result, diagnostic);
  return LICHEN_SUCCESS;
}

void fillStaging(const LichenVulkanAssets_T& assets, LichenBundle bundle) {
  for (std::uint32_t i = 0; i < assets.images.size(); ++i) {
    const LichenVulkanAssets_T::Image& image = assets.images[i];
    const auto* source = static_cast<const unsigned char*>(imageProperties(bundle, i).bytes);
    auto* target = static_cast<unsigned char*>(assets.batches[image.batch].stagingMemory->mapped);
    for (const VkBufferImageCopy& region : image.copies) {
      const LichenCopy copy = copyOf(bundle, i, region.imageSubresource.mipLevel);
      std::memcpy(target + region.bufferOffset, source + copy.offset, copy.byteCount);
    }
  }
  for (std::uint32_t noise = 0; noise < assets.noises.size(); ++noise) {
    auto* target = static_cast<unsigned char*>(assets.batches.back().stagingMemory->mapped);
    (void)lichenGetNoiseConstants(
        bundle, noise, target + assets.constantsCopy.srcOffset + noise * LICHEN_NOISE_BYTES);
  }
}

LichenResult createUpload(LichenVulkanAssets_T& assets, LichenBundle bundle,
                          LichenDiagnostic* diagnostic) {
  planCopies(assets, bundle);
  for (LichenVulkanAssets_T::Batch& batch : assets.batches)
    if (const LichenResult result = createStaging(*assets.context, batch, diagnostic);
        result != LICHEN_SUCCESS)
      return result;
  fillStaging(assets, bundle);
  assets.hasStaging = true;
  return LICHEN_SUCCESS;
}

/// The constants of all noises: a buffer of the host's device, filled by a copy.
LichenResult createConstants(LichenVulkanAssets_T& assets, LichenDiagnostic* diagnostic) {
  const LichenVulkanContext_T& context = *assets.context;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = assets.noises.size() * LICHEN_NOISE_BYTES;
  info.usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
               VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (const VkResult result =
          create(context, context.functions.createBuffer, info, assets.constants);
      result != VK_SUCCESS)
    return vulkanFailure("creating a uniform buffer", result, diagnostic);
  VkMemoryRequirements requirements{};
  context.functions.getBufferMemoryRequirements(context.device, assets.constants, &requirements);
  if (const LichenResult result = allocateMemory(context, requirements, MemoryUse::constants,
                                                 assets.constantsMemory, diagnostic);
      result != LICHEN_SUCCESS)
    return result;
  if (const VkResult result = context.functions.bindBufferMemory(context.device, assets.constants,
                                                                 assets.constantsMemory->memory,
                                                                 assets.constantsMemory->offset);
      result != VK_SUCCESS)
    return vulkanFailure("binding a uniform buffer to its memory", result, diagnostic);
  return LICHEN_SUCCESS;
}

void planNoise(LichenVulkanAssets_T& assets, LichenBundle bundle, std::uint32_t index) {
  LichenBinding binding;
  LICHEN_INIT(binding, LICHEN_STRUCTURE_BINDING);
  std::size_t image = 0;
  for (std::uint32_t i = 0; i < LICHEN_LAYERED_SET_BINDINGS; ++i) {
    (void)lichenGetBinding(bundle, index, i, &binding); // noise and index are in range
    if (binding.kind == LICHEN_BINDING_SAMPLED_IMAGE)
      assets.noises[index].imageInfos[image++] = {VK_NULL_HANDLE, assets.images[binding.image].view,
                                                  VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  }
  LichenNoiseProperties noise;
  LICHEN_INIT(noise, LICHEN_STRUCTURE_NOISE_PROPERTIES);
  (void)lichenGetNoiseProperties(bundle, index, &noise);
  assets.noises[index].isLayered = noise.layerCount > 1;
}

} // namespace

LichenVulkanAssets_T::~LichenVulkanAssets_T() {
  const LichenVulkanFunctions& f = context->functions;
  lichenVulkanReleaseStaging(this);
  f.destroyBuffer(context->device, constants, context->callbacks);
  releaseMemory(*context, constantsMemory);
  for (const Image& image : images) {
    f.destroyImageView(context->device, image.view, context->callbacks);
    f.destroyImage(context->device, image.handle, context->callbacks);
  }
  for (Batch& batch : batches)
    releaseMemory(*context, batch.imageMemory);
}

LichenResult lichenVulkanCreateAssets(LichenVulkanContext context, LichenBundle bundle,
                                      LichenVulkanAssets* assets, LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    LichenBundleProperties properties;
    LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
    if (context == nullptr || assets == nullptr ||
        lichenGetBundleProperties(bundle, &properties) != LICHEN_SUCCESS) {
      writeDiagnostic(diagnostic, "context, bundle and assets must not be NULL");
      return LICHEN_ERROR_USAGE;
    }
    auto created = std::make_unique<LichenVulkanAssets_T>(context);
    created->images.resize(properties.imageCount);
    created->noises.resize(properties.noiseCount);
    LichenResult result = createImages(*created, bundle, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = createViews(*created, bundle, diagnostic);
    if (result == LICHEN_SUCCESS && properties.noiseCount > 0)
      result = createConstants(*created, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = createUpload(*created, bundle, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
    for (std::uint32_t i = 0; i < properties.noiseCount; ++i)
      planNoise(*created, bundle, i);
    *assets = created.release();
    return LICHEN_SUCCESS;
  });
}

void lichenVulkanDestroyAssets(LichenVulkanAssets assets) { delete assets; }

void lichenVulkanRetireAssets(LichenVulkanAssets assets, std::uint64_t lastFrame) {
  if (assets == nullptr)
    return;
  assets->lastFrame = lastFrame;
  assets->nextRetired = assets->context->retired;
  assets->context->retired = assets;
}

void lichenVulkanFrameCompleted(LichenVulkanContext context, std::uint64_t frame) {
  if (context == nullptr)
    return;
  for (LichenVulkanAssets* link = &context->retired; *link != nullptr;) {
    const LichenVulkanAssets assets = *link;
    if (assets->lastFrame > frame) {
      link = &assets->nextRetired;
    } else {
      *link = assets->nextRetired;
      delete assets;
    }
  }
}

void lichenVulkanReleaseStaging(LichenVulkanAssets assets) {
  if (assets == nullptr)
    return;
  const LichenVulkanContext_T& context = *assets->context;
  for (LichenVulkanAssets_T::Batch& batch : assets->batches) {
    context.functions.destroyBuffer(context.device, batch.staging, context.callbacks);
    batch.staging = VK_NULL_HANDLE;
    releaseMemory(context, batch.stagingMemory);
  }
  assets->hasStaging = false;
}

namespace {

/// Where and how commands write or read what was uploaded.
struct Scope {
  VkPipelineStageFlags stages;
  VkAccessFlags imageAccess, constantsAccess;
};
constexpr Scope kNothing{VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 0, 0};
constexpr Scope kCopies{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                        VK_ACCESS_TRANSFER_WRITE_BIT};
/// ALL_COMMANDS, because the host's shaders may run in any stage.
constexpr Scope kReads{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_SHADER_READ_BIT,
                       VK_ACCESS_UNIFORM_READ_BIT | VK_ACCESS_SHADER_READ_BIT};
/// The release of an ownership transfer orders nothing on its own queue: the semaphore that the
/// host signals waits for all commands.
constexpr Scope kAcquiredLater{VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0, 0};
/// The acquisition comes after that semaphore in whichever stage the host waits for it.
constexpr Scope kReleasedBefore{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0};

/// A transition of images and constants, from one queue family to another where they differ.
struct Transition {
  Scope before, after;
  VkImageLayout oldLayout, newLayout;
  std::uint32_t fromFamily = VK_QUEUE_FAMILY_IGNORED, toFamily = VK_QUEUE_FAMILY_IGNORED;
};

constexpr Transition kToCopies{kNothing, kCopies, VK_IMAGE_LAYOUT_UNDEFINED,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr Transition kToReads{kCopies, kReads, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                              VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

std::vector<VkImageMemoryBarrier> imageBarriers(const LichenVulkanAssets_T& assets,
                                                const Transition& transition) {
  std::vector<VkImageMemoryBarrier> barriers;
  for (const LichenVulkanAssets_T::Image& image : assets.images) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = transition.before.imageAccess;
    barrier.dstAccessMask = transition.after.imageAccess;
    barrier.oldLayout = transition.oldLayout;
    barrier.newLayout = transition.newLayout;
    barrier.srcQueueFamilyIndex = transition.fromFamily;
    barrier.dstQueueFamilyIndex = transition.toFamily;
    barrier.image = image.handle;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, image.mipLevels, 0, 1};
    barriers.push_back(barrier);
  }
  return barriers;
}

void recordTransition(const LichenVulkanAssets_T& assets, VkCommandBuffer commandBuffer,
                      const Transition& transition,
                      const std::vector<VkImageMemoryBarrier>& images) {
  VkBufferMemoryBarrier constants{};
  constants.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER;
  constants.srcAccessMask = transition.before.constantsAccess;
  constants.dstAccessMask = transition.after.constantsAccess;
  constants.srcQueueFamilyIndex = transition.fromFamily;
  constants.dstQueueFamilyIndex = transition.toFamily;
  constants.buffer = assets.constants;
  constants.size = VK_WHOLE_SIZE;
  assets.context->functions.cmdPipelineBarrier(
      commandBuffer, transition.before.stages, transition.after.stages, 0, 0, nullptr, 1,
      &constants, std::uint32_t(images.size()), images.data());
}

void recordCopies(const LichenVulkanAssets_T& assets, VkCommandBuffer commandBuffer) {
  const LichenVulkanFunctions& f = assets.context->functions;
  for (const LichenVulkanAssets_T::Image& image : assets.images)
    f.cmdCopyBufferToImage(commandBuffer, assets.batches[image.batch].staging, image.handle,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, std::uint32_t(image.copies.size()),
                           image.copies.data());
  f.cmdCopyBuffer(commandBuffer, assets.batches.back().staging, assets.constants, 1,
                  &assets.constantsCopy);
}

/// Copies, and a transition by the family that copies.
LichenResult recordUpload(LichenVulkanAssets assets, VkCommandBuffer commandBuffer,
                          const Transition& transition) {
  if (assets == nullptr || commandBuffer == VK_NULL_HANDLE)
    return LICHEN_ERROR_USAGE;
  if (assets->images.empty())
    return LICHEN_SUCCESS;
  if (!assets->hasStaging)
    return LICHEN_ERROR_USAGE; // staging is released
  return guarded(nullptr, [&] {
    // Allocate before the first command: a failure then records nothing.
    const std::vector<VkImageMemoryBarrier> toCopies = imageBarriers(*assets, kToCopies);
    const std::vector<VkImageMemoryBarrier> afterCopies = imageBarriers(*assets, transition);
    recordTransition(*assets, commandBuffer, kToCopies, toCopies);
    recordCopies(*assets, commandBuffer);
    recordTransition(*assets, commandBuffer, transition, afterCopies);
    return LICHEN_SUCCESS;
  });
}

} // namespace

LichenResult lichenVulkanRecordUpload(LichenVulkanAssets assets, VkCommandBuffer commandBuffer) {
  return recordUpload(assets, commandBuffer, kToReads);
}

LichenResult lichenVulkanRecordTransfer(LichenVulkanAssets assets, VkCommandBuffer commandBuffer,
                                        std::uint32_t transferFamily, std::uint32_t family) {
  if (transferFamily == family)
    return LICHEN_ERROR_USAGE;
  Transition release = kToReads;
  release.after = kAcquiredLater;
  release.fromFamily = transferFamily;
  release.toFamily = family;
  return recordUpload(assets, commandBuffer, release);
}

LichenResult lichenVulkanRecordAcquire(LichenVulkanAssets assets, VkCommandBuffer commandBuffer,
                                       std::uint32_t transferFamily, std::uint32_t family) {
  if (assets == nullptr || commandBuffer == VK_NULL_HANDLE || transferFamily == family)
    return LICHEN_ERROR_USAGE;
  if (assets->images.empty())
    return LICHEN_SUCCESS;
  Transition acquisition = kToReads;
  acquisition.before = kReleasedBefore;
  acquisition.fromFamily = transferFamily;
  acquisition.toFamily = family;
  return guarded(nullptr, [&] {
    recordTransition(*assets, commandBuffer, acquisition, imageBarriers(*assets, acquisition));
    return LICHEN_SUCCESS;
  });
}

LichenResult lichenVulkanAllocateSet(LichenVulkanAssets assets, std::uint32_t noise,
                                     VkDescriptorPool pool, const VkDescriptorBufferInfo* material,
                                     VkDescriptorSet* set, LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    if (assets == nullptr || noise >= assets->noises.size() || pool == VK_NULL_HANDLE ||
        material == nullptr || set == nullptr) {
      writeDiagnostic(
          diagnostic,
          "assets, pool, material and set must not be NULL, and noise must be in range");
      return LICHEN_ERROR_USAGE;
    }
    if (assets->context->setLayout == VK_NULL_HANDLE) {
      writeDiagnostic(
          diagnostic,
          "the host has given no Vulkan functions for sets; set the four descriptor set "
          "functions of LichenVulkanFunctions");
      return LICHEN_ERROR_USAGE;
    }
    const LichenVulkanContext_T& context = *assets->context;
    const LichenVulkanAssets_T::Noise& source = assets->noises[noise];
    if (source.isLayered && !context.hasLayers) {
      writeDiagnostic(diagnostic,
                      "noise %u is layered; create the context with the flag "
                      "LICHEN_VULKAN_LAYERS",
                      noise);
      return LICHEN_ERROR_USAGE;
    }
    const int least = source.isLayered ? LICHEN_LAYERED_MATERIAL_BYTES : LICHEN_MATERIAL_BYTES;
    if (material->buffer == VK_NULL_HANDLE || material->range < VkDeviceSize(least)) {
      writeDiagnostic(diagnostic,
                      "material needs a buffer and a range of at least %d bytes; its range is %llu",
                      least, static_cast<unsigned long long>(material->range));
      return LICHEN_ERROR_USAGE;
    }
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &context.setLayout;
    VkDescriptorSet created = VK_NULL_HANDLE;
    if (const VkResult result =
            context.functions.allocateDescriptorSets(context.device, &info, &created);
        result != VK_SUCCESS)
      return vulkanFailure("allocating a descriptor set", result, diagnostic);
    const VkDescriptorBufferInfo constants{
        assets->constants, noise * VkDeviceSize(LICHEN_NOISE_BYTES), LICHEN_NOISE_BYTES};
    // Samplers are immutable. The images' bindings follow each other: LICHEN_BINDING_*.
    std::array<VkWriteDescriptorSet, 2 + LICHEN_LAYERED_SET_IMAGES> writes{};
    for (VkWriteDescriptorSet& write : writes) {
      write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
      write.dstSet = created;
      write.descriptorCount = 1;
      write.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    }
    writes[0].dstBinding = context.firstBinding + LICHEN_BINDING_NOISE;
    writes[0].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    writes[0].pBufferInfo = &constants;
    writes[1].dstBinding = context.firstBinding + LICHEN_BINDING_MATERIAL;
    writes[1].descriptorType = context.materialType;
    writes[1].pBufferInfo = material;
    const std::uint32_t images = setImages(context);
    for (std::uint32_t i = 0; i < images; ++i) {
      writes[2 + i].dstBinding = context.firstBinding + LICHEN_BINDING_IMAGE(0) + i;
      writes[2 + i].pImageInfo = &source.imageInfos[i];
    }
    context.functions.updateDescriptorSets(context.device, 2 + images, writes.data(), 0, nullptr);
    *set = created;
    return LICHEN_SUCCESS;
  });
}

LichenResult lichenVulkanGetDescriptors(LichenVulkanAssets assets, std::uint32_t noise,
                                        VkDescriptorBufferInfo* constants,
                                        VkDescriptorImageInfo* images) {
  if (assets == nullptr || noise >= assets->noises.size() || constants == nullptr ||
      images == nullptr)
    return LICHEN_ERROR_USAGE;
  *constants = {assets->constants, noise * VkDeviceSize(LICHEN_NOISE_BYTES), LICHEN_NOISE_BYTES};
  const auto& source = assets->noises[noise].imageInfos;
  std::copy_n(source.begin(), setImages(*assets->context), images);
  return LICHEN_SUCCESS;
}
