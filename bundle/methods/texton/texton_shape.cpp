// SPDX-License-Identifier: MIT
// The frame size of a texton, its maximum number of mip levels, and the rows of its mipLoss.
#include <lichen/texton_map.h>

#include <algorithm>
#include <bit>

namespace lichen {
namespace {

/// Rounds the coefficients up to whole texels of the last mip level and adds one more, in which a
/// bilinear fetch of that level fades to 0 on both sides.
std::uint32_t frameSide(int coefficients, int mipLevels) {
  const std::uint32_t coarse = 1u << std::uint32_t(mipLevels - 1);
  return ((std::uint32_t(coefficients) + coarse - 1) / coarse + 1) * coarse;
}

} // namespace

int TextonShape::mostMipLevels() const {
  constexpr int kFewestCoarseTexels = 4;
  const int coarsest = std::min(coefficientsX, coefficientsY) / kFewestCoarseTexels;
  return int(std::bit_width(std::uint32_t(std::max(1, coarsest))));
}

std::uint32_t TextonShape::frameWidth() const { return frameSide(coefficientsX, mipLevels); }
std::uint32_t TextonShape::frameHeight() const { return frameSide(coefficientsY, mipLevels); }

std::span<const double> lossRow(std::span<const double> mipLoss, std::size_t row,
                                std::size_t rows) {
  const std::size_t levels = mipLoss.size() / rows;
  return mipLoss.subspan(row * levels, levels);
}

} // namespace lichen
