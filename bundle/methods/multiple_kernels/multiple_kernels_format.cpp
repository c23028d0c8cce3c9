// SPDX-License-Identifier: MIT
// The supported mappings of multiple-kernels noise, the size of its exemplar, its members as JSON,
// and the rows of its images.
#include "multiple_kernels_format.h"

#include <array>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// Floats of a cosine of a pattern.
constexpr std::size_t kPatternFloats = 4 * kKernelTexels / kRowPatternCosines;

constexpr std::array<std::string_view, 3> kWindowNames{"gabor", "sinc", "gaussian-sinc"};

std::string_view obstacleOf(KernelWindow window, bool hasPattern, Mapping mapping) {
  if (mapping != Mapping::solid && mapping != Mapping::surface)
    return "";
  if (hasPattern)
    return "it has a pattern, which lies in a plane";
  return window == KernelWindow::gabor || mapping == Mapping::surface
             ? ""
             : "its kernels have a window on a square, and in solids all have gabor";
}

} // namespace

std::string_view nameOf(KernelWindow value) { return kWindowNames[std::size_t(value)]; }

std::optional<KernelWindow> kernelWindowFrom(std::string_view name) {
  for (std::size_t k = 0; k < kWindowNames.size(); ++k)
    if (kWindowNames[k] == name)
      return KernelWindow(k);
  return std::nullopt;
}

std::vector<KernelRow> kernelRows(const Table& image, const MultipleKernelsNoise& noise) {
  const std::vector<float> texels = decodeLevel(image, 0);
  std::vector<KernelRow> rows(std::size_t(noise.kernels));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const float* own = &texels[4 * kKernelTexels * k];
    rows[k].frequency = {own[0], own[1]};
    rows[k].columns = int(own[2]);
    rows[k].rows = int(own[3]);
    for (std::size_t i = 0; i < 4; ++i) {
      rows[k].toWindow[i] = own[4 + i];
      for (std::size_t c = 0; c < 3; ++c)
        rows[k].colors[c][i] = own[12 + 4 * c + i];
    }
    rows[k].amplitude = own[8];
    rows[k].cubes = int(own[9]);
    rows[k].layers = int(own[10]);
    rows[k].toWindowZ = own[11];
  }
  return rows;
}

std::vector<PatternCosine> patternCosines(const Table& image, const MultipleKernelsNoise& noise) {
  const std::vector<float> texels = decodeLevel(image, 0);
  std::vector<PatternCosine> pattern(std::size_t(noise.cosines));
  const float* own = texels.data() + 4 * kKernelTexels * std::size_t(noise.kernels);
  for (PatternCosine& cosine : pattern) {
    cosine.frequency = {own[0], own[1]};
    for (std::size_t c = 0; c < 3; ++c)
      cosine.waves[c] = {own[2 + 2 * c], own[3 + 2 * c]};
    own += kPatternFloats;
  }
  return pattern;
}

Table kernelTable(const std::vector<KernelRow>& rows, const std::vector<PatternCosine>& pattern) {
  Table table;
  table.format = TexelFormat::rgba32Sfloat;
  table.width = kKernelTexels;
  table.height = std::uint32_t(rows.size()) + patternRows(int(pattern.size()));
  std::vector<float> texels;
  for (const KernelRow& row : rows) {
    texels.insert(texels.end(),
                  {row.frequency[0], row.frequency[1], float(row.columns), float(row.rows)});
    texels.insert(texels.end(), row.toWindow.begin(), row.toWindow.end());
    texels.insert(texels.end(),
                  {row.amplitude, float(row.cubes), float(row.layers), row.toWindowZ});
    for (const std::array<float, 4>& color : row.colors)
      texels.insert(texels.end(), color.begin(), color.end());
  }
  for (const PatternCosine& cosine : pattern) {
    texels.insert(texels.end(), cosine.frequency.begin(), cosine.frequency.end());
    for (const std::array<float, 2>& wave : cosine.waves)
      texels.insert(texels.end(), wave.begin(), wave.end());
  }
  texels.resize(std::size_t(4) * table.width * table.height, 0.0f);
  appendTexels(table.texels, table.format, texels);
  return table;
}

bool MultipleKernelsFormat::fits(Mapping) const { return true; }

std::string_view MultipleKernelsFormat::obstacle(const Noise& noise, Mapping mapping) const {
  const auto& own = noise.as<MultipleKernelsNoise>();
  return obstacleOf(own.window, own.cosines > 0, mapping);
}

std::string_view MultipleKernelsFormat::obstacle(const shader::LichenNoise& noise,
                                                 Mapping mapping) const {
  const shader::LichenKernelsNoise own = kernelsPart(noise);
  return obstacleOf(KernelWindow(own.window), own.cosines > 0, mapping);
}

std::span<const std::string_view> MultipleKernelsFormat::tableMembers() const {
  static constexpr std::array<std::string_view, 2> kMembers{"kernels", "inverseTable"};
  return kMembers;
}

void MultipleKernelsFormat::writeNoise(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  Json& own = json["multipleKernels"];
  own = {{"texelsPerTile", {shared.texelsPerTileX, shared.texelsPerTileY}},
         {"kernels", shared.kernels}};
  if (shared.rings > 0)
    own["rings"] = shared.rings;
  if (shared.cosines > 0)
    own["cosines"] = shared.cosines;
  own["window"] = nameOf(shared.window);
  if (shared.hasGivenSpectrum)
    own["spectrum"] = "given";
}

void MultipleKernelsFormat::writeMap(const NoiseMap& map, Json& json) const {
  const auto& own = map.as<MultipleKernelsMap>();
  json["dimensions"] = own.dimensions;
  json["kernels"] = own.kernels;
  if (own.inverseTable)
    json["inverseTable"] = *own.inverseTable;
}

std::array<std::uint32_t, 2> MultipleKernelsFormat::exemplarSize(const Bundle& bundle,
                                                                 const Noise& noise,
                                                                 const NoiseMap&) const {
  return tileSize(bundle, noise);
}

std::array<std::uint32_t, 2> MultipleKernelsFormat::tileSize(const Bundle&,
                                                             const Noise& noise) const {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  return {std::uint32_t(shared.texelsPerTileX), std::uint32_t(shared.texelsPerTileY)};
}

} // namespace lichen
