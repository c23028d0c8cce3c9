// SPDX-License-Identifier: MIT
// The shader's integer hash, lattices and distribution function against C++.
#include "compute_run.h"
#include "require_device.h"

#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <noise_functions.comp.h>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

using Words = std::array<std::uint32_t, 4>;

enum Function { kHash, kTriangle, kCdf, kFloorDivide, kCellNumber };

/// Three answers for each question.
std::vector<Words> ask(Function function, const std::vector<Words>& questions) {
  const auto device = requireDevice();
  ComputeRun run;
  run.spirv = noise_functions_comp;
  run.constants[0] = function;
  const std::vector<Words> answers = runCompute<Words>(*device, run, questions, 3);
  CHECK(device->messages().texts().empty());
  return answers;
}

} // namespace

TEST_CASE("the hash is the same in GLSL and C++, bit for bit, also for negative and wrapping "
          "cells") {
  std::mt19937 generator(1u);
  const auto random = [&] { return std::uint32_t(generator()); };
  std::vector<Words> questions;
  for (const std::uint32_t i : {0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
    for (const std::uint32_t j : {0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
      questions.push_back({i, j, latticeSeed(1u, 0u), 7u});
  while (questions.size() < 20000)
    questions.push_back({random(), random(), random(), random()});
  const std::vector<Words> answers = ask(kHash, questions);
  constexpr std::array kCosines{1.0f, 0.0f, -1.0f, 0.0f}, kSines{0.0f, 1.0f, 0.0f, -1.0f};
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const auto [i, j, word, seed] = questions[k];
    const auto hash = pcg3d({i, j, word});
    const auto offset = tileOffsetSteps(i, j, word);
    const std::uint32_t half = tileQuarterTurns(i, j, word, 2);
    const std::uint32_t quarters = tileQuarterTurns(i, j, word, 4);
    REQUIRE(answers[3 * k] ==
            Words{hash[0], hash[1], hash[2], std::bit_cast<std::uint32_t>(kCosines[half])});
    REQUIRE(answers[3 * k + 1] == Words{offset[0], offset[1], vertexHash(i, j, word), 0u});
    REQUIRE(answers[3 * k + 2][0] == latticeSeed(seed, word & 3u));
    REQUIRE(answers[3 * k + 2][1] == pcg(i));
    REQUIRE(answers[3 * k + 2][2] == std::bit_cast<std::uint32_t>(kCosines[quarters]));
    REQUIRE(answers[3 * k + 2][3] == std::bit_cast<std::uint32_t>(kSines[quarters]));
  }
}

TEST_CASE("the triangle's vertices surround the point and its weights are barycentric") {
  std::mt19937 random(2u);
  std::uniform_real_distribution<float> tiles(-20.0f, 20.0f);
  std::vector<Words> questions;
  for (int k = 0; k < 20000; ++k) // every fourth near the wrap of the cell number
    questions.push_back({std::bit_cast<std::uint32_t>(tiles(random)),
                         std::bit_cast<std::uint32_t>(tiles(random)),
                         k % 4 == 0 ? 0x80000000u : std::uint32_t(-k), std::uint32_t(3 * k)});
  const std::vector<Words> answers = ask(kTriangle, questions);
  // Coordinates up to 20 tiles, 80 cells: rounded three times to 2^-18 cells.
  constexpr double kTolerance = 3.0 / 262144.0;
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const double x = double(std::bit_cast<float>(questions[k][0]));
    const double y = double(std::bit_cast<float>(questions[k][1]));
    const double a = x * 3.5 - 2.0 * y, b = y * 4.0;
    double sum = 0.0, sumA = 0.0, sumB = 0.0;
    for (std::size_t v = 0; v < 3; ++v) {
      const double weight = double(std::bit_cast<float>(answers[3 * k + 2][v]));
      REQUIRE(weight >= 0.0);
      REQUIRE(weight <= 1.0);
      sum += weight;
      sumA += weight * double(std::int32_t(answers[3 * k][v] - questions[k][2]));
      sumB += weight * double(std::int32_t(answers[3 * k + 1][v] - questions[k][3]));
    }
    REQUIRE(std::abs(sum - 1.0) < 3e-7);
    REQUIRE(std::abs(sumA - a) < kTolerance);
    REQUIRE(std::abs(sumB - b) < kTolerance);
  }
}

TEST_CASE("the Gaussian's distribution function matches std::erf within 2e-4 up to its reach, and "
          "stays there beyond") {
  std::vector<Words> questions;
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  for (float g = -4.0f; g <= 5.0f; g += 0.001f)
    questions.push_back({bits(g), bits(1.0f - g), bits(g * 100.0f), 0u});
  constexpr double kReach = 0.48083; // 2.885 deviations of 1/6
  const std::vector<Words> answers = ask(kCdf, questions);
  for (std::size_t k = 0; k < questions.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double g = double(std::bit_cast<float>(questions[k][c]));
      const double x = std::clamp(g - 0.5, -kReach, kReach);
      const double expected = 0.5 + 0.5 * std::erf(3.0 * std::sqrt(2.0) * x);
      REQUIRE(std::abs(double(std::bit_cast<float>(answers[3 * k][c])) - expected) < 2e-4);
    }
}

TEST_CASE("division that rounds down is exact below 2^22") {
  constexpr std::uint32_t kMost = (1u << 22) - 1u;
  std::mt19937 generator(3u);
  const auto random = [&] { return (std::uint32_t(generator()) & kMost) - kMost / 2u; };
  std::vector<Words> questions;
  for (const std::uint32_t period : {1u, 2u, 3u, 7u, 14u, 64u, 1000u, 2047u, 226859u})
    for (std::uint32_t k = 0; k < 2000; ++k) {
      const std::uint32_t edge = period * (k % (kMost / period));
      questions.push_back({random(), edge, 0u - edge - 1u, period});
    }
  for (const std::uint32_t period : {1u, 3u, 7u, 4095u})
    questions.push_back({kMost, 0u - kMost, kMost - kMost % period - 1u, period});
  const std::vector<Words> answers = ask(kFloorDivide, questions);
  for (std::size_t k = 0; k < questions.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = double(std::int32_t(questions[k][c]));
      const double expected = std::floor(value / double(questions[k][3]));
      REQUIRE(double(std::int32_t(answers[3 * k][c])) == expected);
    }
}

TEST_CASE("the number of a texton's cell is exact in any period, for all cells that floats can "
          "represent") {
  // Up to 2^28 tiles of 2^19 cells, the most that placements and grids have between them; a period
  // of few cells is never of so fine a grid.
  constexpr int kMostBits = 47, kMostBitsOfFewCells = 44;
  constexpr std::uint32_t kFewCells = 8;
  std::mt19937 generator(4u);
  const auto cellBits = [&](std::uint32_t period) { // whole, of any magnitude and either sign
    const int most = period != 0 && period < kFewCells ? kMostBitsOfFewCells : kMostBits;
    const float mantissa = float(0x800000u | (generator() & 0x7fffffu));
    const int exponent = int(generator() % std::uint32_t(most)) + 1 - 24;
    const float cell = std::trunc(std::ldexp(mantissa, exponent));
    return std::bit_cast<std::uint32_t>(generator() % 2 == 0 ? cell : -cell);
  };
  std::vector<Words> questions;
  for (const std::uint32_t period : {0u, 1u, 3u, 7u, 64u, 1000u, 76029u, (1u << 24) - 3u,
                                     226859u * 1000u, (1u << 29) - 1u, 1u << 29})
    for (int k = 0; k < 2000; ++k)
      questions.push_back({cellBits(period), cellBits(period), cellBits(period), period});
  const std::vector<Words> answers = ask(kCellNumber, questions);
  for (std::size_t k = 0; k < questions.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto cell = std::int64_t(std::bit_cast<float>(questions[k][c]));
      const std::int64_t modulus =
          questions[k][3] == 0 ? std::int64_t(1) << 32 : std::int64_t(questions[k][3]);
      INFO("cell " << cell << ", period " << questions[k][3]);
      REQUIRE(std::int64_t(answers[3 * k][c]) == (cell % modulus + modulus) % modulus);
    }
}
