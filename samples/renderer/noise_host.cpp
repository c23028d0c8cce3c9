// SPDX-License-Identifier: MIT
// Bundle -> plugin objects -> a descriptor set for each material; see noise_host.h.
#include "noise_host.h"

#include "failure.h"
#include "printable.h"

#include <algorithm>
#include <optional>

namespace lichen::renderer {
namespace {

/// The role of a map in the shaders; nothing for the height, which is not drawn.
std::optional<std::size_t> roleOf(std::uint32_t target) {
  switch (target) {
  case LICHEN_TARGET_BASE_COLOR:
    return NOISE_BASE_COLOR;
  case LICHEN_TARGET_NORMAL:
    return NOISE_NORMAL;
  case LICHEN_TARGET_OCCLUSION_ROUGHNESS_METALLIC:
    return NOISE_ORM;
  case LICHEN_TARGET_EMISSIVE:
    return NOISE_EMISSIVE;
  case LICHEN_TARGET_OPACITY:
    return NOISE_OPACITY;
  default:
    return std::nullopt;
  }
}

template <class T>
T initialized(LichenStructureType type) {
  T object;
  LICHEN_INIT(object, type);
  return object;
}

ErrorKind kindOf(LichenResult result) {
  switch (result) {
  case LICHEN_ERROR_VERSION:
  case LICHEN_ERROR_BAD_BUNDLE:
    return ErrorKind::badInput;
  case LICHEN_ERROR_OUT_OF_HOST_MEMORY:
  case LICHEN_ERROR_OUT_OF_DEVICE_MEMORY:
    return ErrorKind::resources;
  default:
    return ErrorKind::environment;
  }
}

/// The plugin's result as the renderer's error; `file` where the diagnostic does not name it.
void check(LichenResult result, const LichenDiagnostic& diagnostic, const std::string& file = "") {
  if (result != LICHEN_SUCCESS)
    throw Failure{{kindOf(result), (file.empty() ? "" : file + ": ") + diagnostic.text}};
}

void check(LichenResult result) {
  check(result, LichenDiagnostic{LICHEN_STRUCTURE_DIAGNOSTIC, sizeof(LichenDiagnostic), nullptr,
                                 "the noise plugin refused a query"});
}

} // namespace

NoiseHost::NoiseHost(HeadlessDevice& device, ObjectOwner& objects, const Scene& scene)
    : noises_(scene.materials.size(), LICHEN_NO_NOISE), roles_(scene.materials.size()) {
  if (!scene.noiseBundle.empty())
    loadBundle(device, scene);
  createPlaceholders(device, objects);
  createSets(device, objects, scene.materials.size());
}

void NoiseHost::loadBundle(HeadlessDevice& device, const Scene& scene) {
  auto diagnostic = initialized<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  auto parse = initialized<LichenParseInfo>(LICHEN_STRUCTURE_PARSE_INFO);
  parse.headerVersion = LICHEN_HEADER_VERSION;
  parse.bytes = scene.noiseBundle.data();
  parse.byteCount = scene.noiseBundle.size();
  parse.name = scene.name.c_str();
  LichenBundle bundle = nullptr;
  check(lichenParseBundle(&parse, &bundle, &diagnostic), diagnostic);
  bundle_.reset(bundle);

  auto vulkan = initialized<LichenVulkanInfo>(LICHEN_STRUCTURE_VULKAN_INFO);
  vulkan.headerVersion = LICHEN_HEADER_VERSION;
  vulkan.physicalDevice = device.physicalDevice();
  vulkan.device = device.device();
  vulkan.getInstanceProcAddr = vkGetInstanceProcAddr;
  vulkan.instance = device.instance();
  LichenVulkanContext context = nullptr;
  check(lichenVulkanCreateContext(&vulkan, &context, &diagnostic), diagnostic, scene.name);
  context_.reset(context);
  LichenVulkanAssets assets = nullptr;
  check(lichenVulkanCreateAssets(context, bundle, &assets, &diagnostic), diagnostic, scene.name);
  assets_.reset(assets);
  LichenResult recorded = LICHEN_SUCCESS;
  take(device.submit(
      [&](VkCommandBuffer commands) { recorded = lichenVulkanRecordUpload(assets, commands); }));
  check(recorded);
  lichenVulkanReleaseStaging(assets);

  auto count = initialized<LichenBundleProperties>(LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  check(lichenGetBundleProperties(bundle, &count));
  for (std::uint32_t m = 0; m < count.materialCount && m < noises_.size(); ++m) {
    auto material = initialized<LichenMaterialProperties>(LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
    check(lichenGetMaterialProperties(bundle, m, &material));
    noises_[m] = material.noise;
    const std::string place = "/materials/" + std::to_string(m);
    if (material.unknownRevision != 0)
      notes_.insert(place + ": its noise is of revision " +
                    std::to_string(material.unknownRevision) +
                    ", which this version does not know; the core textures are drawn");
    if (material.noise == LICHEN_NO_NOISE)
      continue;
    hasSurfaceNoises_ = hasSurfaceNoises_ || material.mapping == LICHEN_MAPPING_SURFACE;
    hasTriplanarNoises_ = hasTriplanarNoises_ || material.mapping == LICHEN_MAPPING_TRIPLANAR;
    if (material.texCoord > 1)
      throw Failure{{ErrorKind::badInput, scene.name + ": " + place + ": texCoord " +
                                              std::to_string(material.texCoord) +
                                              " of the noise is not accepted, 0 or 1 is"}};
    if (material.mixSource == LICHEN_MIX_TEXTURE && material.mixSet > 1)
      throw Failure{{ErrorKind::badInput, scene.name + ": " + place + ": texCoord " +
                                              std::to_string(material.mixSet) +
                                              " of the mix's mask is not accepted, 0 or 1 is"}};
    roles_[m] = rolesOf(material.noise, material.texCoord);
  }
}

NoiseRoles NoiseHost::rolesOf(std::uint32_t noise, std::uint32_t texCoord) {
  NoiseRoles roles;
  roles.texCoord = texCoord;
  auto properties = initialized<LichenNoiseProperties>(LICHEN_STRUCTURE_NOISE_PROPERTIES);
  check(lichenGetNoiseProperties(bundle_.get(), noise, &properties));
  const bool isTiling = properties.method == LICHEN_NOISE_TILING;
  (isTiling ? hasTilingNoises_ : hasTextonNoises_) = true;
  hasMixes_ = hasMixes_ || properties.mixSteps > 1;
  for (std::uint32_t m = 0; m < properties.mapCount; ++m) {
    auto map = initialized<LichenMapProperties>(LICHEN_STRUCTURE_MAP_PROPERTIES);
    check(lichenGetMapProperties(bundle_.get(), noise, m, &map));
    hasOtherTables_ = hasOtherTables_ || (isTiling && map.tableKind != LICHEN_TABLE_JOINT);
    if (const std::optional<std::size_t> role = roleOf(map.target))
      roles.map[*role] = int(m);
    else
      notes_.insert("the height of the noise " + printable(properties.name) + " is not drawn");
    if (map.target == LICHEN_TARGET_OCCLUSION_ROUGHNESS_METALLIC)
      for (std::uint32_t c = 0; c < map.channelCount; ++c)
        if (map.channels[c] >= LICHEN_CHANNEL_OCCLUSION &&
            map.channels[c] <= LICHEN_CHANNEL_METALLIC)
          roles.ormComponents[std::size_t(map.channels[c] - LICHEN_CHANNEL_OCCLUSION)] = int(c);
  }
  return roles;
}

void NoiseHost::createPlaceholders(HeadlessDevice& device, ObjectOwner& objects) {
  constexpr std::array<std::uint8_t, 8> kWhite{255, 255, 255, 255, 255, 255, 255, 255};
  const auto bytes = std::as_bytes(std::span(kWhite));
  DeviceImageInfo info;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  placeholder2d_ = uploadImage(device, info, bytes.first(4), false);
  info.extent.depth = 2; // a depth of 1 would be a 2-D image
  placeholder3d_ = uploadImage(device, info, bytes, false);
  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  placeholderSampler_ = objects.sampler(sampler);
}

std::array<VkDescriptorImageInfo, 2 * NOISE_ROLES>
NoiseHost::imageInfos(std::uint32_t noise, const NoiseRoles& roles) const {
  std::array<VkDescriptorImageInfo, 2 * NOISE_ROLES> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i)
    infos[i] = {placeholderSampler_, i % 2 == 0 ? placeholder2d_.view : placeholder3d_.view,
                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  if (noise == LICHEN_NO_NOISE)
    return infos;
  auto properties = initialized<LichenNoiseProperties>(LICHEN_STRUCTURE_NOISE_PROPERTIES);
  check(lichenGetNoiseProperties(bundle_.get(), noise, &properties));
  std::vector<VkDescriptorImageInfo> all(properties.combinedImageSamplerCount);
  check(lichenVulkanGetImageInfos(assets_.get(), noise, all.data()));
  for (std::size_t role = 0; role < NOISE_ROLES; ++role)
    if (roles.map[role] >= 0) {
      infos[2 * role] = all[2 * std::size_t(roles.map[role])];
      infos[2 * role + 1] = all[2 * std::size_t(roles.map[role]) + 1];
    }
  return infos;
}

void NoiseHost::createSets(HeadlessDevice& device, ObjectOwner& objects, std::size_t materials) {
  std::array<VkDescriptorType, 1 + 2 * NOISE_ROLES> types{};
  types.fill(VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  types[BINDING_NOISE] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  setLayout_ = objects.setLayout(types, VK_SHADER_STAGE_FRAGMENT_BIT);
  uniforms_ = take(device.createBuffer(VkDeviceSize(LICHEN_UNIFORM_BYTES) * materials,
                                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true));
  std::fill_n(uniforms_.mapped, uniforms_.size, std::byte{0});
  const VkDescriptorPool pool = objects.pool(materials, types);
  auto diagnostic = initialized<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  for (std::uint32_t m = 0; m < materials; ++m) {
    if (noises_[m] != LICHEN_NO_NOISE) {
      auto info = initialized<LichenUniformInfo>(LICHEN_STRUCTURE_UNIFORM_INFO);
      info.material = m;
      check(lichenFillUniforms(bundle_.get(), &info,
                               uniforms_.mapped + VkDeviceSize(LICHEN_UNIFORM_BYTES) * m,
                               &diagnostic),
            diagnostic);
    }
    sets_.push_back(objects.set(pool, setLayout_));
    std::array<Descriptor, 1 + 2 * NOISE_ROLES> descriptors{uniformBlock(
        uniforms_.handle, VkDeviceSize(LICHEN_UNIFORM_BYTES) * m, LICHEN_UNIFORM_BYTES)};
    const auto images = imageInfos(noises_[m], roles_[m]);
    for (std::size_t i = 0; i < images.size(); ++i)
      descriptors[BINDING_NOISE_ROLES + i] = {
          VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, {}, images[i]};
    writeSet(device.device(), sets_.back(), descriptors);
  }
}

} // namespace lichen::renderer
