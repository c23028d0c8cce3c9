// SPDX-License-Identifier: MIT
// The decomposition of [MKN12] section 4 as it is printed, for comparison: classes of power, cut
// into rectangles, whose weights are mended in 25 steps. Fitted kernels must follow spectra better
// with fewer of them.
#include "example_exemplar.h"

#include <lichen/fft.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <multiple_kernels/kernel_fit.h>
#include <vector>

using namespace lichen;
using namespace lichen::multiple_kernels;

namespace {

/// Frequencies [left, right) x [top, bottom).
struct Rectangle {
  int left = 0, right = 0, top = 0, bottom = 0;

  [[nodiscard]] int width() const { return right - left; }
  [[nodiscard]] int height() const { return bottom - top; }
  /// Calls act(u, v) for each frequency but 0.
  template <class Act>
  void forEach(const Act& act) const {
    for (int v = top; v < bottom; ++v)
      for (int u = left; u < right; ++u)
        if (u != 0 || v != 0)
          act(u, v);
  }
};

class PaperDecomposition {
public:
  PaperDecomposition(const spectra::PowerPlane& power, int classes)
      : power_(power), classes_(classes) {
    all_ = {0, power.columns, -(power.rows / 2), power.rows / 2 + 1};
    all_.forEach([&](int u, int v) {
      most_ = std::max(most_, power.at(u, v));
      sum_ += power.at(u, v);
    });
    for (int k = 0; k < classes; ++k)
      cut(bounding(all_, k), k);
  }

  /// One kernel for each rectangle, with weights after 25 steps.
  [[nodiscard]] std::vector<Kernel> kernels(const WindowSpectrum& spectrum) const {
    std::vector<Kernel> kernels;
    std::vector<double> wanted;
    for (const Rectangle& own : rectangles_) {
      double energy = 0.0;
      own.forEach([&](int u, int v) { energy += (u == 0 ? 1.0 : 2.0) * power_.at(u, v); });
      Kernel kernel;
      kernel.energy = energy;
      kernel.frequency = {0.5 * (own.left + own.right - 1), 0.5 * (own.top + own.bottom - 1)};
      // The transform of sinc(2 p) ends at 1.
      kernel.stretch = {2.0 / own.width(), 2.0 / own.height()};
      kernels.push_back(kernel);
      wanted.push_back(energy);
    }
    constexpr int kSteps = 25;
    constexpr double kEpsilon = 0.5;
    for (int step = 0; step < kSteps; ++step) {
      std::vector<double> factors;
      for (std::size_t k = 0; k < kernels.size(); ++k) {
        double found = 0.0;
        rectangles_[k].forEach([&](int u, int v) {
          for (const Kernel& kernel : kernels)
            found += (u == 0 ? 1.0 : 2.0) * densityAt(spectrum, kernel, u, v);
        });
        factors.push_back(found > 0.0 ? std::pow(wanted[k] / found, kEpsilon) : 1.0);
      }
      for (std::size_t k = 0; k < kernels.size(); ++k)
        kernels[k].energy *= factors[k];
    }
    return kernels;
  }

private:
  /// By its share of the largest power: the classes are equal steps of its root.
  [[nodiscard]] int classOf(int u, int v) const {
    return std::min(classes_ - 1, int(classes_ * std::sqrt(power_.at(u, v) / most_)));
  }

  /// The smallest rectangle in another that holds all of a class there.
  [[nodiscard]] Rectangle bounding(const Rectangle& in, int k) const {
    Rectangle box{in.right, in.left, in.bottom, in.top};
    in.forEach([&](int u, int v) {
      if (classOf(u, v) == k)
        box = {std::min(box.left, u), std::max(box.right, u + 1), std::min(box.top, v),
               std::max(box.bottom, v + 1)};
    });
    return box;
  }

  void cut(const Rectangle& own, int k) {
    if (own.width() <= 0 || own.height() <= 0)
      return;
    int held = 0, count = 0;
    double energy = 0.0;
    own.forEach([&](int u, int v) {
      held += int(classOf(u, v) == k);
      energy += power_.at(u, v);
      ++count;
    });
    // Less must be covered where there is little power.
    const double coverage = 0.3 + 0.4 * k / classes_;
    constexpr double kLeast = 1e-3; // of all power, beyond which cuts go on for ever
    if (held >= coverage * count || energy < kLeast * sum_ ||
        (own.width() <= 2 && own.height() <= 2)) {
      rectangles_.push_back(own);
      return;
    }
    Rectangle first = own, second = own;
    if (own.width() >= own.height())
      first.right = second.left = own.left + own.width() / 2;
    else
      first.bottom = second.top = own.top + own.height() / 2;
    cut(bounding(first, k), k);
    cut(bounding(second, k), k);
  }

  const spectra::PowerPlane& power_;
  int classes_;
  Rectangle all_;
  double most_ = 0.0, sum_ = 0.0;
  std::vector<Rectangle> rectangles_;
};

spectra::PowerPlane powerOf(const std::vector<float>& plane, int width, int height) {
  const HalfSpectrum spectrum = forwardFft(plane, width, height);
  spectra::PowerPlane power;
  power.columns = (width + 1) / 2;
  power.rows = 2 * ((height - 1) / 2) + 1;
  double sum = 0.0;
  for (int v = -(power.rows / 2); v <= power.rows / 2; ++v)
    for (int u = 0; u < power.columns; ++u) {
      const double own =
          u == 0 && v == 0
              ? 0.0
              : std::norm(std::complex<double>(spectrum.at(u, v < 0 ? v + height : v)));
      power.values.push_back(own);
      sum += (u == 0 ? 1.0 : 2.0) * own;
    }
  for (double& value : power.values)
    value /= sum;
  return power;
}

} // namespace

TEST_CASE("fitted kernels follow a spectrum better than the paper's rectangles, with fewer") {
  constexpr int kWidth = 96, kHeight = 64;
  const MapExemplar map = test::threeMaterials(kWidth, kHeight, 3);
  const WindowSpectrum gabor(KernelWindow::gabor), sinc(KernelWindow::sinc);
  for (const std::size_t channel : {std::size_t(0), std::size_t(2)}) {
    std::vector<float> plane;
    for (std::size_t i = channel; i < map.values.size(); i += 3)
      plane.push_back(map.values[i]);
    const spectra::PowerPlane power = powerOf(plane, kWidth, kHeight);
    const std::vector<Kernel> fitted = fitKernels(power, gabor, {8}).back().kernels;
    const double error = spectrumErrorDb(power, gabor, fitted);
    for (const int classes : {2, 3, 5}) {
      const std::vector<Kernel> rectangles = PaperDecomposition(power, classes).kernels(sinc);
      const double papers = spectrumErrorDb(power, sinc, rectangles);
      INFO("channel " << channel << ": " << fitted.size() << " kernels " << error << " dB, "
                      << rectangles.size() << " rectangles of " << classes << " classes " << papers
                      << " dB");
      CHECK(rectangles.size() >= fitted.size());
      CHECK(error < 0.9 * papers);
    }
  }
}
