// SPDX-License-Identifier: MIT
// The plan layer: bundle bytes -> images, copies, samplers, bindings. Pure CPU code. Uses Vulkan's
// numbers of formats and samplers without including a Vulkan header.
#include "plan.h"

#include "abi.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <string>

using namespace lichen;
using namespace lichen::plugin;

namespace {

/// Returns VkFormat numbers.
std::uint32_t vkFormatOf(TexelFormat format) {
  switch (format) {
  case TexelFormat::r8Unorm:
    return 9;
  case TexelFormat::rg8Unorm:
    return 16;
  case TexelFormat::rgba8Unorm:
    return 37;
  case TexelFormat::r16Sfloat:
    return 76;
  case TexelFormat::rg16Sfloat:
    return 83;
  case TexelFormat::rgba16Sfloat:
    return 97;
  case TexelFormat::r32Sfloat:
    return 100;
  case TexelFormat::rgba32Sfloat:
    return 109;
  }
  return 0;
}

LichenMapTarget targetOf(MapTarget target) {
  switch (target) {
  case MapTarget::baseColor:
    return LICHEN_TARGET_BASE_COLOR;
  case MapTarget::normal:
    return LICHEN_TARGET_NORMAL;
  case MapTarget::occlusionRoughnessMetallic:
    return LICHEN_TARGET_OCCLUSION_ROUGHNESS_METALLIC;
  case MapTarget::emissive:
    return LICHEN_TARGET_EMISSIVE;
  case MapTarget::height:
    return LICHEN_TARGET_HEIGHT;
  case MapTarget::opacity:
    return LICHEN_TARGET_OPACITY;
  }
  return LICHEN_TARGET_BASE_COLOR;
}

LichenChannel channelOf(MapChannel channel) {
  switch (channel) {
  case MapChannel::red:
    return LICHEN_CHANNEL_RED;
  case MapChannel::green:
    return LICHEN_CHANNEL_GREEN;
  case MapChannel::blue:
    return LICHEN_CHANNEL_BLUE;
  case MapChannel::slopeX:
    return LICHEN_CHANNEL_SLOPE_X;
  case MapChannel::slopeY:
    return LICHEN_CHANNEL_SLOPE_Y;
  case MapChannel::occlusion:
    return LICHEN_CHANNEL_OCCLUSION;
  case MapChannel::roughness:
    return LICHEN_CHANNEL_ROUGHNESS;
  case MapChannel::metallic:
    return LICHEN_CHANNEL_METALLIC;
  case MapChannel::height:
    return LICHEN_CHANNEL_HEIGHT;
  case MapChannel::opacity:
    return LICHEN_CHANNEL_OPACITY;
  }
  return LICHEN_CHANNEL_RED;
}

LichenMapping mappingOf(Mapping mapping) {
  switch (mapping) {
  case Mapping::uv:
    return LICHEN_MAPPING_UV;
  case Mapping::triplanar:
    return LICHEN_MAPPING_TRIPLANAR;
  case Mapping::surface:
    return LICHEN_MAPPING_SURFACE;
  case Mapping::solid:
    return LICHEN_MAPPING_SOLID;
  }
  return LICHEN_MAPPING_UV;
}

LichenTableKind tableKindNumber(TableKind kind) {
  switch (kind) {
  case TableKind::joint:
    return LICHEN_TABLE_JOINT;
  case TableKind::none:
    return LICHEN_TABLE_NONE;
  }
  return LICHEN_TABLE_JOINT;
}

/// A placeholder for the table binding of maps without a table: the shader declares the binding but
/// never reads it.
Table placeholderTable() {
  return {"unused", TexelFormat::r8Unorm, 1, 1, 1, 1, std::vector<std::byte>(1)};
}

/// The table that the shader fetches from for a map: Gaussian image or texton.
std::size_t imageOf(const NoiseMap& map) {
  if (const auto* tiling = std::get_if<TilingMap>(&map.data))
    return tiling->gaussian;
  return map.as<TextonMap>().image;
}

/// Finds the table for each map's binding: its inverse table, the table of its mix, or a
/// placeholder.
void addBoundTables(Bundle& bundle, std::vector<std::vector<std::uint32_t>>& tables) {
  std::optional<std::uint32_t> placeholder;
  const auto append = [&](Table table) {
    bundle.tables.push_back(std::move(table));
    return std::uint32_t(bundle.tables.size() - 1);
  };
  for (const Noise& noise : bundle.noises) {
    tables.emplace_back();
    for (const NoiseMap& map : noise.maps) {
      const auto* tiling = std::get_if<TilingMap>(&map.data);
      const auto* texton = std::get_if<TextonMap>(&map.data);
      if (tiling != nullptr && tiling->inverseTable) {
        tables.back().push_back(std::uint32_t(*tiling->inverseTable));
      } else if (texton != nullptr && !texton->laterSteps.empty()) {
        tables.back().push_back(append(mixTable(map)));
      } else {
        placeholder = placeholder ? placeholder : append(placeholderTable());
        tables.back().push_back(*placeholder);
      }
    }
  }
}

LichenMixSource mixSourceOf(MixSource source) {
  switch (source) {
  case MixSource::constant:
    return LICHEN_MIX_CONSTANT;
  case MixSource::direction:
    return LICHEN_MIX_DIRECTION;
  case MixSource::texture:
    return LICHEN_MIX_TEXTURE;
  case MixSource::vertexColor:
    return LICHEN_MIX_VERTEX_COLOR;
  }
  return LICHEN_MIX_CONSTANT;
}

void planNoise(LichenBundle_T& plan, const Noise& noise) {
  assert(noise.maps.size() <= LICHEN_MAX_MAPS); // one per target; parseBundle() rejects more
  std::vector<shader::LichenMap> maps;
  for (std::size_t i = 0; i < noise.maps.size(); ++i) {
    maps.push_back(shaderMap(plan.bundle, noise, i));
    assert(plan.bundle.tables[imageOf(noise.maps[i])].mipLevels <= LICHEN_MAX_MIPS);
    // A Gaussian image of one dimension has its loss in green; the shader reads it in alpha.
    if (const auto* tiling = std::get_if<TilingMap>(&noise.maps[i].data);
        tiling != nullptr && tiling->dimensions == 1)
      plan.showsGreenAsAlpha[tiling->gaussian] = true;
  }
  plan.maps.push_back(std::move(maps));
}

void planBundle(LichenBundle_T& plan) {
  addBoundTables(plan.bundle, plan.tables);
  for (const Table& table : plan.bundle.tables)
    plan.extents.push_back(
        {table.width, table.height, std::max(1u, table.depth), table.depth == 0 ? 2u : 3u});
  plan.showsGreenAsAlpha.resize(plan.bundle.tables.size());
  for (const Noise& noise : plan.bundle.noises)
    planNoise(plan, noise);
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
    Result<Bundle> parsed = parseBundle({static_cast<const std::byte*>(info.bytes), info.byteCount},
                                        info.name != nullptr ? info.name : "bundle");
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
  values.uniformBufferCount = 1;
  values.method = source.method() == Method::texton ? LICHEN_NOISE_TEXTON : LICHEN_NOISE_TILING;
  values.combinedImageSamplerCount = 2 * values.mapCount;
  const auto* shape = std::get_if<TextonShape>(&source.data);
  values.mixSteps = shape != nullptr ? std::uint32_t(shape->steps) : 1;
  return writeStruct(values, LICHEN_STRUCTURE_NOISE_PROPERTIES, properties);
}

LichenResult lichenGetMapProperties(LichenBundle bundle, std::uint32_t noise, std::uint32_t map,
                                    LichenMapProperties* properties) {
  if (bundle == nullptr || noise >= bundle->bundle.noises.size() ||
      map >= bundle->bundle.noises[noise].maps.size())
    return LICHEN_ERROR_USAGE;
  const NoiseMap& source = bundle->bundle.noises[noise].maps[map];
  LichenMapProperties values{};
  values.target = targetOf(source.target);
  values.channelCount = std::uint32_t(source.channels.size());
  std::transform(source.channels.begin(), source.channels.end(), values.channels, channelOf);
  values.image = std::uint32_t(imageOf(source));
  values.tableImage = bundle->tables[noise][map];
  const auto* tiling = std::get_if<TilingMap>(&source.data);
  values.tableKind = tableKindNumber(tiling != nullptr ? tableKindOf(*tiling) : TableKind::none);
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
    values.mapping = mappingOf(source->mapping);
    values.texCoord = std::uint32_t(source->texCoord);
    values.space = source->space == NoiseSpace::object ? LICHEN_SPACE_OBJECT : LICHEN_SPACE_WORLD;
    values.mixSource = mixSourceOf(source->mix.source);
    values.mixTexture = std::uint32_t(source->mix.texture);
    values.mixSet = std::uint32_t(source->mix.source == MixSource::texture ? source->mix.texCoord
                                                                           : source->mix.colorSet);
    values.mixChannel = std::uint32_t(source->mix.channel);
    values.seed = source->seed;
    values.scale = source->scale;
    std::copy(source->offset.begin(), source->offset.end(), values.offset);
    values.rotation = source->rotation;
    values.blendSharpness = source->blendSharpness;
    values.contrast = source->contrast;
    values.planeSharpness = source->planeSharpness;
    values.impacts = source->impacts;
    values.pointProcess = source->pointProcess == PointProcess::poisson
                              ? LICHEN_POINT_PROCESS_POISSON
                              : LICHEN_POINT_PROCESS_STRATIFIED;
    values.tileRotation = source->tileRotation;
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
  if (bundle == nullptr || noise >= bundle->bundle.noises.size())
    return LICHEN_ERROR_USAGE;
  const std::vector<NoiseMap>& maps = bundle->bundle.noises[noise].maps;
  if (index > 2 * maps.size())
    return LICHEN_ERROR_USAGE;
  LichenBinding values{};
  if (index == 0) {
    values.binding = LICHEN_BINDING_NOISE;
    values.kind = LICHEN_BINDING_UNIFORM_BUFFER;
  } else {
    const std::uint32_t map = (index - 1) / 2;
    const bool isTable = (index - 1) % 2 == 1;
    values.binding = isTable ? LICHEN_BINDING_TABLE(map) : LICHEN_BINDING_IMAGE(map);
    values.kind = LICHEN_BINDING_COMBINED_IMAGE_SAMPLER;
    values.sampler = isTable ? LICHEN_SAMPLER_TABLE : LICHEN_SAMPLER_IMAGE;
    values.image = isTable ? bundle->tables[noise][map] : std::uint32_t(imageOf(maps[map]));
  }
  return writeStruct(values, LICHEN_STRUCTURE_BINDING, binding);
}
