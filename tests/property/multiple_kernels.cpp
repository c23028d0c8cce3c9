// SPDX-License-Identifier: MIT
// Multiple-kernels noise: its kernels' spectra against quadrature and closed forms, and the noise's
// covariance and spectrum against what its kernels say.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/fft.h>
#include <lichen/multiple_kernels.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <multiple_kernels/frequency_blocks.h>
#include <multiple_kernels/kernel.h>
#include <multiple_kernels/kernel_colors.h>
#include <multiple_kernels/kernel_fit.h>
#include <numbers>

using namespace lichen;
using namespace lichen::multiple_kernels;

namespace {

constexpr int kTexels = 128;
constexpr double kDeviation = 1.0 / 6.0;

const std::array kWindows{KernelWindow::gabor, KernelWindow::sinc, KernelWindow::gaussianSinc};

const Bundle& example() {
  static const Bundle bundle = [] {
    const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
    return test::bundleOf(bakeMultipleKernels("example", {&map, 1}, {}));
  }();
  return bundle;
}

/// Two Gabors, one of them round the frequency 0, and a ring.
std::vector<Kernel> someKernels() {
  return {{0.5, {9.0, -4.0}, {0.15, 0.1}, 0.04, false},
          {0.2, {0.5, 0.3}, {0.2, 0.3}, 0.0, false},
          {0.3, {14.0, 0.0}, {0.2, 0.2}, 0.0, true}};
}

constexpr std::array kNoAlias{1e6, 1e6}; // texels so small that no alias has power

double densityOf(const WindowSpectrum& spectrum, const Kernel& kernel, double u, double v) {
  return kernel.isRing ? ringDensityAt(spectrum, kernel, std::hypot(u, v))
                       : sampledDensityAt(spectrum, kernel, kNoAlias, u, v);
}

constexpr int kHalf = 64; // columns of plateauAndLine()

/// A plateau up to half the sampling frequency, as photographs have, under a slow slope; and a
/// line.
random_phase::PowerPlane plateauAndLine() {
  random_phase::PowerPlane power{kHalf, 2 * kHalf - 1, {}};
  for (int v = 1 - kHalf; v < kHalf; ++v)
    for (int u = 0; u < kHalf; ++u)
      power.values.push_back(0.2 + 40.0 / (1.0 + 0.01 * (u * u + v * v)) +
                             20.0 * std::exp(-0.5 * (v - 30.0) * (v - 30.0)));
  return power;
}

/// A bundle whose noise is Gaussian and has these kernels in three unrelated channels.
Bundle bundleWith(const std::vector<Kernel>& kernels, double impacts) {
  Bundle bundle = example();
  auto& shared = bundle.noises[0].as<MultipleKernelsNoise>();
  shared.kernels = int(kernels.size());
  shared.rings =
      int(std::count_if(kernels.begin(), kernels.end(), [](const Kernel& k) { return k.isRing; }));
  std::vector<KernelRow> rows;
  double energy = 0.0;
  for (const Kernel& kernel : kernels)
    energy += kernel.energy;
  for (const Kernel& kernel : kernels) {
    KernelRow row;
    const double cell =
        std::sqrt(kernel.area(KernelWindow::gabor) / (impacts * kernel.energy / energy));
    row.columns = row.rows = std::max(1, int(std::lround(kKernelTiles / cell)));
    row.frequency = {float(kernel.frequency[0]), float(kernel.frequency[1])};
    const Eigen::Matrix2d q = kernel.toWindow();
    row.toWindow = {float(q(0, 0)), float(q(0, 1)), float(q(1, 0)), float(q(1, 1))};
    const double density = double(row.columns * row.rows) / (kKernelTiles * kKernelTiles);
    row.amplitude = float(1.0 / std::sqrt(density * squareIntegral(KernelWindow::gabor, kernel)));
    for (std::size_t c = 0; c < 3; ++c)
      row.colors[c][c] = float(kDeviation * std::sqrt(kernel.energy / energy));
    rows.push_back(row);
  }
  bundle.tables[bundle.noises[0].maps[0].as<MultipleKernelsMap>().kernels] = kernelTable(rows);
  return bundle;
}

} // namespace

TEST_CASE("the spectrum of a window is its Fourier transform") {
  for (const KernelWindow window : kWindows) {
    const WindowSpectrum spectrum(window);
    constexpr int kSide = 400;
    double squares = 0.0;
    std::array<double, 3> sums{};
    const std::array<std::array<double, 2>, 3> frequencies{{{0.0, 0.0}, {0.4, 0.1}, {0.3, -0.7}}};
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const double p = (2.0 * i + 1.0) / kSide - 1.0, q = (2.0 * j + 1.0) / kSide - 1.0;
        const double value = windowAt(window, p, q) * 4.0 / (kSide * kSide);
        squares += value * windowAt(window, p, q);
        for (std::size_t k = 0; k < sums.size(); ++k)
          sums[k] += value * std::cos(2.0 * std::numbers::pi *
                                      (frequencies[k][0] * p + frequencies[k][1] * q));
      }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      std::array<double, 2> slopes{};
      INFO(nameOf(window) << " " << k);
      CHECK(spectrum.at(frequencies[k][0], frequencies[k][1], slopes) ==
            Approx(sums[k] / std::sqrt(squares)).margin(2e-3));
    }
  }
}

TEST_CASE("blocks become as narrow as a line in the spectrum") {
  random_phase::PowerPlane power{64, 127, std::vector<double>(64 * 127, 1.0)};
  for (int v = -63; v <= 63; ++v)
    power.values[std::size_t(v + 63) * 64 + 40] = 100.0; // at u = 40
  double width = 0.0;
  double count = 0.0;
  for (const FrequencyBlock& block : blocksOf(power)) {
    count += block.count;
    if (std::abs(block.u - 40.0) <= 0.5 * block.width)
      width = std::max(width, block.width);
    else if (block.u > 48.0)
      CHECK(block.width >= 4.0);
  }
  CHECK(width == 1.0);
  CHECK(count == Approx(63.0 * 127.0 + 0.5 * 126.0)); // column 0 counts half, (0, 0) not at all
}

TEST_CASE("the derivatives of a kernel's power equal differences") {
  for (const KernelWindow window : kWindows) {
    const WindowSpectrum spectrum(window);
    for (const Kernel& kernel : someKernels()) {
      if (kernel.isRing)
        continue;
      const auto moved = [&](std::size_t parameter, double by) {
        Kernel other = kernel;
        switch (parameter) {
        case 0:
          other.energy *= std::exp(by);
          break;
        case 1:
        case 2:
          other.frequency[parameter - 1] += by;
          break;
        case 3:
        case 4:
          other.stretch[parameter - 3] *= std::exp(by);
          break;
        default:
          other.shear += by;
        }
        return other;
      };
      for (const auto& [u, v] : {std::array{8.0, -3.0}, std::array{1.0, 2.0}}) {
        KernelSlopes slopes{};
        const double here = sampledDensityAt(spectrum, kernel, kNoAlias, u, v, &slopes);
        for (std::size_t p = 0; p < kKernelParameters; ++p) {
          const double step = p == 1 || p == 2 ? 0.02 : p == 5 ? 0.002 : 0.01;
          const double difference = (densityOf(spectrum, moved(p, step), u, v) -
                                     densityOf(spectrum, moved(p, -step), u, v)) /
                                    (2.0 * step);
          INFO(nameOf(window) << ", parameter " << p << " at " << u << ", " << v);
          CHECK(slopes[p] == Approx(difference).epsilon(0.05).margin(0.01 * here));
        }
      }
    }
  }
}

TEST_CASE("fitted kernels find the kernels that a spectrum was made of") {
  const WindowSpectrum spectrum(KernelWindow::gabor);
  constexpr int kHalf = 48;
  random_phase::PowerPlane power{kHalf, 2 * kHalf - 1, {}};
  const std::vector<Kernel> made{{0.6, {12.0, -9.0}, {0.05, 0.03}, 0.01, false},
                                 {0.4, {3.0, 2.0}, {0.04, 0.06}, 0.0, false}};
  for (int v = 1 - kHalf; v < kHalf; ++v)
    for (int u = 0; u < kHalf; ++u)
      power.values.push_back(sampledDensityAt(spectrum, made[0], texelsOf(power), u, v) +
                             sampledDensityAt(spectrum, made[1], texelsOf(power), u, v));
  const std::vector<Kernel> found = fitKernels(power, spectrum, {4}).back().kernels;
  CHECK(spectrumErrorDb(power, spectrum, found) < 0.3);
  // Rectangles alone are far from it.
  const WindowSpectrum sincs(KernelWindow::sinc);
  CHECK(spectrumErrorDb(power, sincs, fitKernels(power, sincs, {4}).back().kernels) > 1.0);
}

TEST_CASE("a spectrum without a direction becomes rings, and one with a direction does not") {
  const WindowSpectrum spectrum(KernelWindow::gabor);
  constexpr int kHalf = 48;
  const auto fittedTo = [&](const Kernel& kernel) {
    random_phase::PowerPlane power{kHalf, 2 * kHalf - 1, {}};
    for (int v = 1 - kHalf; v < kHalf; ++v)
      for (int u = 0; u < kHalf; ++u)
        power.values.push_back(densityOf(spectrum, kernel, u, v));
    return fitKernels(power, spectrum, {10}).back().kernels;
  };
  const std::vector<Kernel> rings = fittedTo({1.0, {20.0, 0.0}, {0.08, 0.08}, 0.0, true});
  REQUIRE(rings.size() == 1);
  CHECK(rings[0].isRing);
  CHECK(rings[0].frequency[0] == Approx(20.0).epsilon(0.03));
  CHECK(rings[0].energy == Approx(1.0).epsilon(0.05));
  for (const Kernel& kernel : fittedTo({1.0, {20.0, 5.0}, {0.08, 0.08}, 0.0, false}))
    CHECK_FALSE(kernel.isRing);
}

TEST_CASE("the noise has the spectrum of its kernels, variance 1 and no mean") {
  // Kernels in three channels that share no sign: 3 x 16 independent pictures of the spectrum.
  const std::vector<Kernel> kernels = someKernels();
  const Bundle bundle = bundleWith(kernels, 30.0);
  const auto evaluator = methodEvaluator(bundle, 0);
  constexpr int kTiles = 2, kSide = 128;
  constexpr std::uint32_t kSeeds = 16;
  Placement placement;
  placement.periodic = true;
  placement.periodTilesX = placement.periodTilesY = kTiles;
  std::vector<double> power(std::size_t(kSide) * kSide / 4, 0.0);
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    MaterialNoise use;
    use.seed = seed;
    const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, use, placement);
    std::array<std::vector<float>, 3> planes;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const float scale = float(kTiles) / kSide;
        const TileFootprint at{{float(x) * scale, float(y) * scale}, {}, {}};
        const auto value = evaluator->gaussian(0, material, at).value;
        for (std::size_t c = 0; c < 3; ++c) {
          planes[c].push_back((value[c] - 0.5f) / float(kDeviation));
          sum += double(planes[c].back());
          squares += double(planes[c].back()) * double(planes[c].back());
        }
      }
    for (const std::vector<float>& plane : planes) {
      const HalfSpectrum spectrum = forwardFft(plane, kSide, kSide);
      for (int v = 0; v < kSide / 2; ++v)
        for (int u = 0; u < kSide / 2; ++u)
          power[std::size_t(v) * kSide / 2 + std::size_t(u)] +=
              double(std::norm(spectrum.at(u, v))) / std::pow(double(kSide), 4.0);
    }
  }
  const double count = 3.0 * kSeeds;
  CHECK(std::abs(sum / (count * kSide * kSide)) < 0.02);
  CHECK(squares / (count * kSide * kSide) == Approx(1.0).margin(0.03));
  // Blocks of 8 x 8 frequencies, half a cycle per tile each: 3,072 powers, 2 % of deviation.
  const WindowSpectrum window(KernelWindow::gabor);
  for (int top = 0; top < 48; top += 8)
    for (int left = 0; left < 48; left += 8) {
      double found = 0.0, expected = 0.0;
      for (int v = top; v < top + 8; ++v)
        for (int u = left; u < left + 8; ++u) {
          if (u == 0 && v == 0)
            continue;
          found += power[std::size_t(v) * kSide / 2 + std::size_t(u)] / count;
          for (const Kernel& kernel : kernels)
            expected += densityOf(window, kernel, double(u) / kTiles, double(v) / kTiles) /
                        (kTiles * kTiles);
        }
      if (expected < 1e-3)
        continue;
      INFO("block " << left << ", " << top);
      CHECK(found == Approx(expected).epsilon(0.15));
    }
}

TEST_CASE("a period that fits few cells leaves the variance as it is") {
  // 1.9 cells a tile become one in a period of 3/4 of a tile: 1.33.
  const std::vector<Kernel> kernel{{1.0, {9.0, -4.0}, {0.15, 0.1}, 0.04, false}};
  const double impacts = kernel[0].area(KernelWindow::gabor) * 1.9 * 1.9;
  const Bundle bundle = bundleWith(kernel, impacts);
  const auto evaluator = methodEvaluator(bundle, 0);
  Placement placement;
  placement.periodic = true;
  placement.periodTilesX = placement.periodTilesY = 0.75;
  constexpr int kSide = 96, kSeeds = 8;
  double squares = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    MaterialNoise use;
    use.seed = seed;
    const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, use, placement);
    for (int k = 0; k < kSide * kSide; ++k) {
      const TileFootprint at{
          {0.75f * float(k % kSide) / kSide, 0.75f * float(k / kSide) / kSide}, {}, {}};
      for (const float value : evaluator->gaussian(0, material, at).value)
        squares += std::pow((double(value) - 0.5) / kDeviation, 2.0);
    }
  }
  // Every impact has the same energy, and no two overlap.
  CHECK(squares / (3.0 * kSeeds * kSide * kSide) == Approx(1.0).margin(1e-3));
}

TEST_CASE("a spectrum of any width is followed, with all its energy") {
  const WindowSpectrum spectrum(KernelWindow::gabor);
  const random_phase::PowerPlane power = plateauAndLine();
  const std::vector<Kernel> kernels = fitKernels(power, spectrum, {8}).back().kernels;
  CHECK(spectrumErrorDb(power, spectrum, kernels) < 0.8);
  double energy = 0.0, wanted = 0.0;
  for (const Kernel& kernel : kernels)
    energy += kernel.energy;
  for (int v = 1 - kHalf; v < kHalf; ++v)
    for (int u = 0; u < kHalf; ++u)
      wanted += (u == 0 && v == 0 ? 0.0
                 : u == 0         ? 1.0
                                  : 2.0) *
                power.values[std::size_t(v + kHalf - 1) * kHalf + std::size_t(u)];
  CHECK(energy == Approx(wanted).epsilon(0.05));
}

TEST_CASE("each count of kernels has its fit, and more come nearer") {
  const WindowSpectrum spectrum(KernelWindow::gabor);
  const random_phase::PowerPlane power = plateauAndLine();
  const std::vector<std::size_t> counts{2, 4, 8};
  const std::vector<KernelFit> fits = fitKernels(power, spectrum, counts);
  REQUIRE(fits.size() == counts.size());
  for (std::size_t k = 0; k < fits.size(); ++k) {
    CHECK(fits[k].kernels.size() <= counts[k]);
    CHECK(fits[k].decibels == spectrumErrorDb(power, spectrum, fits[k].kernels));
    if (k > 0)
      CHECK(fits[k].decibels < fits[k - 1].decibels);
  }
}

TEST_CASE("lobes of equal power have kernels of equal energy, whatever the window") {
  constexpr int kHalf = 48;
  const std::array<std::array<int, 2>, 3> lobes{{{20, 0}, {10, 18}, {10, -18}}};
  random_phase::PowerPlane power{kHalf, 2 * kHalf - 1, {}};
  for (int v = 1 - kHalf; v < kHalf; ++v)
    for (int u = 0; u < kHalf; ++u) {
      double sum = 0.0;
      for (const auto& [x, y] : lobes)
        sum += std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / 12.0);
      power.values.push_back(sum > 1e-3 ? sum : 0.0); // as a picture has it
    }
  for (const KernelWindow window : kWindows) {
    const WindowSpectrum spectrum(window);
    std::array<double, 3> energies{};
    double all = 0.0;
    const std::vector<Kernel> kernels = fitKernels(power, spectrum, {25}).back().kernels;
    for (const Kernel& kernel : kernels) {
      std::size_t nearest = 0;
      const auto distance = [&](std::size_t lobe) {
        // A frequency stands for its mirror too.
        const double u = lobes[lobe][0], v = lobes[lobe][1];
        return std::min(std::hypot(kernel.frequency[0] - u, kernel.frequency[1] - v),
                        std::hypot(kernel.frequency[0] + u, kernel.frequency[1] + v));
      };
      for (std::size_t lobe = 1; lobe < lobes.size(); ++lobe)
        if (distance(lobe) < distance(nearest))
          nearest = lobe;
      energies[nearest] += kernel.energy;
      all += kernel.energy;
    }
    for (const double energy : energies)
      CHECK(energy / all == Approx(1.0 / 3.0).margin(0.07));
  }
}

TEST_CASE("kernels have the covariance of what their spectra lack") {
  MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
  MultipleKernelsOptions options;
  SECTION("channels that correlate at the highest frequency, which has no kernel") {
    for (int y = 0; y < kTexels; ++y)
      for (int x = 0; x < kTexels; ++x)
        for (std::size_t c = 1; c < 3; ++c) {
          float& value = map.values[std::size_t(y * kTexels + x) * 3 + c];
          value = 0.2f + 0.6f * value + ((x + y) % 2 == 0 ? 0.1f : -0.1f);
        }
  }
  SECTION("a given spectrum of a few frequencies, whose random phases are related by chance") {
    constexpr int kSide = 33;
    SpectrumPicture picture{kSide, kSide, std::vector<float>(kSide * kSide, 0.0f), 1};
    picture.amplitudes[kSide * (kSide / 2 - 3) + kSide / 2 + 4] = 1.0f;
    if (GENERATE(true, false))
      picture.amplitudes[kSide * (kSide / 2 + 2) + kSide / 2 + 5] = 0.5f;
    options.spectrum = picture;
  }
  const Bundle bundle = test::bundleOf(bakeMultipleKernels("example", {&map, 1}, options));
  const Noise& noise = bundle.noises[0];
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const KernelRow& row :
       kernelRows(bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels],
                  noise.as<MultipleKernelsNoise>()))
    for (std::size_t wave = 0; wave < std::size_t(kWaves); ++wave) {
      const Eigen::Vector3d color =
          Eigen::Vector3f(row.colors[0][wave], row.colors[1][wave], row.colors[2][wave])
              .cast<double>();
      covariance += color * color.transpose() / (kDeviation * kDeviation);
    }
  CHECK((covariance - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 0.005);
}

TEST_CASE("by default 30 impacts of kernels reach a point") {
  const Noise& noise = example().noises[0];
  double impacts = 0.0;
  for (const KernelRow& row :
       kernelRows(example().tables[noise.maps[0].as<MultipleKernelsMap>().kernels],
                  noise.as<MultipleKernelsNoise>()))
    impacts += std::numbers::pi / (double(row.toWindow[0]) * double(row.toWindow[3])) * // area
               row.columns * row.rows / (kKernelTiles * kKernelTiles);
  CHECK(impacts == Approx(30.0).epsilon(0.1)); // whole cells
}
