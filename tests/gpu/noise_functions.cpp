// SPDX-License-Identifier: MIT
// The shader's integer hash and division against C++.
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

enum Function { kHash, kFloorDivide };

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
