// SPDX-License-Identifier: MIT
// Labels (height, width) -> lattices of offsets (rows, columns), and the copies that fill a pixel.
// Blends as tiling and blending does, with weights so sharp that most pixels are copies. [HN18]
#include "patch_lattice.h"

#include "label_means.h"

#include <lichen/lattice.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace lichen::layers {
namespace {

/// The weight of a vertex at (column, row) cells of the skewed lattice from it.
float hat(float column, float row) {
  return std::max(0.0f, 1.0f - std::max({std::abs(column), std::abs(row), std::abs(column + row)}));
}

float sharpened(float weight) {
  const float square = weight * weight;
  return square * square * square;
}

/// The purity of a pixel that is copied. It falls towards the borders of the tile, where copies end
/// along straight lines that would show.
float sourcePurity(const Purity& purity, int x, int y) {
  const int inside = 1 + std::min({x, y, purity.width - 1 - x, purity.height - 1 - y});
  constexpr float kFeather = 8.0f; // pixels
  return inside <= 0 ? 0.0f : purity.at(x, y) * std::min(1.0f, float(inside) / kFeather);
}

/// A vertex of the infinite lattice: the one that it repeats, and how many tiles away.
struct RepeatedVertex {
  const PatchLattice::Vertex& vertex;
  int tilesX, tilesY;
};

RepeatedVertex vertexAt(const PatchLattice& lattice, int i, int j) {
  const int tilesY = int(std::floor(float(j) / float(lattice.rows)));
  j -= tilesY * lattice.rows;
  i += tilesY * (lattice.rows / 2); // each row is shifted by half a cell
  const int tilesX = int(std::floor(float(i) / float(lattice.columns)));
  i -= tilesX * lattice.columns;
  const auto index = std::size_t(j) * std::size_t(lattice.columns) + std::size_t(i);
  return {lattice.vertices[index], tilesX, tilesY};
}

/// Adds copies by one lattice to a blend, in place of a part of the mean.
void addCopies(const PatchLattice& lattice, const Purity& purity, int x, int y, PatchBlend& blend) {
  const float b = (float(y) + 0.5f) / float(purity.height) * float(lattice.rows);
  const float a = (float(x) + 0.5f) / float(purity.width) * float(lattice.columns) - 0.5f * b;
  const float floorA = std::floor(a), floorB = std::floor(b);
  const float f = a - floorA, g = b - floorB;
  const int corner = f + g < 1.0f ? 0 : 1;
  const std::array<std::array<int, 2>, 3> corners{{{corner, corner}, {1, 0}, {0, 1}}};
  float all = 0.0f, pure = 0.0f;
  const int first = blend.taps;
  for (const auto& [i, j] : corners) {
    const float weight = sharpened(hat(f - float(i), g - float(j)));
    all += weight;
    const auto [vertex, tilesX, tilesY] = vertexAt(lattice, int(floorA) + i, int(floorB) + j);
    if (!vertex.isUsed)
      continue;
    PatchTap tap;
    tap.x = x + int(std::lround(vertex.x * float(purity.width)) - tilesX * purity.width);
    tap.y = y + int(std::lround(vertex.y * float(purity.height)) - tilesY * purity.height);
    tap.weight = weight * sourcePurity(purity, tap.x, tap.y);
    pure += tap.weight;
    if (tap.weight > 0.0f)
      blend.tap[std::size_t(blend.taps++)] = tap;
  }
  if (pure == 0.0f)
    return;
  // Sources with little weight fade in, so that no edge appears where the others end.
  constexpr float kFaded = 0.1f;
  const float taken = blend.mean * std::min(1.0f, pure / (kFaded * all));
  for (int k = first; k < blend.taps; ++k)
    blend.tap[std::size_t(k)].weight *= taken / pure;
  blend.mean -= taken;
}

/// The quantile of the distances inside the label.
float quantile(const std::vector<float>& distance, double share) {
  std::vector<float> inside;
  for (const float value : distance)
    if (value > 0.0f)
      inside.push_back(value);
  return exemplar::quantile(std::move(inside), share);
}
constexpr double kThick = 0.9; ///< the quantile that stands for a label's thickest places

/// A point near a vertex, where a copy is needed.
struct Need {
  int x, y;
  float weight;
};

/// The pixels around vertex (i, j) that need a copy, on a coarse grid.
std::vector<Need> needsOf(const PatchLattice& lattice, const Purity& purity,
                          const std::vector<float>& missing, int i, int j) {
  constexpr int kPerSide = 12;
  std::vector<Need> needs;
  for (int row = 0; row < kPerSide; ++row)
    for (int column = 0; column < kPerSide; ++column) {
      // From -1 to 1 cells, in skewed coordinates.
      const float a = 2.0f * (float(column) + 0.5f) / kPerSide - 1.0f;
      const float b = 2.0f * (float(row) + 0.5f) / kPerSide - 1.0f;
      const float weight = hat(a, b);
      const float tileX = (float(i) + a + 0.5f * (float(j) + b)) / float(lattice.columns);
      const float tileY = (float(j) + b) / float(lattice.rows);
      const int x = int(std::floor(tileX * float(purity.width)));
      const int y = int(std::floor(tileY * float(purity.height)));
      const int wrappedX = (x % purity.width + purity.width) % purity.width;
      const int wrappedY = (y % purity.height + purity.height) % purity.height;
      const float need =
          missing[std::size_t(wrappedY) * std::size_t(purity.width) + std::size_t(wrappedX)];
      if (weight * weight * need > 0.0f)
        needs.push_back({x, y, weight * weight * need});
    }
  return needs;
}

/// Chooses the source of each vertex among random pixels of the label: the first for which nearly
/// as many pixels are pure as for the best.
void chooseSources(PatchLattice& lattice, const Purity& purity, const std::vector<float>& missing,
                   const std::vector<std::array<int, 2>>& purePixels, std::uint32_t seed) {
  constexpr int kSources = 64;
  constexpr float kNearlyBest = 0.8f; // the best alone would come again and again
  tbb::parallel_for(0, lattice.rows * lattice.columns, [&](int index) {
    const int i = index % lattice.columns, j = index / lattice.columns;
    const std::vector<Need> needs = needsOf(lattice, purity, missing, i, j);
    if (needs.empty())
      return;
    const int vertexX =
        int((float(i) + 0.5f * float(j)) / float(lattice.columns) * float(purity.width));
    const int vertexY = int(float(j) / float(lattice.rows) * float(purity.height));
    std::array<std::array<int, 2>, kSources> offsets{};
    std::array<float, kSources> scores{};
    for (std::size_t k = 0; k < kSources; ++k) {
      const std::uint32_t random = pcg3d({std::uint32_t(index), std::uint32_t(k), seed})[0];
      const auto& [x, y] =
          purePixels[std::size_t(std::uint64_t(random) * purePixels.size() >> 32u)];
      offsets[k] = {x - vertexX, y - vertexY};
      for (const Need& need : needs)
        scores[k] +=
            need.weight * sourcePurity(purity, need.x + offsets[k][0], need.y + offsets[k][1]);
    }
    const float enough = kNearlyBest * *std::max_element(scores.begin(), scores.end());
    const auto chosen = std::size_t(
        std::find_if(scores.begin(), scores.end(), [&](float score) { return score >= enough; }) -
        scores.begin());
    lattice.vertices[std::size_t(index)] = {true, float(offsets[chosen][0]) / float(purity.width),
                                            float(offsets[chosen][1]) / float(purity.height)};
  });
}

} // namespace

Purity purityOf(const LabelImage& labels, const std::vector<float>& distance, int width,
                int height) {
  // Pixels of the border mix both materials, and labels are rarely exact to a pixel.
  constexpr float kMixed = 1.5f, kFeather = 2.0f;
  const float scale = std::min(1.0f, quantile(distance, kThick) / (kMixed + kFeather));
  Purity purity{width, height, {}};
  purity.values.reserve(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t nearest =
          nearestPixel(y, height, labels.height) * std::size_t(labels.width) +
          nearestPixel(x, width, labels.width);
      purity.values.push_back(
          std::clamp((distance[nearest] - scale * kMixed) / (scale * kFeather), 0.0f, 1.0f));
    }
  return purity;
}

PatchBlend blendAt(const std::vector<PatchLattice>& lattices, const Purity& purity, int x, int y) {
  PatchBlend blend;
  blend.own = purity.at(x, y);
  blend.mean = 1.0f - blend.own;
  for (const PatchLattice& lattice : lattices)
    if (blend.mean > 0.0f)
      addCopies(lattice, purity, x, y, blend);
  return blend;
}

std::vector<PatchLattice> patchLattices(const LabelImage& labels,
                                        const std::vector<float>& distance) {
  const int width = labels.width, height = labels.height;
  const Purity purity = purityOf(labels, distance, width, height);
  constexpr float kPure = 0.99f; // 1 but for rounding
  std::vector<std::array<int, 2>> purePixels;
  std::vector<float> missing(purity.values.size());
  for (std::size_t i = 0; i < missing.size(); ++i) {
    missing[i] = 1.0f - purity.values[i];
    if (purity.values[i] > kPure)
      purePixels.push_back({int(i % std::size_t(width)), int(i / std::size_t(width))});
  }

  // A cell is about as wide as the label's regions, so that one copy fills it.
  constexpr float kCellOverDistance = 2.0f;
  constexpr float kLeastCell = 6.0f; // pixels
  constexpr double kEnough = 1e-4;   // of the pixels may remain
  constexpr std::uint32_t kSeed = 1; // any
  float cell = std::max(kLeastCell, std::min(kCellOverDistance * quantile(distance, kThick),
                                             0.25f * float(std::min(width, height))));
  std::vector<PatchLattice> lattices;
  while (lattices.size() < kMostLattices && cell >= kLeastCell) {
    PatchLattice lattice;
    lattice.columns = std::max(1, int(std::lround(float(width) / cell)));
    const float rowHeight = 0.5f * std::numbers::sqrt3_v<float> * cell;
    lattice.rows = 2 * std::max(1, int(std::lround(0.5f * float(height) / rowHeight)));
    lattice.vertices.resize(std::size_t(lattice.columns) * std::size_t(lattice.rows));
    chooseSources(lattice, purity, missing, purePixels,
                  latticeSeed(kSeed, std::uint32_t(lattices.size())));
    lattices.push_back(std::move(lattice));
    tbb::parallel_for(0, height, [&](int y) {
      for (int x = 0; x < width; ++x)
        missing[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
            blendAt(lattices, purity, x, y).mean;
    });
    double sum = 0.0;
    for (const float value : missing)
      sum += double(value);
    if (sum < kEnough * double(missing.size()))
      break;
    cell *= 0.5f;
  }
  return lattices;
}

} // namespace lichen::layers
