// SPDX-License-Identifier: MIT
// Images -> histograms and spectra -> SVG.
#include "charts.h"

#include "markup.h"

#include <lichen/spectrum.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {
namespace {

using Point = std::array<double, 2>;

/// An SVG whose points lie in [0, 1], y upwards. Lengths are in SVG units.
class Chart {
public:
  struct Box {
    double width, height, left, right, top, bottom; ///< of the whole, and its margins
  };

  Chart(std::string_view label, const Box& box) : label_(label), box_(box) {}

  [[nodiscard]] double toX(double x) const {
    return box_.left + x * (box_.width - box_.left - box_.right);
  }
  [[nodiscard]] double toY(double y) const {
    return box_.height - box_.bottom - y * (box_.height - box_.top - box_.bottom);
  }
  void horizontal(double y) {
    content_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)", toX(0),
                            toY(y), toX(1), toY(y));
  }
  /// A text at SVG coordinates.
  void text(double x, double y, std::string_view anchor, std::string_view words) {
    content_ += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y,
                            anchor, htmlText(words));
  }
  void path(std::span<const Point> points, std::string_view look) {
    std::string commands;
    for (const auto& [x, y] : points)
      commands += fmt::format("{}{:.1f} {:.1f}", commands.empty() ? 'M' : 'L', toX(x), toY(y));
    content_ += fmt::format(R"(<path d="{}" {}/>)", commands, look);
  }
  [[nodiscard]] std::string markup() const {
    return element(fmt::format(R"(svg viewBox="0 0 {} {}" role="img" aria-label="{}")", box_.width,
                               box_.height, label_),
                   content_) +
           "\n";
  }

private:
  std::string label_, content_;
  Box box_;
};

/// The shares of a channel's values in bins of equal width.
std::vector<double> sharesOf(const SrgbImage& image, std::size_t channel) {
  constexpr std::size_t kBins = 64;
  std::vector<double> shares(kBins);
  for (std::size_t i = channel; i < image.values.size(); i += std::size_t(image.channels)) {
    const float place = std::clamp(image.values[i], 0.0f, 1.0f) * float(kBins);
    shares[std::min(std::size_t(place), kBins - 1)] += 1.0 / double(image.pixelCount());
  }
  return shares;
}

/// Bars of equal width as an outline: two points a bar, on the axis at both ends.
std::vector<Point> outlineOf(std::span<const double> shares, double most) {
  std::vector<Point> outline{{0.0, 0.0}};
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (const std::size_t side : {i, i + 1})
      outline.push_back({double(side) / double(shares.size()), shares[i] / most});
  outline.push_back({1.0, 0.0});
  return outline;
}

} // namespace

std::string histogramChart(const SrgbImage& exemplar, const SrgbImage& result, std::size_t channel,
                           double largest) {
  constexpr double kTextHeight = 16.0;
  const std::array shares{sharesOf(exemplar, channel), sharesOf(result, channel)};
  const double most = std::max(std::ranges::max(shares[0]), std::ranges::max(shares[1]));
  const Chart::Box box{320, 150, 8, 8, 6, 22};
  Chart chart("Histogram", box);
  chart.path(outlineOf(shares[0], most), R"(class="area")");
  chart.path(outlineOf(shares[1], most), R"(class="result")");
  chart.horizontal(0.0);
  for (const auto& [x, anchor] : {std::pair{0.0, "start"}, {0.5, "middle"}, {1.0, "end"}})
    chart.text(chart.toX(x), chart.toY(0.0) + kTextHeight, anchor, shownNumber(x * largest));
  return chart.markup();
}

int spectrumCrop(const SrgbImage& a, const SrgbImage& b) {
  const int crop = comparedCropSide(std::min({a.width, a.height, b.width, b.height}));
  return crop < 2 * kLowestComparedCycles ? 0 : crop;
}

SpectrumCurve spectrumCurve(std::string_view kind, const SrgbImage& image, int crop) {
  constexpr double kLeastPower = 1e-12; // power of an image without variance
  SpectrumCurve curve{kind,
                      radialPowerSpectrum(luminancePlane(image), image.width, image.height, crop)};
  for (double& value : curve.power)
    value = 10.0 * std::log10(std::max(value, kLeastPower));
  return curve;
}

std::string spectrumChart(std::span<const SpectrumCurve> curves, int crop) {
  constexpr double kStep = 10.0; // decibels between lines
  const double lowest = 1.0 / crop, highest = 0.5;
  double least = INFINITY, most = -INFINITY;
  for (const SpectrumCurve& curve : curves) {
    const auto [low, high] = std::ranges::minmax(std::span(curve.power).subspan(1));
    least = std::min(least, low);
    most = std::max(most, high);
  }
  const double bottom = kStep * std::floor(least / kStep);
  const double top = std::max(bottom + kStep, kStep * std::ceil(most / kStep));
  const Chart::Box box{640, 300, 56, 16, 10, 48};
  Chart chart("Power spectra", box);
  const auto toX = [&](double frequency) {
    return std::log2(frequency / lowest) / std::log2(highest / lowest);
  };
  const auto toY = [&](double power) { return (power - bottom) / (top - bottom); };
  for (double power = bottom; power <= top; power += kStep) {
    chart.horizontal(toY(power));
    chart.text(box.left - 8, chart.toY(toY(power)) + 4, "end",
               fmt::format("{}{}", power, power + kStep > top ? " dB" : ""));
  }
  for (double period = 2.0; period <= crop * 1.001; period *= 2.0)
    chart.text(chart.toX(toX(1.0 / period)), box.height - 26, "middle",
               fmt::format("1/{}", period));
  chart.text(chart.toX(0.5), box.height - 6, "middle", "cycles per pixel");
  for (const SpectrumCurve& curve : curves) {
    std::vector<Point> points;
    for (std::size_t cycles = 1; cycles < curve.power.size(); ++cycles)
      points.push_back({toX(double(cycles) * lowest), toY(curve.power[cycles])});
    chart.path(points, fmt::format(R"(class="{}")", curve.kind));
  }
  return chart.markup();
}

} // namespace lichen
