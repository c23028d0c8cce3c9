// SPDX-License-Identifier: MIT
// The kernels and the pattern of a multiple-kernels noise <-> the rows of their image.
#include <lichen/multiple_kernels_map.h>

#include <array>

namespace lichen {
namespace {

/// Floats of a cosine of a pattern.
constexpr std::size_t kPatternFloats = 4 * kKernelTexels / kRowPatternCosines;

constexpr std::array<std::string_view, 3> kWindowNames{"gabor", "sinc", "gaussian-sinc"};

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

} // namespace lichen
