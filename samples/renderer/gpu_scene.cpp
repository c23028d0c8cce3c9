// SPDX-License-Identifier: MIT
// Uploads vertices, indices and textures, and creates a uniform block and a descriptor set per
// material.
#include "gpu_scene.h"

#include "failure.h"
#include "shaders/scene_interface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

namespace lichen::renderer {
namespace {

void uploadGeometry(VulkanDevice& device, const Scene& scene, GpuScene& gpu) {
  std::vector<Vertex> vertices;
  std::vector<VertexDisplacement> displacements;
  std::vector<std::uint32_t> indices;
  for (const Primitive& primitive : scene.primitives) {
    gpu.primitives.push_back({std::uint32_t(indices.size()),
                              std::uint32_t(primitive.indices.size()),
                              std::int32_t(vertices.size())});
    if (!primitive.displacement.empty()) { // the same indices select both
      displacements.resize(vertices.size());
      displacements.insert(displacements.end(), primitive.displacement.begin(),
                           primitive.displacement.end());
    }
    vertices.insert(vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
    indices.insert(indices.end(), primitive.indices.begin(), primitive.indices.end());
  }
  gpu.vertices =
      uploadBuffer(device, std::as_bytes(std::span(vertices)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  if (!displacements.empty())
    gpu.displacements = uploadBuffer(device, std::as_bytes(std::span(displacements)),
                                     VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  gpu.indices =
      uploadBuffer(device, std::as_bytes(std::span(indices)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

VkSamplerCreateInfo samplerInfo(const Sampler& sampler) {
  const auto filter = [](Filter f) {
    return f == Filter::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
  };
  const auto wrap = [](Wrap w) {
    if (w == Wrap::clampToEdge)
      return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    return w == Wrap::mirroredRepeat ? VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT
                                     : VK_SAMPLER_ADDRESS_MODE_REPEAT;
  };
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = filter(sampler.magnification);
  info.minFilter = filter(sampler.minification);
  info.mipmapMode = sampler.mip == Filter::nearest ? VK_SAMPLER_MIPMAP_MODE_NEAREST
                                                   : VK_SAMPLER_MIPMAP_MODE_LINEAR;
  info.addressModeU = wrap(sampler.wrapU);
  info.addressModeV = wrap(sampler.wrapV);
  // 0.25 instead of 0: with 0, Vulkan treats every texture as magnified [Vulkan,
  // VkSamplerCreateInfo].
  info.maxLod = sampler.mipmapped ? VK_LOD_CLAMP_NONE : 0.25f;
  return info;
}

/// Uploads each image once per use (colour or data), and creates each distinct sampler once.
class TextureCache {
public:
  TextureCache(VulkanDevice& device, ObjectOwner& objects, const Scene& scene, GpuScene& gpu)
      : device_(device), objects_(objects), scene_(scene), gpu_(gpu) {
    white_ = upload(TextureImage{1, 1, {255, 255, 255, 255}}, VK_FORMAT_R8G8B8A8_UNORM);
  }

  Descriptor descriptor(const TextureSlot& slot, bool isColor) {
    VkImageView view = white_;
    if (slot.image) {
      VkImageView& cached = views_[{*slot.image, isColor}];
      if (cached == VK_NULL_HANDLE)
        cached = upload(scene_.images[*slot.image],
                        isColor ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM);
      view = cached;
    }
    return sampledImage(sampler(slot.sampler), view);
  }

private:
  VkImageView upload(const TextureImage& image, VkFormat format) {
    DeviceImageInfo info;
    info.format = format;
    info.extent = {std::uint32_t(image.width), std::uint32_t(image.height), 1};
    info.mipLevels = fullMipCount(info.extent.width, info.extent.height);
    gpu_.images.push_back(uploadImage(device_, info, std::as_bytes(std::span(image.rgba)), true));
    return gpu_.images.back().view;
  }

  VkSampler sampler(const Sampler& settings) {
    for (const auto& [existing, handle] : samplers_)
      if (existing == settings)
        return handle;
    return samplers_.emplace_back(settings, objects_.sampler(samplerInfo(settings))).second;
  }

  VulkanDevice& device_;
  ObjectOwner& objects_;
  const Scene& scene_;
  GpuScene& gpu_;
  VkImageView white_ = VK_NULL_HANDLE;
  std::map<std::pair<std::size_t, bool>, VkImageView> views_;
  std::vector<std::pair<Sampler, VkSampler>> samplers_;
};

std::array<const TextureSlot*, MATERIAL_TEXTURES> slotsOf(const Material& material) {
  std::array<const TextureSlot*, MATERIAL_TEXTURES> slots{};
  slots[TEXTURE_BASE_COLOR] = &material.baseColorTexture;
  slots[TEXTURE_METALLIC_ROUGHNESS] = &material.metallicRoughnessTexture;
  slots[TEXTURE_NORMAL] = &material.normalTexture;
  slots[TEXTURE_OCCLUSION] = &material.occlusionTexture;
  slots[TEXTURE_EMISSIVE] = &material.emissiveTexture;
  slots[TEXTURE_MIX] = &material.mixTexture;
  return slots;
}

int alphaModeOf(const Material& material) {
  switch (material.alphaMode) {
  case AlphaMode::opaque:
    return ALPHA_OPAQUE;
  case AlphaMode::mask:
    return ALPHA_MASK;
  case AlphaMode::blend:
    break;
  }
  return ALPHA_BLEND;
}

shader::MaterialData materialData(const Material& material, const NoiseUse& noise) {
  shader::MaterialData data{};
  const bool masked = material.alphaMode == AlphaMode::mask;
  data.baseColor = material.baseColor;
  data.emissive = glm::vec4(material.emissive, masked ? material.alphaCutoff : 0.0f);
  data.factors = {material.metallic, material.roughness, material.normalScale,
                  material.occlusionStrength};
  const auto slots = slotsOf(material);
  for (int k = 0; k < 4; ++k)
    data.texCoords[k] = slots[std::size_t(k)]->texCoord;
  data.flags = {slots[TEXTURE_EMISSIVE]->texCoord, alphaModeOf(material), 0, int(noise.texCoord)};
  data.mixSource = {material.mixTexture.image ? MIX_FROM_MASK
                    : material.mixColorSet    ? MIX_FROM_VERTICES
                                              : MIX_FROM_BLOCK,
                    material.mixTexture.texCoord, material.mixChannel, noise.inObjectSpace ? 1 : 0};
  data.fromTileOrigin = glm::vec4(noise.fromTileOrigin, material.displacement);
  for (std::size_t k = 0; k < MATERIAL_TEXTURES; ++k) {
    // KHR_texture_transform: translation * rotation * scale.
    const TextureSlot& slot = *slots[k];
    const float c = std::cos(slot.rotation);
    const float s = std::sin(slot.rotation);
    data.transformRows[2 * k] = {c * slot.scale.x, s * slot.scale.y, slot.offset.x, 0.0f};
    data.transformRows[2 * k + 1] = {-s * slot.scale.x, c * slot.scale.y, slot.offset.y, 0.0f};
  }
  return data;
}

void createMaterials(VulkanDevice& device, ObjectOwner& objects, const Scene& scene,
                     GpuScene& gpu) {
  std::array<VkDescriptorType, 1 + MATERIAL_TEXTURES> types{};
  types.fill(VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  types[BINDING_MATERIAL] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
  // Displaced vertices read the material too.
  gpu.materialLayout = objects.setLayout(types, VK_SHADER_STAGE_ALL_GRAPHICS);
  const std::size_t count = scene.materials.size();
  const VkDescriptorPool pool = objects.pool(count, types);
  gpu.materialData = UniformBlocks(device, count, sizeof(shader::MaterialData));
  TextureCache textures(device, objects, scene, gpu);
  for (std::size_t m = 0; m < count; ++m) {
    std::array<Descriptor, 1 + MATERIAL_TEXTURES> descriptors{gpu.materialData.descriptor()};
    const auto slots = slotsOf(scene.materials[m]);
    for (std::size_t k = 0; k < slots.size(); ++k)
      descriptors[BINDING_TEXTURES + k] =
          textures.descriptor(*slots[k], k == TEXTURE_BASE_COLOR || k == TEXTURE_EMISSIVE);
    gpu.materialSets.push_back(objects.set(pool, gpu.materialLayout));
    writeSet(device.device(), gpu.materialSets.back(), descriptors);
  }
}

} // namespace

void writeMaterials(const Scene& scene, const NoiseHost& noises, const GpuScene& gpu) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const shader::MaterialData data = materialData(scene.materials[m], noises.use(m));
    std::memcpy(gpu.materialData.data(m), &data, sizeof data);
  }
}

Result<void> fitsDevice(const Scene& scene, const VkPhysicalDeviceLimits& limits) {
  const std::uint32_t longestSide = limits.maxImageDimension2D;
  for (const TextureImage& image : scene.images)
    if (std::uint32_t(std::max(image.width, image.height)) > longestSide)
      return Error{ErrorKind::environment,
                   scene.name + ": an image of " + std::to_string(image.width) + " x " +
                       std::to_string(image.height) + " is too large; this device supports up to " +
                       std::to_string(longestSide) + " x " + std::to_string(longestSide)};
  const std::size_t lastIndex = limits.maxDrawIndexedIndexValue;
  for (const Primitive& primitive : scene.primitives)
    if (primitive.vertices.size() - 1 > lastIndex)
      return Error{ErrorKind::environment,
                   scene.name + ": a primitive of " + std::to_string(primitive.vertices.size()) +
                       " vertices is too large; this device supports up to " +
                       std::to_string(lastIndex + 1)};
  return {};
}

GpuScene uploadScene(VulkanDevice& device, ObjectOwner& objects, const Scene& scene) {
  take(fitsDevice(scene, device.properties().limits));
  GpuScene gpu;
  uploadGeometry(device, scene, gpu);
  createMaterials(device, objects, scene, gpu);
  return gpu;
}

} // namespace lichen::renderer
