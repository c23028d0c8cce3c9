// SPDX-License-Identifier: MIT
// The plan layer: bundle bytes -> images, copies, samplers, bindings. Pure CPU code. Uses Vulkan's
// numbers of formats and samplers without including a Vulkan header.
#include "plan.h"

#include "abi.h"

#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <memory>
#include <methods/method_parameters.h>
#include <string>

using namespace lichen;
using namespace lichen::plugin;

namespace {

// Enumerations of the bundle have the interface's numbers.
static_assert(int(MapTarget::opacity) == LICHEN_TARGET_OPACITY);
static_assert(int(MapChannel::opacity) == LICHEN_CHANNEL_OPACITY);
static_assert(int(Mapping::solid) == LICHEN_MAPPING_SOLID);
static_assert(int(MixSource::vertexColor) == LICHEN_MIX_VERTEX_COLOR);
static_assert(int(NoiseSpace::object) == LICHEN_SPACE_OBJECT);
static_assert(int(PointProcess::poisson) == LICHEN_POINT_PROCESS_POISSON);

/// What is bound where a noise lacks a map, or a map a table: shaders declare it and never read it.
Table placeholder(bool isTable) {
  return {isTable ? "no table" : "no image", TexelFormat::rgba8Unorm, 1, 1, isTable ? 1u : 0u, 1,
          std::vector<std::byte>(4)};
}

/// Plans a noise's block and the images of its roles. Appends the tables of mixes to the bundle's.
LichenBundle_T::NoisePlan planNoise(LichenBundle_T& plan, std::size_t index, std::uint32_t noImage,
                                    std::uint32_t noTable) {
  const Noise& noise = plan.bundle.noises[index];
  LichenBundle_T::NoisePlan result;
  result.constants = shaderConstants(plan.bundle, index);
  result.images.fill(noImage);
  result.tables.fill(noTable);
  result.indices.fill(noImage);
  const MethodParameters& method = parametersOf(noise);
  for (const NoiseMap& map : noise.maps) {
    const std::uint32_t role = roleOf(map.target);
    const std::size_t image = imageTableOf(map);
    const Table& table = plan.bundle.tables[image];
    assert(table.mipLevels <= LICHEN_MAX_MIPS);
    result.images[role] = std::uint32_t(image);
    plan.showsGreenAsAlpha[image] = method.lastChannelIsAlpha && channelCount(table.format) == 2;
    plan.fetchedOnly[image] = method.readsTexels;
    if (const std::optional<std::size_t> inverse = decodingTableOf(map))
      result.tables[role] = std::uint32_t(*inverse);
    static_assert(LICHEN_BINDING_CELLS == LICHEN_BINDING_INDEX(0));
    if (method.sharedImage != nullptr)
      result.indices[0] = std::uint32_t(method.sharedImage(map));
    if (isMix(noise)) {
      plan.bundle.tables.push_back(mixTable(map));
      plan.showsGreenAsAlpha.push_back(false);
      plan.fetchedOnly.push_back(false);
      result.tables[role] = std::uint32_t(plan.bundle.tables.size() - 1);
    }
  }
  return result;
}

/// Plans what a noise shows of others: places the images of its other layers in its slots, and the
/// images of its index maps.
void planLayers(LichenBundle_T& plan, std::size_t index) {
  const Noise& noise = plan.bundle.noises[index];
  LichenBundle_T::NoisePlan& result = plan.noises[index];
  for (const Mapping mapping : {Mapping::uv, Mapping::triplanar, Mapping::surface, Mapping::solid})
    if (mappingObstacle(plan.bundle, index, mapping).empty())
      result.mappings |= 1u << unsigned(mapping);
  result.layers.fill(LICHEN_NO_NOISE);
  result.indexNoises.fill(LICHEN_NO_NOISE);
  result.layers[0] = std::uint32_t(index);
  result.layerCount = 1;
  if (!noise.layers)
    return;
  for (const std::size_t other : noise.layers->others) {
    const std::size_t layer = result.layerCount++;
    result.layers[layer] = std::uint32_t(other);
    for (const NoiseMap& map : plan.bundle.noises[other].maps) {
      const std::uint32_t role = roleOf(map.target);
      result.images[layerSlot(layer, role)] = plan.noises[other].images[role];
      result.tables[layerSlot(layer, role)] = plan.noises[other].tables[role];
    }
  }
  for (std::size_t node = 0; node < noise.layers->nodes.size(); ++node) {
    const std::size_t map = noise.layers->nodes[node].index;
    result.indexNoises[node] = std::uint32_t(map);
    result.indices[node] = std::uint32_t(imageTableOf(plan.bundle.noises[map].maps.front()));
  }
}

void planBundle(LichenBundle_T& plan) {
  const auto append = [&](Table table) {
    plan.bundle.tables.push_back(std::move(table));
    return std::uint32_t(plan.bundle.tables.size() - 1);
  };
  if (!plan.bundle.noises.empty()) {
    const std::uint32_t noImage = append(placeholder(false));
    const std::uint32_t noTable = append(placeholder(true));
    plan.showsGreenAsAlpha.resize(plan.bundle.tables.size());
    plan.fetchedOnly.resize(plan.bundle.tables.size());
    for (std::size_t noise = 0; noise < plan.bundle.noises.size(); ++noise)
      plan.noises.push_back(planNoise(plan, noise, noImage, noTable));
    for (std::size_t noise = 0; noise < plan.bundle.noises.size(); ++noise)
      planLayers(plan, noise);
  }
  for (const Table& table : plan.bundle.tables)
    plan.extents.push_back(
        {table.width, table.height, std::max(1u, table.depth), table.depth == 0 ? 2u : 3u});
  plan.unknownRevisions.resize(plan.bundle.materials.size());
  for (const IgnoredNoise& noise : plan.bundle.ignoredNoises)
    for (const std::size_t material : noise.materials)
      plan.unknownRevisions[material] = std::uint32_t(std::max(1, noise.revision));
}

LichenResult resultOf(ErrorKind kind) {
  return kind == ErrorKind::resources ? LICHEN_ERROR_OUT_OF_HOST_MEMORY : LICHEN_ERROR_BAD_BUNDLE;
}

LichenResult checkInterfaceVersion(std::uint32_t version, LichenDiagnostic* diagnostic) {
  if (version == 0 || version == LICHEN_INTERFACE_VERSION)
    return LICHEN_SUCCESS;
  writeDiagnostic(
      diagnostic,
      "the shaders have interface version %u, this library has %d; compile them with the "
      "shaders_glsl/ of this library",
      version, LICHEN_INTERFACE_VERSION);
  return LICHEN_ERROR_VERSION;
}

} // namespace

std::uint32_t lichenGetVersion() { return LICHEN_HEADER_VERSION; }

LichenResult lichenParseBundle(const LichenParseInfo* hostInfo, LichenBundle* bundle,
                               LichenDiagnostic* diagnostic) {
  return guarded(diagnostic, [&] {
    LichenParseInfo info{};
    LichenResult result = readStruct(hostInfo, LICHEN_STRUCTURE_PARSE_INFO, info, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkHeaderVersion(info.headerVersion, diagnostic);
    if (result == LICHEN_SUCCESS)
      result = checkInterfaceVersion(info.interfaceVersion, diagnostic);
    if (result != LICHEN_SUCCESS)
      return result;
    if (bundle == nullptr || info.bytes == nullptr) {
      writeDiagnostic(diagnostic, "bundle and bytes must not be NULL");
      return LICHEN_ERROR_USAGE;
    }
    const std::span bytes(static_cast<const std::byte*>(info.bytes), info.byteCount);
    const char* name = info.name != nullptr ? info.name : "bundle";
    Result<Bundle> parsed = parseBundle(bytes, name);
    if (!parsed) {
      writeDiagnostic(diagnostic, "%s", parsed.error().message.c_str());
      return resultOf(parsed.error().kind);
    }
    auto plan = std::make_unique<LichenBundle_T>();
    plan->bundle = std::move(parsed).value();
    planBundle(*plan);
    *bundle = plan.release();
    return LICHEN_SUCCESS;
  });
}

void lichenDestroyBundle(LichenBundle bundle) { delete bundle; }

LichenResult lichenGetBundleProperties(LichenBundle bundle, LichenBundleProperties* properties) {
  if (bundle == nullptr)
    return LICHEN_ERROR_USAGE;
  LichenBundleProperties values{};
  values.noiseCount = std::uint32_t(bundle->bundle.noises.size());
  values.materialCount = std::uint32_t(bundle->bundle.materials.size());
  values.imageCount = std::uint32_t(bundle->bundle.tables.size());
  return writeStruct(values, LICHEN_STRUCTURE_BUNDLE_PROPERTIES, properties);
}

LichenResult lichenGetNoiseProperties(LichenBundle bundle, std::uint32_t noise,
                                      LichenNoiseProperties* properties) {
  if (bundle == nullptr || noise >= bundle->bundle.noises.size())
    return LICHEN_ERROR_USAGE;
  const Noise& source = bundle->bundle.noises[noise];
  LichenNoiseProperties values{};
  values.name = source.name.c_str();
  values.mapCount = std::uint32_t(source.maps.size());
  values.tileSizeMetres = source.tileSizeMetres;
  values.method = LichenNoiseMethod(source.method());
  const LichenBundle_T::NoisePlan& plan = bundle->noises[noise];
  values.mixSteps =
      isMix(source) ? bundle->extents[plan.tables[roleOf(source.maps[0].target)]].width : 1;
  values.takesQuarterTurns = takesTileRotation(bundle->bundle, noise, 4) ? 1 : 0;
  values.mappings = plan.mappings;
  values.layerCount = plan.layerCount;
  std::copy(plan.layers.begin(), plan.layers.end(), values.layers);
  std::copy(plan.indexNoises.begin(), plan.indexNoises.end(), values.indices);
  return writeStruct(values, LICHEN_STRUCTURE_NOISE_PROPERTIES, properties);
}

LichenResult lichenGetMapProperties(LichenBundle bundle, std::uint32_t noise, std::uint32_t map,
                                    LichenMapProperties* properties) {
  if (bundle == nullptr || noise >= bundle->bundle.noises.size() ||
      map >= bundle->bundle.noises[noise].maps.size())
    return LICHEN_ERROR_USAGE;
  const NoiseMap& source = bundle->bundle.noises[noise].maps[map];
  LichenMapProperties values{};
  values.target = LichenMapTarget(source.target);
  values.channelCount = std::uint32_t(source.channels.size());
  std::transform(source.channels.begin(), source.channels.end(), values.channels,
                 [](MapChannel channel) { return LichenChannel(channel); });
  values.image = std::uint32_t(imageTableOf(source));
  values.tableImage = bundle->noises[noise].tables[roleOf(source.target)];
  return writeStruct(values, LICHEN_STRUCTURE_MAP_PROPERTIES, properties);
}

LichenResult lichenGetMaterialProperties(LichenBundle bundle, std::uint32_t material,
                                         LichenMaterialProperties* properties) {
  if (bundle == nullptr || material >= bundle->bundle.materials.size())
    return LICHEN_ERROR_USAGE;
  LichenMaterialProperties values{};
  values.noise = LICHEN_NO_NOISE;
  values.unknownRevision = bundle->unknownRevisions[material];
  if (const auto& source = bundle->bundle.materials[material]) {
    values.noise = std::uint32_t(source->noise);
    values.mapping = LichenMapping(source->mapping);
    values.texCoord = std::uint32_t(source->texCoord);
    values.space = LichenSpace(source->space);
    values.mixSource = LichenMixSource(source->mix.source);
    values.mixTexture = std::uint32_t(source->mix.texture);
    values.mixSet = std::uint32_t(source->mix.source == MixSource::texture ? source->mix.texCoord
                                                                           : source->mix.colorSet);
    values.mixChannel = std::uint32_t(source->mix.channel);
  }
  return writeStruct(values, LICHEN_STRUCTURE_MATERIAL_PROPERTIES, properties);
}

LichenResult lichenGetImageProperties(LichenBundle bundle, std::uint32_t image,
                                      LichenImageProperties* properties) {
  if (bundle == nullptr || image >= bundle->bundle.tables.size())
    return LICHEN_ERROR_USAGE;
  const Table& table = bundle->bundle.tables[image];
  const LichenBundle_T::Extent& extent = bundle->extents[image];
  LichenImageProperties values{};
  values.name = table.name.c_str();
  values.vkFormat = vkFormatOf(table.format);
  values.dimensionality = extent.dimensionality;
  values.width = extent.width;
  values.height = extent.height;
  values.depth = extent.depth;
  values.mipLevels = table.mipLevels;
  values.texelBytes = std::uint32_t(texelBytes(table.format));
  constexpr std::uint32_t kZero = 1, kRed = 3, kGreen = 4; // of VkComponentSwizzle
  if (bundle->showsGreenAsAlpha[image]) {
    values.vkSwizzle[0] = kRed;
    values.vkSwizzle[1] = values.vkSwizzle[2] = kZero;
    values.vkSwizzle[3] = kGreen;
  }
  values.bytes = table.texels.data();
  values.byteCount = table.texels.size();
  values.fetchedOnly = bundle->fetchedOnly[image] ? 1 : 0;
  return writeStruct(values, LICHEN_STRUCTURE_IMAGE_PROPERTIES, properties);
}

LichenResult lichenGetCopy(LichenBundle bundle, std::uint32_t image, std::uint32_t mipLevel,
                           LichenCopy* copy) {
  if (bundle == nullptr || image >= bundle->bundle.tables.size() ||
      mipLevel >= bundle->bundle.tables[image].mipLevels)
    return LICHEN_ERROR_USAGE;
  const LevelRange range = levelRange(bundle->bundle.tables[image], mipLevel);
  const LichenBundle_T::Extent& extent = bundle->extents[image];
  LichenCopy values{};
  values.offset = range.offset;
  values.byteCount = range.size;
  values.mipLevel = mipLevel;
  values.width = std::max(1u, extent.width >> mipLevel);
  values.height = std::max(1u, extent.height >> mipLevel);
  values.depth = std::max(1u, extent.depth >> mipLevel);
  return writeStruct(values, LICHEN_STRUCTURE_COPY, copy);
}

LichenResult lichenGetSamplerProperties(LichenSamplerUse use, LichenSamplerProperties* properties) {
  // Numbers of VkFilter, VkSamplerMipmapMode and VkSamplerAddressMode.
  constexpr std::uint32_t kLinear = 1, kLinearMip = 1, kRepeat = 0, kClamp = 2;
  LichenSamplerProperties values{};
  values.vkFilter = kLinear;
  if (use == LICHEN_SAMPLER_IMAGE) {
    values.vkMipmapMode = kLinearMip;
    values.vkAddressMode = kRepeat;
    values.maxLod = float(LICHEN_MAX_MIPS);
    values.takesAnisotropy = 1;
  } else if (use == LICHEN_SAMPLER_TABLE) {
    values.vkMipmapMode = kLinearMip;
    values.vkAddressMode = kClamp;
    values.maxLod = float(LICHEN_MAX_MIPS);
  } else {
    return LICHEN_ERROR_USAGE;
  }
  return writeStruct(values, LICHEN_STRUCTURE_SAMPLER_PROPERTIES, properties);
}

LichenResult lichenGetBinding(LichenBundle bundle, std::uint32_t noise, std::uint32_t index,
                              LichenBinding* binding) {
  static_assert(LICHEN_SET_BINDINGS == LICHEN_BINDING_COUNT);
  static_assert(LICHEN_LAYERED_SET_BINDINGS == LICHEN_LAYERED_BINDING_COUNT);
  if (bundle == nullptr || noise >= bundle->noises.size() || index >= LICHEN_LAYERED_SET_BINDINGS)
    return LICHEN_ERROR_USAGE;
  const LichenBundle_T::NoisePlan& plan = bundle->noises[noise];
  LichenBinding values{};
  values.binding = index;
  const bool isIndex = index >= LICHEN_BINDING_INDEX(0);
  values.sampler =
      !isIndex && (index == LICHEN_BINDING_TABLE_SAMPLER || index >= LICHEN_BINDING_TABLE(0))
          ? LICHEN_SAMPLER_TABLE
          : LICHEN_SAMPLER_IMAGE;
  if (isIndex) {
    values.kind = LICHEN_BINDING_SAMPLED_IMAGE;
    values.image = plan.indices[index - LICHEN_BINDING_INDEX(0)];
  } else if (index >= LICHEN_BINDING_TABLE(0)) {
    values.kind = LICHEN_BINDING_SAMPLED_IMAGE;
    values.image = plan.tables[index - LICHEN_BINDING_TABLE(0)];
  } else if (index >= LICHEN_BINDING_IMAGE(0)) {
    values.kind = LICHEN_BINDING_SAMPLED_IMAGE;
    values.image = plan.images[index - LICHEN_BINDING_IMAGE(0)];
  } else if (index >= LICHEN_BINDING_IMAGE_SAMPLER) {
    values.kind = LICHEN_BINDING_SAMPLER;
  } else {
    values.kind = index == LICHEN_BINDING_NOISE ? LICHEN_BINDING_NOISE_BUFFER
                                                : LICHEN_BINDING_MATERIAL_BUFFER;
  }
  return writeStruct(values, LICHEN_STRUCTURE_BINDING, binding);
}

LichenResult lichenGetNoiseConstants(LichenBundle bundle, std::uint32_t noise, void* destination) {
  static_assert(sizeof(shader::LichenNoiseConstants) == LICHEN_NOISE_BYTES);
  if (bundle == nullptr || noise >= bundle->noises.size() || destination == nullptr)
    return LICHEN_ERROR_USAGE;
  std::memcpy(destination, &bundle->noises[noise].constants, LICHEN_NOISE_BYTES);
  return LICHEN_SUCCESS;
}
