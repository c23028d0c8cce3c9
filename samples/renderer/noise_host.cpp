// SPDX-License-Identifier: MIT
// Bundle -> plugin objects -> a descriptor set per material; see noise_host.h.
#include "noise_host.h"

#include "failure.h"
#include "printable.h"

#include <lichen/bundle.h>

#include <algorithm>
#include <optional>

namespace lichen::renderer {
namespace {

/// The role of a map in the shaders; nullopt for height, which is not rendered.
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

double clampTo(const NumberRange& range, double value) {
  return std::clamp(value, range.least, range.most);
}

LichenMapping codeOf(NoiseMapping mapping) {
  switch (mapping) {
  case NoiseMapping::triplanar:
    return LICHEN_MAPPING_TRIPLANAR;
  case NoiseMapping::surface:
    return LICHEN_MAPPING_SURFACE;
  case NoiseMapping::uv:
    break;
  }
  return LICHEN_MAPPING_UV;
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

/// Throws the plugin's error as a Failure. `file` names the file if the diagnostic does not.
void check(LichenResult result, const LichenDiagnostic& diagnostic, const std::string& file = "") {
  if (result != LICHEN_SUCCESS)
    throw Failure{{kindOf(result), (file.empty() ? "" : file + ": ") + diagnostic.text}};
}

void check(LichenResult result) {
  check(result, LichenDiagnostic{LICHEN_STRUCTURE_DIAGNOSTIC, sizeof(LichenDiagnostic), nullptr,
                                 "the noise plugin failed to answer a query"});
}

} // namespace

NoiseHost::NoiseHost(VulkanDevice& device, ObjectOwner& objects, const Scene& scene)
    : noises_(scene.materials.size(), LICHEN_NO_NOISE), roles_(scene.materials.size()) {
  if (!scene.noiseBundle.empty())
    loadBundle(device, scene);
  createPlaceholders(device, objects);
  createSets(device, objects, scene.materials.size());
  change(device.device(), {});
}

void NoiseHost::loadBundle(VulkanDevice& device, const Scene& scene) {
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
  readMaterials(scene);
}

void NoiseHost::readMaterials(const Scene& scene) {
  auto count = initialized<LichenBundleProperties>(LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  check(lichenGetBundleProperties(bundle_.get(), &count));
  for (std::uint32_t n = 0; n < count.noiseCount; ++n) {
    auto noise = initialized<LichenNoiseProperties>(LICHEN_STRUCTURE_NOISE_PROPERTIES);
    check(lichenGetNoiseProperties(bundle_.get(), n, &noise));
    names_.emplace_back(noise.name);
  }
  for (std::uint32_t m = 0; m < count.materialCount && m < noises_.size(); ++m) {
    auto material = initialized<LichenMaterialProperties>(LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
    check(lichenGetMaterialProperties(bundle_.get(), m, &material));
    materials_.push_back(material);
    const std::string pointer = "/materials/" + std::to_string(m);
    if (material.unknownRevision != 0)
      fileNotes_.insert(pointer + ": this version does not know its noise's method or revision (" +
                        std::to_string(material.unknownRevision) +
                        "); its core textures are used instead");
    if (material.noise == LICHEN_NO_NOISE)
      continue;
    if (material.texCoord > 1)
      throw Failure{{ErrorKind::badInput, scene.name + ": " + pointer + ": texCoord " +
                                              std::to_string(material.texCoord) +
                                              " of the noise is out of range; expected 0 or 1"}};
    if (material.mixSource == LICHEN_MIX_TEXTURE && material.mixSet > 1)
      throw Failure{{ErrorKind::badInput, scene.name + ": " + pointer + ": texCoord " +
                                              std::to_string(material.mixSet) +
                                              " of the mix's mask is out of range; expected 0 "
                                              "or 1"}};
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
    hasGaussianOnly_ = hasGaussianOnly_ || (isTiling && map.tableKind == LICHEN_TABLE_NONE);
    if (const std::optional<std::size_t> role = roleOf(map.target))
      roles.map[*role] = int(m);
    else
      changeNotes_.insert("the height map of the noise " + printable(properties.name) +
                          " is ignored: this renderer does not displace surfaces");
    if (map.target == LICHEN_TARGET_OCCLUSION_ROUGHNESS_METALLIC)
      for (std::uint32_t c = 0; c < map.channelCount; ++c)
        if (map.channels[c] >= LICHEN_CHANNEL_OCCLUSION &&
            map.channels[c] <= LICHEN_CHANNEL_METALLIC)
          roles.ormComponents[std::size_t(map.channels[c] - LICHEN_CHANNEL_OCCLUSION)] = int(c);
  }
  return roles;
}

void NoiseHost::createPlaceholders(VulkanDevice& device, ObjectOwner& objects) {
  constexpr std::array<std::uint8_t, 8> kWhite{255, 255, 255, 255, 255, 255, 255, 255};
  const auto bytes = std::as_bytes(std::span(kWhite));
  DeviceImageInfo info;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  placeholder2d_ = uploadImage(device, info, bytes.first(4), false);
  info.extent.depth = 2; // createImage() makes a 2-D image for a depth of 1
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

void NoiseHost::createSets(VulkanDevice& device, ObjectOwner& objects, std::size_t materials) {
  std::array<VkDescriptorType, 1 + 2 * NOISE_ROLES> types{};
  types.fill(VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  types[BINDING_NOISE] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  setLayout_ = objects.setLayout(types, VK_SHADER_STAGE_FRAGMENT_BIT);
  uniforms_ = take(device.createBuffer(VkDeviceSize(LICHEN_UNIFORM_BYTES) * materials,
                                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true));
  std::fill_n(uniforms_.mapped, uniforms_.size, std::byte{0});
  const VkDescriptorPool pool = objects.pool(materials, types);
  for (std::size_t m = 0; m < materials; ++m)
    sets_.push_back(objects.set(pool, setLayout_));
}

/// Uniform values of a material's noise: the file's own where there are no changes.
LichenUniformInfo NoiseHost::uniformInfo(std::uint32_t material) const {
  const LichenMaterialProperties& own = materials_[material];
  const NoiseChanges& changes = changes_;
  auto info = initialized<LichenUniformInfo>(LICHEN_STRUCTURE_UNIFORM_INFO);
  info.material = material;
  if (changes == NoiseChanges{})
    return info;
  info.overrides = LICHEN_OVERRIDE_SCALE | LICHEN_OVERRIDE_SEED | LICHEN_OVERRIDE_BLEND_SHARPNESS |
                   LICHEN_OVERRIDE_PLANE_SHARPNESS | LICHEN_OVERRIDE_CONTRAST |
                   LICHEN_OVERRIDE_TILE_ROTATION;
  info.scale = clampTo(kScaleRange, own.scale * changes.scaleFactor);
  info.seed = own.seed + changes.seedStep;
  info.blendSharpness =
      clampTo(kBlendSharpnessRange, own.blendSharpness * changes.blendSharpnessFactor);
  info.planeSharpness =
      clampTo(kPlaneSharpnessRange, own.planeSharpness * changes.planeSharpnessFactor);
  info.contrast = clampTo(kContrastRange, own.contrast * changes.contrastFactor);
  info.tileRotation = changes.tileRotation.value_or(own.tileRotation);
  LichenMapping mapping = changes.mapping ? codeOf(*changes.mapping) : own.mapping;
  if (changes.noise && *changes.noise != own.noise) {
    // With another noise, the plugin reads nothing of the material: pass its values.
    info.overrides |= LICHEN_OVERRIDE_NOISE | LICHEN_OVERRIDE_OFFSET | LICHEN_OVERRIDE_ROTATION |
                      LICHEN_OVERRIDE_IMPACTS | LICHEN_OVERRIDE_POINT_PROCESS;
    info.noise = *changes.noise;
    info.offset[0] = own.offset[0];
    info.offset[1] = own.offset[1];
    info.rotation = own.rotation;
    info.impacts = own.impacts;
    info.pointProcess = own.pointProcess;
    auto noise = initialized<LichenNoiseProperties>(LICHEN_STRUCTURE_NOISE_PROPERTIES);
    check(lichenGetNoiseProperties(bundle_.get(), info.noise, &noise));
    if (mapping == LICHEN_MAPPING_SURFACE && noise.method != LICHEN_NOISE_TEXTON)
      mapping = LICHEN_MAPPING_TRIPLANAR; // also needs no texture coordinates
  }
  if (changes.mapping || info.overrides & LICHEN_OVERRIDE_NOISE) {
    info.overrides |= LICHEN_OVERRIDE_MAPPING;
    info.mapping = mapping;
  }
  return info;
}

void NoiseHost::change(VkDevice device, const NoiseChanges& changes) {
  if (changes.noise && *changes.noise >= names_.size())
    throw Failure{{ErrorKind::usage, "noise " + std::to_string(*changes.noise) +
                                         " does not exist; the bundle has " +
                                         std::to_string(names_.size())}};
  hasGaussianOnly_ = hasTilingNoises_ = hasTextonNoises_ = hasSurfaceNoises_ = hasTriplanarNoises_ =
      hasOtherMappings_ = hasMixes_ = hasObjectSpaces_ = hasTileRotation_ = false;
  changes_ = changes;
  changeNotes_.clear();
  originNotes_.clear();
  for (std::uint32_t m = 0; m < sets_.size(); ++m) {
    if (m < materials_.size() && materials_[m].noise != LICHEN_NO_NOISE) {
      noises_[m] = changes.noise.value_or(materials_[m].noise);
      roles_[m] = rolesOf(noises_[m], materials_[m].texCoord);
      const LichenMapping mapping = mappingOf(uniformInfo(m));
      hasSurfaceNoises_ = hasSurfaceNoises_ || mapping == LICHEN_MAPPING_SURFACE;
      hasTriplanarNoises_ = hasTriplanarNoises_ || mapping == LICHEN_MAPPING_TRIPLANAR;
      hasOtherMappings_ = hasOtherMappings_ || mapping != LICHEN_MAPPING_TRIPLANAR;
      roles_[m].inObjectSpace =
          mapping != LICHEN_MAPPING_UV &&
          changes.inObjectSpace.value_or(materials_[m].space == LICHEN_SPACE_OBJECT);
      hasObjectSpaces_ = hasObjectSpaces_ || roles_[m].inObjectSpace;
      hasTileRotation_ =
          hasTileRotation_ || changes.tileRotation.value_or(materials_[m].tileRotation) > 1;
      fillUniforms(m);
    }
    writeNoiseSet(device, m);
  }
}

void NoiseHost::setOrigin(const glm::dvec3& origin) {
  origin_ = origin;
  originNotes_.clear();
  for (std::uint32_t m = 0; m < materials_.size(); ++m)
    if (materials_[m].noise != LICHEN_NO_NOISE)
      fillUniforms(m);
}

std::vector<std::string> NoiseHost::notes() const {
  std::vector<std::string> all;
  for (const std::set<std::string>* notes : {&fileNotes_, &changeNotes_, &originNotes_})
    all.insert(all.end(), notes->begin(), notes->end());
  return all;
}

LichenMapping NoiseHost::mappingOf(const LichenUniformInfo& info) const {
  return info.overrides & LICHEN_OVERRIDE_MAPPING ? info.mapping
                                                  : materials_[info.material].mapping;
}

double NoiseHost::tileSide(const LichenUniformInfo& info) const {
  if (mappingOf(info) == LICHEN_MAPPING_UV)
    return 0.0;
  auto noise = initialized<LichenNoiseProperties>(LICHEN_STRUCTURE_NOISE_PROPERTIES);
  check(lichenGetNoiseProperties(bundle_.get(), noises_[info.material], &noise));
  const double scale =
      info.overrides & LICHEN_OVERRIDE_SCALE ? info.scale : materials_[info.material].scale;
  return scale * noise.tileSizeMetres;
}

double NoiseHost::tileSide(std::size_t material) const {
  return hasNoise(material) ? tileSide(uniformInfo(std::uint32_t(material))) : 0.0;
}

/// Sets the tile origin of a noise in world space; see docs/integration.md, "Precision".
void NoiseHost::setTileOrigin(LichenUniformInfo& info) {
  NoiseRoles& roles = roles_[info.material];
  roles.fromTileOrigin = glm::vec3(0.0f);
  const double side = tileSide(info);
  if (side == 0.0 || roles.inObjectSpace)
    return;
  constexpr double kFarthest = 1099511627776; // 2^40 tiles, as LichenUniformInfo states
  const glm::dvec3 tiles = glm::floor(origin_ / side);
  const glm::dvec3 clamped = glm::clamp(tiles, -kFarthest, kFarthest);
  if (clamped != tiles)
    originNotes_.insert(
        "/materials/" + std::to_string(info.material) +
        ": the camera is more than 2^40 tiles of its noise from the world's origin; the noise "
        "there loses detail");
  roles.fromTileOrigin = glm::vec3(origin_ - side * clamped);
  info.tileOrigin[0] = std::int64_t(clamped.x);
  info.tileOrigin[1] = std::int64_t(clamped.y);
  info.tileOriginZ = std::int64_t(clamped.z);
}

void NoiseHost::fillUniforms(std::uint32_t material) {
  LichenUniformInfo info = uniformInfo(material);
  setTileOrigin(info);
  auto diagnostic = initialized<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  check(lichenFillUniforms(bundle_.get(), &info,
                           uniforms_.mapped + VkDeviceSize(LICHEN_UNIFORM_BYTES) * material,
                           &diagnostic),
        diagnostic);
}

void NoiseHost::writeNoiseSet(VkDevice device, std::size_t material) const {
  std::array<Descriptor, 1 + 2 * NOISE_ROLES> descriptors{uniformBlock(
      uniforms_.handle, VkDeviceSize(LICHEN_UNIFORM_BYTES) * material, LICHEN_UNIFORM_BYTES)};
  const auto images = imageInfos(noises_[material], roles_[material]);
  for (std::size_t i = 0; i < images.size(); ++i)
    descriptors[BINDING_NOISE_ROLES + i] = {
        VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, {}, images[i]};
  writeSet(device, sets_[material], descriptors);
}

} // namespace lichen::renderer
