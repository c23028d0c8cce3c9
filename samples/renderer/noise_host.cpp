// SPDX-License-Identifier: MIT
// Bundle -> plugin objects -> a set for each noise and a block for each material; see noise_host.h.
#include "noise_host.h"

#include "printable.h"

#include <lichen/bundle.h>

#include <algorithm>

namespace lichen::renderer {
namespace {

double clampTo(const NumberRange& range, double value) {
  return std::clamp(value, range.least, range.most);
}

LichenMapping codeOf(NoiseMapping mapping) {
  switch (mapping) {
  case NoiseMapping::triplanar:
    return LICHEN_MAPPING_TRIPLANAR;
  case NoiseMapping::solid:
    return LICHEN_MAPPING_SOLID;
  case NoiseMapping::uv:
    break;
  }
  return LICHEN_MAPPING_UV;
}

bool supports(const LichenNoiseProperties& noise, LichenMapping mapping) {
  return ((noise.mappings >> mapping) & 1u) != 0;
}

} // namespace

NoiseHost::NoiseHost(VulkanDevice& device, ObjectOwner& objects, const NoiseContext& context,
                     const Scene& scene)
    : materials_(scene.materials.size()) {
  for (std::size_t m = 0; m < materials_.size(); ++m) {
    materials_[m].own.noise = materials_[m].parameters.noise = LICHEN_NO_NOISE;
    materials_[m].displaces = scene.materials[m].displacement > 0.0f;
  }
  if (scene.noiseBundle.empty())
    return;
  loadBundle(device, context, scene);
  readNoises();
  readMaterials(scene);
  if (!noises_.empty())
    createSets(device, objects);
  change({});
}

void NoiseHost::loadBundle(VulkanDevice& device, const NoiseContext& context, const Scene& scene) {
  auto diagnostic = lichenStruct<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  auto parse = lichenStruct<LichenParseInfo>(LICHEN_STRUCTURE_PARSE_INFO);
  parse.headerVersion = LICHEN_HEADER_VERSION;
  parse.bytes = scene.noiseBundle.data();
  parse.byteCount = scene.noiseBundle.size();
  parse.name = scene.name.c_str();
  LichenBundle bundle = nullptr;
  checkLichen(lichenParseBundle(&parse, &bundle, &diagnostic), diagnostic);
  bundle_.reset(bundle);

  LichenVulkanAssets assets = nullptr;
  checkLichen(lichenVulkanCreateAssets(context.handle(), bundle, &assets, &diagnostic), diagnostic,
              scene.name);
  assets_.reset(assets);
  LichenResult recorded = LICHEN_SUCCESS;
  take(device.submit(
      [&](VkCommandBuffer commands) { recorded = lichenVulkanRecordUpload(assets, commands); }));
  checkLichen(recorded);
  lichenVulkanReleaseStaging(assets);
}

void NoiseHost::readNoises() {
  auto count = lichenStruct<LichenBundleProperties>(LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  checkLichen(lichenGetBundleProperties(bundle_.get(), &count));
  for (std::uint32_t n = 0; n < count.noiseCount; ++n) {
    auto noise = lichenStruct<LichenNoiseProperties>(LICHEN_STRUCTURE_NOISE_PROPERTIES);
    checkLichen(lichenGetNoiseProperties(bundle_.get(), n, &noise));
    noises_.push_back(noise);
  }
}

void NoiseHost::readMaterials(const Scene& scene) {
  auto count = lichenStruct<LichenBundleProperties>(LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  checkLichen(lichenGetBundleProperties(bundle_.get(), &count));
  const auto outOfRange = [&](const std::string& pointer, std::uint32_t set, const char* of) {
    return Failure{{ErrorKind::badInput, scene.name + ": " + pointer + ": texCoord " +
                                             std::to_string(set) + " of " + of +
                                             " is out of range; expected 0 or 1"}};
  };
  for (std::uint32_t m = 0; m < count.materialCount && m < materials_.size(); ++m) {
    MaterialState& material = materials_[m];
    LichenMaterialProperties& properties = material.properties;
    LICHEN_INIT(properties, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
    checkLichen(lichenGetMaterialProperties(bundle_.get(), m, &properties));
    const std::string pointer = "/materials/" + std::to_string(m);
    if (properties.unknownRevision != 0)
      fileNotes_.insert(pointer + ": this version does not know its noise's method or revision (" +
                        std::to_string(properties.unknownRevision) +
                        "); its core textures are used instead");
    if (properties.noise == LICHEN_NO_NOISE)
      continue;
    if (properties.texCoord > 1)
      throw outOfRange(pointer, properties.texCoord, "the noise");
    if (properties.mixSource == LICHEN_MIX_TEXTURE && properties.mixSet > 1)
      throw outOfRange(pointer, properties.mixSet, "the mix's mask");
    LICHEN_INIT(material.own, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
    checkLichen(lichenGetMaterialParameters(bundle_.get(), m, &material.own));
  }
}

void NoiseHost::createSets(VulkanDevice& device, ObjectOwner& objects) {
  std::array<VkDescriptorType, LICHEN_LAYERED_SET_BINDINGS> types{}; // in any order
  types.fill(VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE);
  types[0] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  types[1] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
  types[2] = types[3] = VK_DESCRIPTOR_TYPE_SAMPLER;
  const VkDescriptorPool pool = objects.pool(noises_.size(), types);
  blocks_ = UniformBlocks(device, materials_.size(), LICHEN_LAYERED_MATERIAL_BYTES);
  const VkDescriptorBufferInfo block = blocks_.descriptor().buffer;
  auto diagnostic = lichenStruct<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  sets_.resize(noises_.size());
  for (std::uint32_t n = 0; n < noises_.size(); ++n)
    checkLichen(lichenVulkanAllocateSet(assets_.get(), n, pool, &block, &sets_[n], &diagnostic),
                diagnostic);
}

/// A material's parameters with the changes.
LichenMaterialParameters NoiseHost::changed(const LichenMaterialParameters& own) const {
  LichenMaterialParameters parameters = own;
  parameters.scale = clampTo(kScaleRange, own.scale * changes_.scaleFactor);
  parameters.seed = own.seed + changes_.seedStep;
  parameters.contrast = clampTo(kContrastRange, own.contrast * changes_.contrastFactor);
  if (changes_.mapping)
    parameters.mapping = codeOf(*changes_.mapping);
  if (!supports(noises_[parameters.noise], parameters.mapping))
    parameters.mapping = LICHEN_MAPPING_TRIPLANAR; // also needs no texture coordinates
  return parameters;
}

void NoiseHost::change(const NoiseChanges& changes) {
  features_ = {};
  changes_ = changes;
  changeNotes_.clear();
  originNotes_.clear();
  for (std::size_t m = 0; m < materials_.size(); ++m) {
    MaterialState& material = materials_[m];
    if (material.own.noise == LICHEN_NO_NOISE)
      continue;
    material.parameters = changed(material.own);
    readUse(material);
    features_.objectSpaces = features_.objectSpaces || material.use.inObjectSpace;
    place(m);
  }
  features_.plain = switchesOf(false);
  features_.layered = switchesOf(true);
}

/// The switches that fit all materials whose noise has layers, or none.
NoiseSwitches NoiseHost::switchesOf(bool layered) const {
  std::vector<const LichenMaterialParameters*> materials;
  for (std::size_t m = 0; m < materials_.size(); ++m)
    if (hasNoise(m) && isLayered(m) == layered)
      materials.push_back(&materials_[m].parameters);
  if (materials.empty())
    return {};
  auto switches = lichenStruct<LichenShaderSwitches>(LICHEN_STRUCTURE_SHADER_SWITCHES);
  auto diagnostic = lichenStruct<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  checkLichen(lichenGetShaderSwitches(materials.data(), std::uint32_t(materials.size()), nullptr,
                                      &switches, &diagnostic),
              diagnostic);
  return {switches.methods, switches.mappings, switches.roles, switches.features};
}

void NoiseHost::readUse(MaterialState& material) {
  NoiseUse& use = material.use;
  use = {};
  use.texCoord = material.properties.texCoord;
  use.inObjectSpace = material.parameters.mapping != LICHEN_MAPPING_UV &&
                      material.properties.space == LICHEN_SPACE_OBJECT;
  const LichenNoiseProperties& noise = noises_[material.parameters.noise];
  for (std::uint32_t m = 0; m < noise.mapCount; ++m) {
    auto map = lichenStruct<LichenMapProperties>(LICHEN_STRUCTURE_MAP_PROPERTIES);
    checkLichen(lichenGetMapProperties(bundle_.get(), material.parameters.noise, m, &map));
    if (map.target == LICHEN_TARGET_HEIGHT && !material.displaces)
      changeNotes_.insert("the height map of the noise " + printable(noise.name) +
                          " is ignored; lichen-render --displace METRES shows it");
  }
}

void NoiseHost::setOrigin(const glm::dvec3& origin) {
  origin_ = origin;
  originNotes_.clear();
  for (std::size_t m = 0; m < materials_.size(); ++m)
    if (hasNoise(m))
      place(m);
}

std::vector<std::string> NoiseHost::notes() const {
  std::vector<std::string> all;
  for (const std::set<std::string>* notes : {&fileNotes_, &changeNotes_, &originNotes_})
    all.insert(all.end(), notes->begin(), notes->end());
  return all;
}

double NoiseHost::tileSide(std::size_t material) const {
  const LichenMaterialParameters& parameters = materials_[material].parameters;
  return hasNoise(material) && parameters.mapping != LICHEN_MAPPING_UV
             ? parameters.scale * noises_[parameters.noise].tileSizeMetres
             : 0.0;
}

/// Sets where a material's noise lies, and what positions it takes; see docs/integration.md,
/// "Far from the origin".
void NoiseHost::place(std::size_t material) {
  LichenPlacement& placement = materials_[material].placement;
  LICHEN_INIT(placement, LICHEN_STRUCTURE_PLACEMENT);
  NoiseUse& use = materials_[material].use;
  use.fromTileOrigin = glm::vec3(0.0f);
  const double side = tileSide(material);
  if (side == 0.0 || use.inObjectSpace)
    return;
  constexpr double kFarthest = 1099511627776; // 2^40 tiles, as LichenPlacement states
  const glm::dvec3 tiles = glm::floor(origin_ / side);
  const glm::dvec3 clamped = glm::clamp(tiles, -kFarthest, kFarthest);
  if (clamped != tiles)
    originNotes_.insert(
        "/materials/" + std::to_string(material) +
        ": the camera is more than 2^40 tiles of its noise from the world's origin; the noise "
        "there loses detail");
  use.fromTileOrigin = glm::vec3(origin_ - side * clamped);
  for (int axis = 0; axis < 3; ++axis)
    placement.tileOrigin[axis] = std::int64_t(clamped[axis]);
}

void NoiseHost::fillBlocks() const {
  auto diagnostic = lichenStruct<LichenDiagnostic>(LICHEN_STRUCTURE_DIAGNOSTIC);
  for (std::size_t m = 0; m < materials_.size(); ++m)
    if (hasNoise(m))
      checkLichen(lichenFillMaterial(&materials_[m].parameters, &materials_[m].placement,
                                     blocks_.data(m), &diagnostic),
                  diagnostic);
}

} // namespace lichen::renderer
