// SPDX-License-Identifier: MIT
// How large a texton's frame is, how many mips it may have, and the rows of its losses.
#include <lichen/texton_map.h>

#include <algorithm>
#include <bit>

namespace lichen {
namespace {

/// Room for the coefficients in whole texels of the last mip, and one more, in which a bilinear
/// fetch of that mip fades to 0 on both sides.
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
