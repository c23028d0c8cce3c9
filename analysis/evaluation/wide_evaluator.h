// SPDX-License-Identifier: MIT
// A noise of the method that LICHEN_METHODS names, at four points of a plane at once: defines the
// function that LICHEN_WIDE names. Included by that method's evaluate_wide.cpp alone.
#pragma once

#define LICHEN_MAPPINGS 1 // texture coordinates

#include "method_evaluator.h"
#include "shader_library.h"

namespace lichen {
namespace { // as ShaderLibrary is

using Library = glsl::ShaderLibrary;

/// A block of the interface, the same for all points.
template <class WideBlock, class Block>
WideBlock everywhere(const Block& block) {
  const auto words = std::bit_cast<std::array<std::uint32_t, sizeof(Block) / 4>>(block);
  std::array<glsl::uint, words.size()> wide;
  for (std::size_t k = 0; k < words.size(); ++k)
    wide[k] = words[k];
  return std::bit_cast<WideBlock>(wide);
}

struct WideNoise {
  explicit WideNoise(const WideMap& of)
      : image(of.image), table(of.table), material(everywhere<decltype(material)>(of.material)),
        noise(everywhere<decltype(noise)>(of.noise)), map(everywhere<decltype(map)>(of.map)) {
    library.nearestTableLevel = of.nearestTableLevel;
  }

  /// GLSL passes structs by value; flattened, GCC copies few of them. In one function with the loop
  /// over points, it takes half as long again.
  LICHEN_FLATTEN [[gnu::noinline]] void evaluate(const PlanePoint* points,
                                                 NoiseEvaluator::Value* values) {
    const auto gathered = [&](std::array<float, 2> TileFootprint::*of) {
      return glsl::vec2::each([&](int axis) {
        return glsl::eachLane([&](int k) { return (points[k].at.*of)[std::size_t(axis)]; });
      });
    };
    const Library::LichenPoint point = library.lichenPointAt(
        gathered(&TileFootprint::position) + glsl::vec2(material.offsetX, material.offsetY),
        gathered(&TileFootprint::dx), gathered(&TileFootprint::dy), material, noise);
    const glsl::vec4 value = library.lichenValueAt(image, table, point, material, noise, map);
    for (int k = 0; k < glsl::kLanes; ++k)
      values[k] = {value.x.v[k], value.y.v[k], value.z.v[k], value.w.v[k]};
  }

  const RepeatingImage& image;
  const ClampedVolume& table;
  Library::LichenMaterial material;
  Library::LichenNoise noise;
  Library::LichenMap map;
  Library library;
};

} // namespace

std::size_t LICHEN_WIDE(const WideMap& map, std::span<const PlanePoint> points,
                        std::span<NoiseEvaluator::Value> values) {
  constexpr std::size_t kPoints = glsl::kLanes;
  WideNoise noise(map);
  glsl::tookOneBranch = false;
  std::size_t done = 0;
  for (; done + kPoints <= points.size(); done += kPoints) {
    noise.evaluate(&points[done], &values[done]);
    if (glsl::haveDiverged())
      break;
  }
  return done;
}

} // namespace lichen
