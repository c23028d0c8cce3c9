// SPDX-License-Identifier: MIT
// The lattice's hash, offsets, origins and periodic forms: values and distribution.
#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

using namespace lichen;

namespace {

/// The value that a chi-square variable exceeds with probability 1e-4 [WH31]: 3.719 is the normal
/// quantile of 1 - 1e-4. A correct hash fails one comparison in 10,000; the seeds here are fixed.
double chiSquareLimit(std::size_t degrees) {
  const double spread = 2.0 / (9.0 * double(degrees));
  return double(degrees) * std::pow(1.0 - spread + 3.719 * std::sqrt(spread), 3.0);
}

/// Pearson's statistic of counts that should be equal.
double chiSquare(const std::vector<int>& counts) {
  const double expected =
      std::accumulate(counts.begin(), counts.end(), 0.0) / double(counts.size());
  double sum = 0.0;
  for (const int count : counts)
    sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/// Calls visit(i, j) for 65,536 vertices on both sides of the origin, where coordinates wrap.
template <class Visit>
void forEachVertex(Visit visit) {
  constexpr std::int32_t kSide = 256;
  for (std::int32_t j = -kSide / 2; j < kSide / 2; ++j)
    for (std::int32_t i = -kSide / 2; i < kSide / 2; ++i)
      visit(std::uint32_t(i), std::uint32_t(j));
}

constexpr std::uint32_t kSizes[] = {1, 17, 64, 100, 255, 256, 512, 16384};

} // namespace

TEST_CASE("the lattice hash has its published test vectors") {
  // From an independent implementation of the two formulas in another language.
  CHECK(pcg(0u) == 129708002u);
  CHECK(pcg(1u) == 2831084092u);
}

TEST_CASE("tile offsets are whole steps inside the tile, 64 to 127 per side") {
  for (const std::uint32_t size : kSizes) {
    const std::uint32_t step = 1u << tileOffsetShift(size);
    std::set<std::uint32_t> found;
    forEachVertex([&](std::uint32_t i, std::uint32_t j) {
      found.insert(tileOffsetTexels(i, j, latticeSeed(1, 0), size, 1)[0]);
    });
    INFO(size << " texels");
    // With over 500 vertices per offset, the probability that one is missing is 1e-200.
    CHECK(found.size() == std::min(size, size / step));
    CHECK(found.size() <= 127);
    CHECK((size < 64 || found.size() >= 64));
    for (const std::uint32_t offset : found) {
      REQUIRE(offset < size);
      REQUIRE(offset % step == 0);
    }
  }
}

TEST_CASE("every tile offset is equally likely along each axis") {
  // The hash has 65,536 values, and only powers of two divide that. For other sizes its
  // probabilities are up to 0.2 % apart, which adds at most 0.1 to a statistic of about 100.
  for (const std::uint32_t size : kSizes)
    for (const std::uint32_t seed : {1u, 2u, 0xffffffffu}) {
      if (size == 1)
        continue; // one offset: nothing to compare
      const std::uint32_t shift = tileOffsetShift(size);
      std::vector<int> across(size >> shift, 0), down(size >> shift, 0);
      forEachVertex([&](std::uint32_t i, std::uint32_t j) {
        const auto offset = tileOffsetTexels(i, j, latticeSeed(seed, 0), size, size);
        ++across[offset[0] >> shift];
        ++down[offset[1] >> shift];
      });
      INFO(size << " texels, seed " << seed);
      CHECK(chiSquare(across) < chiSquareLimit(across.size() - 1));
      CHECK(chiSquare(down) < chiSquareLimit(down.size() - 1));
    }
}

TEST_CASE("the two axes of a tile offset, neighbours, planes and seeds are independent") {
  constexpr std::uint32_t kSize = 256;
  constexpr std::uint32_t kBins = 16; // per side; 256 vertices per bin
  const auto bin = [](std::uint32_t texel) { return texel * kBins / kSize; };
  const auto offset = [](std::uint32_t i, std::uint32_t j, std::uint32_t seed,
                         std::uint32_t plane) {
    return tileOffsetTexels(i, j, latticeSeed(seed, plane), kSize, kSize);
  };
  std::vector<std::vector<int>> joint(7, std::vector<int>(std::size_t(kBins * kBins), 0));
  forEachVertex([&](std::uint32_t i, std::uint32_t j) {
    const auto here = offset(i, j, 1, 0);
    const auto count = [&](std::size_t pair, const std::array<std::uint32_t, 2>& there) {
      // The difference of two independent uniform offsets is uniform on the torus.
      const auto dx = (kSize + there[0] - here[0]) % kSize;
      const auto dy = (kSize + there[1] - here[1]) % kSize;
      ++joint[pair][bin(dx) * kBins + bin(dy)];
    };
    ++joint[0][bin(here[0]) * kBins + bin(here[1])];
    count(1, offset(i + 1, j, 1, 0));
    count(2, offset(i, j + 1, 1, 0));
    count(3, offset(i + 1, j - 1, 1, 0));
    count(4, offset(i, j, 1, 1));
    count(5, offset(i, j, 2, 0));
    count(6, offset(i + 1, j, 2, 0));
  });
  for (std::size_t pair = 0; pair < joint.size(); ++pair) {
    INFO("pair " << pair);
    CHECK(chiSquare(joint[pair]) < chiSquareLimit(kBins * kBins - 1));
  }
}

TEST_CASE("an integer tile origin matches the skewed coordinates exactly") {
  const LatticeOrigin origin = latticeOrigin(10000000, -3);
  const long double column = 10000000.0L * 3.46410161513775458705489268301174488L;
  CHECK(origin.cell[0] == std::int32_t(std::floor(column)) + 6);
  CHECK(origin.cell[1] == -12);
  CHECK(std::abs(origin.fraction[0] - float(column - std::floor(column))) < 1e-7f);
  CHECK(origin.fraction[1] == 0.0f);
}

TEST_CASE("a periodic lattice has an even number of rows and covers its rectangle") {
  for (const double side : {0.4, 1.0, 1.37, 2.0, 4.0, 16.0}) {
    const Lattice lattice = periodicLattice(side, side);
    CHECK(lattice.periodRows % 2 == 0);
    CHECK(lattice.periodColumns / lattice.columnsPerTile == Approx(side));
    CHECK(lattice.periodRows / lattice.rowsPerTile == Approx(side));
  }
}
