// SPDX-License-Identifier: MIT
// The steps of a mix of textons -> the table that the shader reads: 3-D, steps x 1 x
// LICHEN_MIX_ROWS half floats, linear along the steps.
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace lichen {
namespace {

/// Minimum ratio of standard deviations. The shader multiplies and divides by the ratio, so it must
/// not be 0; any other value works.
constexpr double kLeastRatio = 0x1p-14; // the smallest normal half float

/// The ratio of six standard deviations of a channel to the channel's scale.
double deviationRatio(const TextonStep& step, const std::vector<double>& scale, std::size_t c) {
  constexpr double kScaleDeviations = 6.0;
  const double variance = step.covariance[c * scale.size() + c];
  const double ratio =
      scale[c] > 0.0 ? kScaleDeviations * std::sqrt(std::max(0.0, variance)) / scale[c] : 1.0;
  return std::clamp(ratio, kLeastRatio, double(kHalfMax));
}

} // namespace

Table mixTable(const NoiseMap& map) {
  constexpr std::size_t kComponents = 4; // of a texel
  const auto& texton = map.as<TextonMap>();
  std::vector<TextonStep> steps{{map.mean, map.covariance, texton.mipLoss}};
  steps.insert(steps.end(), texton.laterSteps.begin(), texton.laterSteps.end());
  Table table{"mix", TexelFormat::rgba16Sfloat, std::uint32_t(steps.size()), 1, LICHEN_MIX_ROWS, 1,
              {}};
  std::vector<float> texels(LICHEN_MIX_ROWS * steps.size() * kComponents, 0.0f);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const auto texel = [&](std::size_t row) {
      return &texels[(row * steps.size() + s) * kComponents];
    };
    for (std::size_t c = 0; c < map.mean.size(); ++c) {
      texel(LICHEN_MIX_MEAN)[c] = float(steps[s].mean[c] - map.mean[c]);
      texel(LICHEN_MIX_DEVIATION)[c] = float(deviationRatio(steps[s], texton.scale, c));
    }
    for (std::size_t c = map.mean.size(); c < kComponents; ++c)
      texel(LICHEN_MIX_DEVIATION)[c] = 1.0f;
    for (std::size_t c = 0; c < texton.scale.size(); ++c) {
      // The retained amplitudes of a constant channel stay 0, as without a mix.
      const std::span<const double> losses = lossRow(steps[s].mipLoss, c, texton.scale.size());
      for (std::size_t mip = 0; mip < LICHEN_MAX_MIPS && texton.scale[c] > 0.0; ++mip)
        texel(LICHEN_MIX_RETAINED + mip)[c] =
            float(std::sqrt(1.0 - losses[std::min(mip, losses.size() - 1)]));
    }
  }
  appendTexels(table.texels, table.format, texels);
  return table;
}

} // namespace lichen
