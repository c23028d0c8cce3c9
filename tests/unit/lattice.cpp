// SPDX-License-Identifier: MIT
// The lattice's hash, offsets, origins and periodic forms: values and distribution.
#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

/// The same of counts with these probabilities; where one is 0, the count must be.
double chiSquare(const std::vector<int>& counts, const std::vector<double>& probabilities) {
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double expected = total * probabilities[k];
    if (expected == 0.0)
      REQUIRE(counts[k] == 0);
    else
      sum += (counts[k] - expected) * (counts[k] - expected) / expected;
  }
  return sum;
}

std::size_t possible(const std::vector<double>& probabilities) {
  return std::size_t(std::count_if(probabilities.begin(), probabilities.end(),
                                   [](double probability) { return probability > 0.0; }));
}

/// Calls visit(i, j) for 65,536 vertices on both sides of the origin, where coordinates wrap.
template <class Visit>
void forEachVertex(Visit visit) {
  constexpr std::int32_t kSide = 256;
  for (std::int32_t j = -kSide / 2; j < kSide / 2; ++j)
    for (std::int32_t i = -kSide / 2; i < kSide / 2; ++i)
      visit(std::uint32_t(i), std::uint32_t(j));
}

using Hash = std::function<std::uint32_t(std::uint32_t, std::uint32_t, std::uint32_t)>;

/// The words of four vertices. Some two of N unrelated windows are equal with a probability of
/// N^2 / 2^129, below 1e-26 for the windows here.
using Window = std::array<std::uint32_t, 4>;
Window windowAt(const Hash& hash, std::uint32_t i, std::uint32_t j, std::uint32_t seed) {
  return {hash(i, j, seed), hash(i + 1, j, seed), hash(i, j + 1, seed), hash(i + 1, j + 1, seed)};
}

/// Whether the window at a point of a square occurs again, up to 2^16 vertices away along each
/// axis. Every hash of a sum i A + j B modulo 2^32 has such a period, by Minkowski's theorem.
bool hasPeriod(const Hash& hash) {
  // Every distance is a multiple of 256, less a point of a square of 256 x 256.
  constexpr std::uint32_t kStride = 256;
  std::vector<Window> near;
  for (std::uint32_t j = 0; j < kStride; ++j)
    for (std::uint32_t i = 0; i < kStride; ++i)
      near.push_back(windowAt(hash, i, j, 1));
  std::sort(near.begin(), near.end());
  constexpr int kMost = 257;
  for (int column = 0; column <= kMost; ++column)
    for (int row = -kMost; row <= kMost; ++row) {
      const Window far =
          windowAt(hash, std::uint32_t(column) * kStride, std::uint32_t(row) * kStride, 1);
      if ((column != 0 || row != 0) && std::binary_search(near.begin(), near.end(), far))
        return true;
    }
  return false;
}

/// Whether the field of `seed` is the field of seed 1, shifted along a row or along a column by any
/// distance but 0.
bool isShifted(const Hash& hash, std::uint32_t seed) {
  // Every distance is a multiple of 2^16 less a number below 2^16.
  constexpr std::uint32_t kStride = 1u << 16u;
  for (const bool alongRow : {true, false}) {
    const auto at = [&](std::uint32_t distance, std::uint32_t of) {
      return alongRow ? windowAt(hash, distance, 0, of) : windowAt(hash, 0, distance, of);
    };
    std::vector<Window> near;
    for (std::uint32_t k = 0; k < kStride; ++k)
      near.push_back(at(k, 1));
    std::sort(near.begin(), near.end());
    for (std::uint32_t k = 1; k <= kStride; ++k) // the last wraps to 0
      if (seed != 1 || k < kStride)
        if (std::binary_search(near.begin(), near.end(), at(k * kStride, seed)))
          return true;
  }
  return false;
}

constexpr std::uint32_t kShifts = 300; // columns and rows, in both directions

/// The sorted windows of a seed word's field at all shifts of up to kShifts.
std::vector<Window> windowsWithinShifts(const Hash& hash, std::uint32_t word) {
  std::vector<Window> near;
  for (std::uint32_t j = 0; j <= 2 * kShifts; ++j)
    for (std::uint32_t i = 0; i <= 2 * kShifts; ++i)
      near.push_back(windowAt(hash, i - kShifts, j - kShifts, word));
  std::sort(near.begin(), near.end());
  return near;
}

/// How many seed words that differ from `word` in one bit, or by a power of two, give its field
/// shifted by up to kShifts columns and rows.
int countShifted(const Hash& hash, std::uint32_t word) {
  const std::vector<Window> near = windowsWithinShifts(hash, word);
  int count = 0;
  for (std::uint32_t k = 0; k < 32; ++k)
    for (const std::uint32_t other : {word ^ (1u << k), word + (1u << k), word - (1u << k)})
      count += int(std::binary_search(near.begin(), near.end(), windowAt(hash, 0, 0, other)));
  return count;
}

constexpr Grain kGrains[] = {Grain::none, Grain::x, Grain::y};

constexpr std::uint32_t kSizes[] = {1, 17, 64, 100, 255, 256, 512, 16384};

} // namespace

TEST_CASE("tile offsets are whole steps inside the tile, at least 64 per side") {
  for (const std::uint32_t size : kSizes) {
    const std::uint32_t step = 1u << tileOffsetShift(size);
    std::set<std::uint32_t> found;
    forEachVertex([&](std::uint32_t i, std::uint32_t j) {
      found.insert(tileOffsetTexels(i, j, latticeSeed(1, 0), size, 1)[0]);
    });
    INFO(size << " texels");
    // With over 500 vertices per offset, the probability that one is missing is 1e-200.
    if (size % step == 0)
      CHECK(found.size() == size / step);
    CHECK((size < 64 || found.size() >= 64));
    for (const std::uint32_t offset : found) {
      REQUIRE(offset < size);
      REQUIRE((size % step != 0 || offset % step == 0));
    }
  }
}

TEST_CASE("tile offsets are equally likely along each axis, but for the steps that do not fill the "
          "tile") {
  for (const std::uint32_t size : kSizes)
    for (const std::uint32_t seed : {1u, 2u, 0xffffffffu}) {
      if (size == 1)
        continue; // one offset: nothing to compare
      const std::uint32_t shift = tileOffsetShift(size);
      std::vector<int> across(size, 0), down(size, 0);
      forEachVertex([&](std::uint32_t i, std::uint32_t j) {
        const auto offset = tileOffsetTexels(i, j, latticeSeed(seed, 0), size, size);
        ++across[offset[0]];
        ++down[offset[1]];
      });
      INFO(size << " texels, seed " << seed);
      // 2048 steps, modulo the size: some offsets come once more often.
      std::vector<double> expected(size, 0.0);
      for (std::uint32_t step = 0; step < 2048; ++step)
        expected[(step << shift) % size] += 1.0 / 2048.0;
      CHECK(chiSquare(across, expected) < chiSquareLimit(possible(expected) - 1));
      CHECK(chiSquare(down, expected) < chiSquareLimit(possible(expected) - 1));
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

TEST_CASE("no translation repeats the field, and other seeds do not shift it along its axes") {
  const auto hash = [](std::uint32_t i, std::uint32_t j, std::uint32_t seed) {
    return vertexHash(i, j, latticeSeed(seed, 0));
  };
  CHECK_FALSE(hasPeriod(hash));
  for (const std::uint32_t seed : {1u, 2u, 3u, 0x80000001u, 0xffffffffu}) {
    INFO("seed " << seed);
    CHECK_FALSE(isShifted(hash, seed));
  }
}

TEST_CASE("seed words that differ in one bit do not shift the field by fewer than 2^31 rows") {
  for (const std::uint32_t word : {0u, latticeSeed(1, 0), latticeSeed(7, 2)}) {
    CHECK(countShifted(vertexHash, word) == 0);
    // The one shift there is: the highest bit of a sum has no carry, so adding it flips it.
    for (const std::uint32_t i : {0u, 1u, 0xfffffffeu})
      CHECK(windowAt(vertexHash, i, 5u + 0x80000000u, word ^ 0x80000000u) ==
            windowAt(vertexHash, i, 5u, word));
  }
}

TEST_CASE("an integer tile origin matches the skewed coordinates exactly") {
  CHECK(latticeCell(10000000, -3) == std::array{35000006, -12});
  // Modulo 2^32, also of negative tiles: 7 2^39 + 2 (2^40 - 1) is -2 modulo 2^32.
  CHECK(latticeCell(std::int64_t(1) << 40, (std::int64_t(1) << 40) - 1) == std::array{2, -4});
  CHECK(latticeCell(-2, 0) == std::array{-7, 0});
}

TEST_CASE("an origin step has a whole number of columns and is as short as possible") {
  for (const Grain grain : kGrains) {
    const Lattice lattice = infiniteLattice(grain);
    const std::int64_t step = latticeOriginStep(grain);
    REQUIRE(step >= 1);
    for (std::int64_t tiles = 1; tiles <= step; ++tiles) {
      const double columns = double(tiles) * lattice.columnsPerTile;
      INFO("grain " << int(grain) << ", " << tiles << " tiles");
      CHECK((columns == std::floor(columns)) == (tiles == step));
    }
  }
}

TEST_CASE("a point has the same triangle and weights from any tile origin, with any grain") {
  constexpr std::int64_t kFar = std::int64_t(1) << 40;
  for (const Grain grain : kGrains) {
    const Lattice lattice = infiniteLattice(grain);
    const std::int64_t step = latticeOriginStep(grain);
    CHECK(step == (grain == Grain::x ? 4 : 2));
    for (const std::int64_t tileX : {std::int64_t(0), step, -step, 2500000 * step, kFar, -kFar})
      for (const std::int64_t tileY :
           {std::int64_t(0), std::int64_t(1), std::int64_t(-3), kFar - 1})
        for (int point = -20; point <= 20; ++point) {
          // Exact in double: numbers below 2^43 that are multiples of 2^-9.
          const double x = 0.125 * point + 1.0 / 64.0, y = 0.3125 * point - 1.0 / 64.0;
          const auto skewed = [&](double px, double py) {
            const double b = lattice.rowsPerTile * py;
            return std::array{lattice.columnsPerTile * px - 0.5 * b, b};
          };
          const auto here = skewed(x, y);
          const auto fromZero = skewed(double(tileX) + x, double(tileY) + y);
          const auto cell = latticeCell(tileX, tileY, grain);
          INFO("grain " << int(grain) << ", tile " << tileX << ", " << tileY);
          for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto column = std::int64_t(std::floor(here[axis]));
            const auto expected = std::int64_t(std::floor(fromZero[axis]));
            REQUIRE(std::uint32_t(cell[axis]) + std::uint32_t(column) == std::uint32_t(expected));
            REQUIRE(here[axis] - double(column) == fromZero[axis] - double(expected));
          }
        }
  }
}

TEST_CASE("a periodic lattice has an even number of rows and covers its rectangle") {
  for (const double side : {0.4, 1.0, 1.37, 2.0, 4.0, 16.0})
    for (const Grain grain : kGrains) {
      const Lattice lattice = periodicLattice(side, side, grain);
      CHECK(lattice.periodRows % 2 == 0);
      CHECK(lattice.periodColumns / lattice.columnsPerTile == Approx(side));
      CHECK(lattice.periodRows / lattice.rowsPerTile == Approx(side));
    }
}

TEST_CASE("a periodic lattice is stretched along the grain, but never below 3 columns and 4 rows") {
  const auto counts = [](double side, Grain grain) {
    const Lattice lattice = periodicLattice(side, side, grain);
    return std::array{lattice.periodColumns, lattice.periodRows};
  };
  CHECK(counts(4.0, Grain::none) == std::array{14, 16});
  CHECK(counts(4.0, Grain::x) == std::array{7, 16});
  CHECK(counts(4.0, Grain::y) == std::array{14, 8});
  CHECK(counts(1.0, Grain::none) == std::array{4, 4});
  CHECK(counts(1.0, Grain::x) == std::array{3, 4});
  CHECK(counts(1.0, Grain::y) == std::array{4, 4});
}
