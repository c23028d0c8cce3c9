// SPDX-License-Identifier: MIT
// Any bytes -> parseBundle(), checkBundle() and decodeKtx2(): results satisfy their contract, and
// parsing and checking agree.
#include <lichen/bundle.h>
#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

using namespace lichen;

namespace {

void require(bool condition, const char* what) {
  if (condition)
    return;
  std::fprintf(stderr, "bundle: %s\n", what);
  std::abort();
}

bool isOneLine(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

bool areFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

void checkTable(const Table& table) {
  require(table.width > 0 && table.height > 0 && table.mipLevels > 0, "an empty table");
  const LevelRange last = levelRange(table, table.mipLevels - 1);
  require(table.texels.size() == last.offset + last.size, "number of texel bytes");
  for (const float value : decodeLevel(table, table.mipLevels - 1))
    require(std::isfinite(value), "a texel that is not finite");
}

bool isWithin(int value, int least, int most) { return value >= least && value <= most; }

void checkShape(const TextonShape& shape) {
  require(isWithin(shape.coefficientsX, 1, kMaxTextonSide) &&
              isWithin(shape.coefficientsY, 1, kMaxTextonSide),
          "number of coefficients");
  require(shape.order == 0 || shape.order == 1 || shape.order == 3, "order of the spline");
  require(isWithin(shape.mipLevels, 1, shape.mostMipLevels()), "mips of the textons");
  require(isWithin(shape.texelsPerTileX, shape.coefficientsX, int(kMaxTableSide)) &&
              isWithin(shape.texelsPerTileY, shape.coefficientsY, int(kMaxTableSide)),
          "size of the exemplar");
  require(isWithin(shape.steps, 1, kMaxTextonSteps), "number of steps");
}

void checkLayers(const Bundle& bundle, std::size_t noise) {
  const NoiseLayers& layers = *bundle.noises[noise].layers;
  require(layers.others.size() == layers.nodes.size() &&
              isWithin(int(layers.nodes.size()), 1, LICHEN_MAX_LAYER_NODES),
          "number of layers");
  visitLayerNoises(bundle.noises[noise], [&](std::size_t other) {
    require(other < bundle.noises.size() && other != noise && !bundle.noises[other].layers,
            "a layer or an index map");
  });
  std::vector<int> layerUses(layers.others.size() + 1), nodeUses(layers.nodes.size());
  for (const LayerNode& node : layers.nodes) {
    require(node.proportion > 0.0 && node.proportion < 1.0 && node.softness > 0.0, "a node");
    for (const LayerSide& side : {node.below, node.above}) {
      require(side.index < (side.isNode ? nodeUses : layerUses).size(), "a side");
      ++(side.isNode ? nodeUses : layerUses)[side.index];
    }
  }
  require(nodeUses.front() == 0 && std::ranges::count(nodeUses, 1) + 1 == std::ssize(nodeUses) &&
              std::ranges::count(layerUses, 1) == std::ssize(layerUses),
          "a tree");
  const std::unique_ptr<shader::LichenNoiseConstants> constants =
      std::make_unique<shader::LichenNoiseConstants>(shaderConstants(bundle, noise));
  require(constants->layers.count == layerUses.size(), "layers in the constants");
}

void checkTexton(const NoiseMap& map, const TextonShape& shape, const Bundle& bundle) {
  const auto& texton = map.as<TextonMap>();
  require(texton.image < bundle.tables.size(), "index of the image");
  const Table& image = bundle.tables[texton.image];
  const std::size_t n = map.channels.size();
  require(image.depth == 0 && image.width == shape.frameWidth() &&
              image.height == shape.frameHeight() * std::uint32_t(shape.steps) &&
              image.mipLevels == std::uint32_t(shape.mipLevels),
          "shape of a texton's image");
  require(std::size_t(channelCount(image.format)) >= n, "channels of a texton");
  require(texton.scale.size() == n && areFinite(texton.scale), "a scale for each channel");
  require(texton.laterSteps.size() + 1 == std::size_t(shape.steps), "statistics of every step");
  for (const TextonStep& step : texton.laterSteps) {
    require(step.mean.size() == n && step.covariance.size() == n * n &&
                step.mipLoss.size() == texton.mipLoss.size(),
            "size of a step's statistics");
    require(areFinite(step.mean) && areFinite(step.covariance) && areFinite(step.mipLoss),
            "a number of a step that is not finite");
  }
  require(texton.mipLoss.size() % n == 0 && texton.mipLoss.size() >= n * image.mipLevels &&
              texton.mipLoss.size() <= n * kMaxTextonLosses,
          "number of a texton's losses");
  require(areFinite(texton.mipLoss), "a number of a texton that is not finite");
}

void checkTiling(const NoiseMap& map, const Bundle& bundle) {
  const auto& tiling = map.as<TilingMap>();
  require(tiling.gaussian < bundle.tables.size(), "index of the image");
  const Table& image = bundle.tables[tiling.gaussian];
  require(isWithin(tiling.dimensions, 1, int(map.channels.size())), "number of dimensions");
  require(image.depth == 0 && channelCount(image.format) == (tiling.dimensions == 1 ? 2 : 4),
          "shape of a Gaussian image");
  const std::vector<float> losses = fetchLosses(image);
  require(std::is_sorted(losses.begin(), losses.end()) && losses.front() >= 0.0f &&
              losses.back() <= 1.0f,
          "losses of a Gaussian image");
  if (!tiling.inverseTable)
    return;
  require(*tiling.inverseTable < bundle.tables.size(), "index of the table");
  const Table& table = bundle.tables[*tiling.inverseTable];
  require(table.height == (tiling.dimensions > 1 ? table.width : 1) &&
              table.depth == (tiling.dimensions > 2 ? table.width : 1) &&
              table.mipLevels <= kMostTableLevels,
          "shape of an inverse table");
}

void checkCosines(const LocalRandomPhaseNoise& shared) {
  require(isWithin(shared.texelsPerTileX, 1, int(kMaxTableSide)) &&
              isWithin(shared.texelsPerTileY, 1, int(kMaxTableSide)),
          "size of the exemplar");
  require(isWithin(shared.columns, 1, kMostOctaveCells) &&
              isWithin(shared.rows, 2, kMostOctaveCells) && shared.rows % 2 == 0,
          "cells of the first octave");
  require(!shared.cosines.empty() && shared.cosines.size() <= kMostOctaves &&
              shared.cosines.back() > 0 && isWithin(shared.cosineCount(), 2, kMostCosines) &&
              std::all_of(shared.cosines.begin(), shared.cosines.end(),
                          [](int count) { return count % 2 == 0; }),
          "number of cosines");
  require(isWithin(shared.variants, 1, kMostVariants), "number of variants");
  const auto isSide = [](int side) {
    return side == 0 || (isWithin(side, kFewestStructureTexels, kMostStructureTexels) &&
                         std::has_single_bit(unsigned(side)));
  };
  require(isSide(shared.structure.columns) && isSide(shared.structure.rows) &&
              (shared.structure.columns > 0) == (shared.structure.rows > 0) &&
              isWithin(shared.structure.offsets, 0, kMostStructureOffsets),
          "size of a structure");
}

void checkCosines(const NoiseMap& map, const LocalRandomPhaseNoise& shared, const Bundle& bundle) {
  const auto& own = map.as<LocalRandomPhaseMap>();
  require(own.cosines < bundle.tables.size(), "index of the image");
  const Table& image = bundle.tables[own.cosines];
  const CosineImageLayout layout(shared);
  require(image.depth == 0 && image.width == layout.width && image.height == layout.height &&
              image.format == TexelFormat::rgba32Sfloat,
          "shape of an image of cosines");
  require(isWithin(own.dimensions, 1, int(map.channels.size())), "number of dimensions");
  if (shared.structure.columns > 0)
    require(own.structureAmplitudes.size() == std::size_t(own.dimensions) &&
                own.structureDeviations.size() == std::size_t(structureLevels(shared.structure)),
            "numbers of a structure");
  for (const double amplitude : own.structureAmplitudes)
    require(amplitude >= 0.0 && amplitude <= double(kMostAmplitude), "amplitude of a structure");
  require(!own.inverseTable || *own.inverseTable < bundle.tables.size(), "index of the table");
}

void checkKernels(const NoiseMap& map, const MultipleKernelsNoise& shared, const Bundle& bundle) {
  require(isWithin(shared.texelsPerTileX, 1, int(kMaxTableSide)) &&
              isWithin(shared.texelsPerTileY, 1, int(kMaxTableSide)),
          "size of the exemplar");
  require(isWithin(shared.kernels, 1, kMostKernels) && isWithin(shared.rings, 0, shared.kernels),
          "number of kernels");
  const auto& own = map.as<MultipleKernelsMap>();
  require(own.kernels < bundle.tables.size(), "index of the image");
  const Table& image = bundle.tables[own.kernels];
  require(image.depth == 0 && image.width == kKernelTexels &&
              image.height == std::uint32_t(shared.kernels) + patternRows(shared.cosines) &&
              image.format == TexelFormat::rgba32Sfloat,
          "shape of an image of kernels");
  for (const KernelRow& row : kernelRows(image, shared)) {
    require(isWithin(row.columns, 1, kMostKernelCells) && isWithin(row.rows, 1, kMostKernelCells) &&
                isWithin(row.cubes, 1, kMostKernelCells) &&
                isWithin(row.layers, 1, kMostKernelCells) && row.toWindowZ >= kLeastToWindowZ,
            "cells of a kernel");
    const auto& q = row.toWindow;
    const double determinant = std::abs(double(q[0]) * q[3] - double(q[1]) * q[2]);
    require(determinant >= double(kLeastKernelDeterminant), "matrix of a kernel");
    require(3.0 * row.columns * row.rows / (determinant * kKernelTiles * kKernelTiles) <=
                kMostKernelImpacts,
            "impacts of a kernel");
  }
  for (const PatternCosine& cosine : patternCosines(image, shared))
    for (const float cycles : cosine.frequency)
      require(std::abs(cycles) <= kMostKernelFrequency && cycles == std::floor(cycles),
              "frequency of a pattern");
  require(isWithin(own.dimensions, 1, int(map.channels.size())), "number of dimensions");
  require(!own.inverseTable || *own.inverseTable < bundle.tables.size(), "index of the table");
}

void checkQuilting(const QuiltingNoise& shared) {
  require(shared.reach > 0.0 && shared.reach <= kMostCellReach, "reach of cells");
  require(shared.offsets.empty() || (shared.offsets.size() >= kFewestQuiltingOffsets &&
                                     shared.offsets.size() <= kMostQuiltingOffsets),
          "number of offsets");
  for (const auto& offset : shared.offsets)
    for (const double axis : offset)
      require(axis >= 0.0 && axis < 1.0, "an offset");
}

void checkQuilting(const NoiseMap& map, const Noise& noise, const Bundle& bundle) {
  const auto& own = map.as<QuiltingMap>();
  require(own.image < bundle.tables.size() && own.cells < bundle.tables.size(),
          "index of an image");
  require(own.cells == noise.maps.front().as<QuiltingMap>().cells, "cells of their own");
  const Table& image = bundle.tables[own.image];
  const Table& cells = bundle.tables[own.cells];
  for (const Table* each : {&image, &cells})
    require(each->depth == 0 && each->mipLevels == std::uint32_t(std::bit_width(
                                                       std::max(each->width, each->height))),
            "shape of an image");
  require(cells.format == TexelFormat::rgba8Unorm, "format of an image of cells");
  const std::size_t n = map.channels.size();
  const bool isSlope = map.encoding == ValueEncoding::slope;
  require(channelCount(image.format) == (isSlope || n == 3 ? 4 : int(n)), "channels of an image");
  const shader::LichenMap constants =
      shaderMap(bundle, noise, std::size_t(&map - noise.maps.data()));
  for (const float mean : {constants.mean.x, constants.mean.y, constants.mean.z})
    require(std::isfinite(mean), "a mean that is not finite");
}

void checkMap(const NoiseMap& map, const Noise& noise, const Bundle& bundle) {
  const std::size_t n = map.channels.size();
  require(n >= 1 && n <= 3, "number of channels");
  require(map.mean.size() == n && map.covariance.size() == n * n, "size of the statistics");
  require(areFinite(map.mean) && areFinite(map.covariance), "a number that is not finite");
  require(map.data.index() == noise.data.index(), "a map of another method than its noise");
  if (noise.method() == Method::texton)
    checkTexton(map, noise.as<TextonShape>(), bundle);
  else if (noise.method() == Method::localRandomPhase)
    checkCosines(map, noise.as<LocalRandomPhaseNoise>(), bundle);
  else if (noise.method() == Method::multipleKernels)
    checkKernels(map, noise.as<MultipleKernelsNoise>(), bundle);
  else if (noise.method() == Method::quilting)
    checkQuilting(map, noise, bundle);
  else
    checkTiling(map, bundle);
}

void checkContract(const Bundle& bundle) {
  std::for_each(bundle.tables.begin(), bundle.tables.end(), checkTable);
  for (const Noise& noise : bundle.noises) {
    if (noise.method() == Method::texton)
      checkShape(noise.as<TextonShape>());
    if (noise.method() == Method::localRandomPhase)
      checkCosines(noise.as<LocalRandomPhaseNoise>());
    if (noise.method() == Method::quilting)
      checkQuilting(noise.as<QuiltingNoise>());
    for (const NoiseMap& map : noise.maps)
      checkMap(map, noise, bundle);
  }
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    if (bundle.noises[n].layers)
      checkLayers(bundle, n);
  require(bundle.materials.size() == bundle.materialNames.size(), "number of material names");
  for (const std::optional<MaterialNoise>& use : bundle.materials) {
    require(!use || use->noise < bundle.noises.size(), "index of a material's noise");
    require(!use || mappingObstacle(bundle, use->noise, use->mapping).empty(),
            "a mapping that the noise does not support");
    require(!use || takesTileRotation(bundle, use->noise, use->tileRotation),
            "a tile rotation that the noise does not take");
    require(!use || (use->impacts >= kImpactsRange.least && use->impacts <= kImpactsRange.most),
            "number of impacts");
    require(!use || use->mix.source != MixSource::direction ||
                std::hypot(use->mix.end[0] - use->mix.start[0],
                           use->mix.end[1] - use->mix.start[1]) >= kLeastMixLength,
            "a direction without length");
    require(!use || (use->mix.weight >= 0.0 && use->mix.weight <= 1.0), "a weight");
    require(!use || isWithin(use->mix.channel, 0, 3), "a channel");
    require(!use || isWithin(use->mix.colorSet, 0, 15), "a set of vertex colours");
    require(!use || isWithin(use->mix.texCoord, 0, 15), "texture coordinates of a mask");
  }
  for (const IgnoredNoise& noise : bundle.ignoredNoises) {
    const std::optional<Method> method = methodFrom(noise.method);
    require(!method || noise.revision > revisionOf(*method), "a known noise that is ignored");
    for (const std::size_t material : noise.materials)
      require(material < bundle.materials.size() && !bundle.materials[material],
              "a material of an ignored noise");
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> file(reinterpret_cast<const std::byte*>(data), size);
  const Result<Table> table = decodeKtx2(file, "file");
  if (table)
    checkTable(table.value());
  else
    require(isOneLine(table.error().message), "an error message that is not one line");

  const Result<Bundle> bundle = parseBundle(file, "file");
  const std::vector<Finding> findings = checkBundle(file);
  const bool hasError = std::any_of(findings.begin(), findings.end(), [](const Finding& f) {
    return f.severity == Finding::Severity::error;
  });
  require(bundle.ok() == !hasError, "reading and checking disagree");
  for (const Finding& finding : findings)
    require(!finding.code.empty() && isOneLine(finding.message), "a finding without a message");
  if (bundle)
    checkContract(bundle.value());
  else
    require(isOneLine(bundle.error().message), "an error message that is not one line");
  return 0;
}
