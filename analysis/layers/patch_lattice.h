// SPDX-License-Identifier: MIT
// Which copies of a label's regions fill the rest of the tile.
#pragma once

#include "exemplar/planes.h"

#include <lichen/layers.h>

#include <array>
#include <cstdint>
#include <vector>

namespace lichen::layers {

/// How far a pixel shows one label alone: 0 near other labels, 1 away from them.
using Purity = exemplar::Plane;

/// The purity of each of width x height pixels of the tile. `distance` is that to other labels
/// [pixels of `labels`]. In a thin label all pixels lie near others; those farthest from them count
/// as pure. Throws std::bad_alloc.
[[nodiscard]] Purity purityOf(const LabelImage& labels, const std::vector<float>& distance,
                              int width, int height);

/// A simplex lattice that repeats with the tile. Each vertex has an offset: pixels near it are
/// copied from there.
struct PatchLattice {
  int columns = 0, rows = 0; ///< `rows` is even
  struct Vertex {
    bool isUsed = false;
    float x = 0.0f, y = 0.0f; ///< from a pixel to its source [tiles]
  };
  std::vector<Vertex> vertices;
};

/// A pixel's copy: its source, and how much it counts.
struct PatchTap {
  int x = 0, y = 0;
  float weight = 0.0f;
};
inline constexpr std::size_t kMostLattices = 5;

/// What a pixel is made of. The weights of the pixel itself, of the copies and of the mean sum to
/// 1.
struct PatchBlend {
  float own = 0.0f;
  float mean = 1.0f;
  int taps = 0;
  std::array<PatchTap, 3 * kMostLattices> tap{};
};

/// The blend of a pixel of a map with this purity: its own value as far as it is pure, then copies
/// by the first lattice as far as their sources are, and so on.
[[nodiscard]] PatchBlend blendAt(const std::vector<PatchLattice>& lattices, const Purity& purity,
                                 int x, int y);

/// Chooses the offsets of lattices of ever smaller cells, at most kMostLattices, until they cover
/// the tile. `distance` as for purityOf(). Deterministic. Throws std::bad_alloc.
[[nodiscard]] std::vector<PatchLattice> patchLattices(const LabelImage& labels,
                                                      const std::vector<float>& distance);

} // namespace lichen::layers
