// SPDX-License-Identifier: MIT
// Tests whichever backend the library was built with.
#include "exhausted_memory.h"
#include "fft_backend.h"

#include <lichen/fft.h>
#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstdint>
#include <fftw3.h>
#include <memory>
#include <numbers>
#include <thread>
#include <utility>
#include <vector>

using namespace lichen;

namespace {

struct Backend {
  const char* name;
  HalfSpectrum (*forward)(std::span<const float>, int, int);
  std::vector<float> (*inverse)(const HalfSpectrum&, int rows);
};
constexpr std::array<Backend, 2> kBackends{
    {{"FFTW", forwardFftw, inverseFftw}, {"KissFFT", forwardKissFft, inverseKissFft}}};

// Odd, even, prime, one row, one column, one pixel; the same height twice, for FFTW's last plan.
constexpr std::array<std::pair<int, int>, 10> kSizes{
    {{8, 8}, {7, 5}, {16, 9}, {13, 12}, {10, 12}, {31, 29}, {1, 17}, {18, 1}, {1, 1}, {2, 3}}};

std::vector<float> noise(int width, int height, std::uint32_t seed) {
  std::vector<float> plane;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      plane.push_back(float(pcg3d({std::uint32_t(x), std::uint32_t(y), seed})[0]) * 0x1p-32f);
  return plane;
}

/// The definition, term by term, in double precision.
std::complex<double> directSum(const std::vector<float>& plane, int width, int height, int u,
                               int v) {
  std::complex<double> sum = 0.0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double turns = double(u) * x / width + double(v) * y / height;
      sum += double(plane[std::size_t(y * width + x)]) *
             std::polar(1.0, -2.0 * std::numbers::pi * turns);
    }
  }
  return sum;
}

/// Single precision, relative to the root of the energy: measured at most 2e-7.
constexpr double kTolerance = 1e-6;

double rootEnergy(const std::vector<float>& plane) {
  double energy = 0.0;
  for (const float value : plane)
    energy += double(value) * double(value);
  return std::sqrt(energy * double(plane.size()));
}

} // namespace

TEST_CASE("both transforms agree with the direct sum, for any size") {
  for (const Backend& backend : kBackends) {
    for (const auto& [width, height] : kSizes) {
      const std::vector<float> plane = noise(width, height, 1);
      const HalfSpectrum spectrum = backend.forward(plane, width, height);
      REQUIRE(spectrum.values.size() == std::size_t((width / 2 + 1) * height));
      double worst = 0.0;
      for (int v = 0; v < height; ++v)
        for (int u = 0; u <= width / 2; ++u)
          worst = std::max(worst, std::abs(std::complex<double>(spectrum.at(u, v)) -
                                           directSum(plane, width, height, u, v)));
      INFO(backend.name << " " << width << " x " << height);
      CHECK(worst < kTolerance * rootEnergy(plane));
    }
  }
}

TEST_CASE("both transforms take and give a plane's first rows alone") {
  for (const Backend& backend : kBackends) {
    for (const auto& [width, height] : kSizes) {
      INFO(backend.name << " " << width << " x " << height);
      const int rows = (height + 1) / 2;
      const std::vector<float> plane = noise(width, height, 3), first = noise(width, rows, 3);
      std::vector<float> padded = first;
      padded.resize(plane.size(), 0.0f);
      const HalfSpectrum spectrum = backend.forward(first, width, height);
      const HalfSpectrum expected = backend.forward(padded, width, height);
      double worst = 0.0;
      for (std::size_t i = 0; i < expected.values.size(); ++i)
        worst = std::max(worst, double(std::abs(spectrum.values[i] - expected.values[i])));
      CHECK(worst < kTolerance * rootEnergy(first));
      const HalfSpectrum whole = backend.forward(plane, width, height);
      for (const int count : {height, rows}) {
        const std::vector<float> back = backend.inverse(whole, count);
        REQUIRE(back.size() == std::size_t(width * count));
        worst = 0.0;
        for (std::size_t i = 0; i < back.size(); ++i)
          worst = std::max(worst, double(std::abs(back[i] - plane[i])));
        CHECK(worst < kTolerance); // of values up to 1
      }
    }
  }
}

TEST_CASE("a host may plan with its own FFTW while the library transforms") {
  const std::vector<float> plane = noise(31, 29, 2);
  const HalfSpectrum expected = forwardFftw(plane, 31, 29);
  std::atomic<bool> isDone = false;
  std::thread host([&] {
    std::vector<float> in(64 * 48);
    std::vector<std::complex<float>> out(std::size_t(64 / 2 + 1) * 48);
    for (int size = 8; !isDone; size = size % 48 + 1) {
      const fftwf_plan plan = fftwf_plan_dft_r2c_2d(
          size, 64, in.data(), reinterpret_cast<fftwf_complex*>(out.data()), FFTW_ESTIMATE);
      fftwf_destroy_plan(plan);
    }
  });
  constexpr int kTransforms = 2000; // some overlap the host's without a common lock
  int same = 0;
  for (int k = 0; k < kTransforms; ++k)
    same += forwardFftw(plane, 31, 29).values == expected.values ? 1 : 0;
  isDone = true;
  host.join();
  CHECK(same == kTransforms);
}

TEST_CASE("multiplicities give the half spectrum the energy of the plane") {
  for (const auto& [width, height] : kSizes) {
    const std::vector<float> plane = noise(width, height, 4);
    const HalfSpectrum spectrum = forwardFft(plane, width, height);
    double energy = 0.0;
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < spectrum.columns(); ++u)
        energy += spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
    CHECK(std::sqrt(energy) == Approx(rootEnergy(plane)).epsilon(kTolerance));
  }
}

TEST_CASE("the sizes that transform fast have only the factors 2, 3 and 5") {
  for (int size = 1; size <= 200; ++size) {
    int least = 0;
    for (int two = 1; two <= 256; two *= 2)
      for (int three = two; three <= 256; three *= 3)
        for (int five = three; five <= 256; five *= 5)
          if (five >= size && (least == 0 || five < least))
            least = five;
    CHECK(fastTransformSize(size) == least);
  }
}

TEST_CASE("concurrent transforms on several threads give the same bytes") {
  constexpr int kThreads = 4, kSide = 60;
  std::array<std::vector<std::complex<float>>, kThreads> results;
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&result] {
      for (int repeat = 0; repeat < 20; ++repeat)
        result = forwardFft(noise(kSide, kSide, 5), kSide, kSide).values;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& result : results)
    CHECK(result == results[0]);
}
