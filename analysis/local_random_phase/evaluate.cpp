// SPDX-License-Identifier: MIT
// Local random-phase noise at points, by the shaders' own code:
// shaders_glsl/noise/local_random_phase.glsl.
#define LICHEN_METHODS 4
#include "evaluation/shader_evaluator.h"

#include <lichen/bfloat16_pair.h>

#include <cstring>
#include <limits>

namespace lichen {
namespace {

/// An image of cosines with 0 where bfloat16Pair() wrote the smallest normal number. That has
/// subnormal products, with which processors take five times as long. Floats that 0 makes
/// subnormal are used as bits only.
Table withZeros(const Table& stored, const Noise& noise) {
  Table image = stored;
  const CosineImageLayout layout(noise.as<LocalRandomPhaseNoise>());
  for (std::size_t row = 0; row < layout.cosineRows; ++row)
    for (std::size_t word = 0; word < 4 * std::size_t(layout.cosineColumns); ++word) {
      std::byte* const at = &image.texels[4 * (4 * row * layout.width + word)];
      float pair = 0.0f;
      std::memcpy(&pair, at, sizeof pair);
      if (fromBfloat16Pair(pair)[0] == std::numeric_limits<float>::min()) {
        const std::uint32_t second = std::bit_cast<std::uint32_t>(pair) & 0xFFFFu;
        std::memcpy(at, &second, sizeof second);
      }
    }
  return image;
}

} // namespace

std::shared_ptr<const MethodEvaluator> localRandomPhaseEvaluator(const Bundle& bundle,
                                                                 std::size_t noise,
                                                                 const EvaluationOptions& options) {
  return std::make_shared<ShaderEvaluator>(bundle, noise, options, localRandomPhaseWide, withZeros);
}

} // namespace lichen
