// SPDX-License-Identifier: MIT
#include "patch_sheet.h"

#include <lichen/lattice.h>

#include <algorithm>

namespace lichen::bench {
namespace {

constexpr int kAcross = 96, kPatch = 9; // of patchDistance()
/// patchDistance() takes patch i of a row at i / 96 of the places that it could have.
constexpr int kSheetSide = kAcross * kPatch + kPatch - 1;

/// A random place in part `index` of 96 equal parts of a side; `random` is in [0, 2^32).
int placeOf(int index, std::uint32_t random, int side) {
  const double share = (double(index) + double(random) * 0x1p-32) / kAcross;
  return int(share * double(side - kPatch + 1));
}

} // namespace

SrgbImage patchSheet(const SrgbImage& image, std::uint32_t seed) {
  SrgbImage sheet(kSheetSide, kSheetSide, image.channels);
  for (int j = 0; j < kAcross; ++j)
    for (int i = 0; i < kAcross; ++i) {
      const auto random = pcg3d({std::uint32_t(i), std::uint32_t(j), seed});
      const int left = placeOf(i, random[0], image.width);
      const int top = placeOf(j, random[1], image.height);
      for (int row = 0; row < kPatch; ++row)
        std::copy_n(image.pixel(left, top + row), kPatch * image.channels,
                    sheet.pixel(kPatch * i, kPatch * j + row));
    }
  return sheet;
}

} // namespace lichen::bench
