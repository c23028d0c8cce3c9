// SPDX-License-Identifier: MIT
// Synthetic noises for the tests: a Gaussian image of independent values with a box-filtered mip
// chain, and a smooth inverse table. They are not baked: only evaluation is tested with them.
#pragma once

#include <lichen/bundle_writer.h>

#include <array>
#include <span>

namespace lichen::test {

enum class SyntheticTable { joint, none };

struct SyntheticMap {
  int dimensions = 3; ///< D, 1 to 3; selects the map's target
  std::uint32_t width = 64;
  std::uint32_t height = 64;
  bool eightBit = false;  ///< 8-bit tables instead of 16-bit floats
  std::size_t levels = 5; ///< mip levels of the inverse table, [1, 5]
  SyntheticTable table = SyntheticTable::joint;
  Grain grain = Grain::none; ///< of a noise that begins with this map
};

/// Every kind of table with every number of dimensions, and every grain.
inline constexpr std::array<SyntheticMap, 6> kTilingMaps{
    {{3, 64, 64},
     {2, 64, 32, false, 3, SyntheticTable::joint, Grain::x},
     {1, 48, 80, false, 5, SyntheticTable::joint, Grain::y},
     {3, 64, 64, false, 0, SyntheticTable::none},
     {2, 64, 32, false, 0, SyntheticTable::none},
     {1, 48, 80, false, 0, SyntheticTable::none}}};

/// One noise with these maps and one material that uses it.
[[nodiscard]] BundleFile syntheticBundle(std::span<const SyntheticMap> maps);

/// That bundle as a GLB file.
[[nodiscard]] std::vector<std::byte> syntheticGlb(std::span<const SyntheticMap> maps);

} // namespace lichen::test
