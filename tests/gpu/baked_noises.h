// SPDX-License-Identifier: MIT
// Noises of every method, baked from one small exemplar for the tests that draw them on a device.
#pragma once

#include <lichen/bundle_writer.h>
#include <lichen/gaussianization.h>

#include <vector>

namespace lichen::test {

inline constexpr int kExemplarWidth = 64, kExemplarHeight = 48;

struct Baked {
  Method method = Method::tiling;
  std::vector<MapTarget> targets{MapTarget::baseColor}; ///< its maps; each of the same exemplar
  GaussianOnly gaussian = GaussianOnly::no;
  double structure = 0.0, guide = 0.0; ///< of local random phase; quilting has a guide too
  KernelWindow window = KernelWindow::gabor;
  int rings = 0;              ///< so many of the kernels are turned into rings
  int patternCosines = 0;     ///< of a pattern beside the kernels
  Grain grain = Grain::none;  ///< of quilting
  std::uint64_t exemplar = 5; ///< its seed
};

/// One noise and one material that uses it. Tables have 16 bits: rounding has tests of its own.
[[nodiscard]] BundleFile baked(const Baked& kind);

/// A file without previews, of a bundle with one noise and, if it has none, a material.
[[nodiscard]] BundleFile fileOf(Bundle bundle);

} // namespace lichen::test
