// SPDX-License-Identifier: MIT
// A picture -> the part inside its frame.
#include "frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lichen::exemplar {
namespace {

// docs/decisions/005-exemplar.md says what these find.
constexpr int kFewestLines = 16;
constexpr double kLargestShare = 0.25; // of the side, for the frame at one border
constexpr double kContrast = 0.25;     // of the median of all lines
constexpr double kFarMean = 3.0;       // times the median distance from the median mean
constexpr int kSmoothed = 2;           // pixels

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Lines [begin, end).
struct LineRange {
  int begin = 0, end = 0;
};

/// Means and contrasts of all rows, or all columns, by the mean of their channels.
class LineStatistics {
public:
  void add(double sum, double squares, int count) {
    means_.push_back(sum / count);
    contrasts_.push_back(std::sqrt(std::max(0.0, squares / count - means_.back() * means_.back())));
  }

  /// The lines inside the frame; all, if there is none.
  [[nodiscard]] LineRange insideFrame() const {
    const int count = int(means_.size());
    if (count < kFewestLines)
      return {0, count};
    const double contrast = medianOf(contrasts_), mean = medianOf(means_);
    std::vector<double> distances;
    for (const double value : means_)
      distances.push_back(std::abs(value - mean));
    const double scatter = medianOf(distances);
    const auto isFrame = [&](int line) {
      const auto i = std::size_t(line);
      return contrasts_[i] < kContrast * contrast && distances[i] > kFarMean * scatter;
    };
    LineRange inside{0, count};
    while (inside.begin < count && isFrame(inside.begin))
      ++inside.begin;
    while (inside.end > inside.begin && isFrame(inside.end - 1))
      --inside.end;
    const double most = kLargestShare * count;
    if (inside.begin > most || count - inside.end > most)
      return {0, count};
    if (inside.begin > 0)
      inside.begin += kSmoothed;
    if (inside.end < count)
      inside.end -= kSmoothed;
    for (int line = inside.begin; line < inside.end; ++line)
      if (isFrame(line))
        return {0, count};
    return inside;
  }

private:
  std::vector<double> means_, contrasts_;
};

double brightness(const MapExemplar& map, int x, int y) {
  const std::size_t channels = map.channels.size();
  const float* const pixel =
      &map.values[(std::size_t(y) * std::size_t(map.width) + std::size_t(x)) * channels];
  double sum = 0.0;
  for (std::size_t c = 0; c < channels; ++c)
    sum += double(pixel[c]);
  return sum / double(channels);
}

/// Adds a line of `count` pixels; brightnessAt(k) is the brightness of its k-th.
template <typename BrightnessAt>
void addLine(LineStatistics& lines, int count, const BrightnessAt& brightnessAt) {
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < count; ++k) {
    const double value = brightnessAt(k);
    sum += value;
    squares += value * value;
  }
  lines.add(sum, squares, count);
}

} // namespace

std::optional<PixelRectangle> insideOfFrame(const MapExemplar& map) {
  LineStatistics rows, columns;
  for (int y = 0; y < map.height; ++y)
    addLine(rows, map.width, [&](int x) { return brightness(map, x, y); });
  const LineRange vertical = rows.insideFrame();
  const int height = vertical.end - vertical.begin;
  for (int x = 0; x < map.width; ++x)
    addLine(columns, height, [&](int y) { return brightness(map, x, vertical.begin + y); });
  const LineRange horizontal = columns.insideFrame();
  const int width = horizontal.end - horizontal.begin;
  if (width == map.width && height == map.height)
    return std::nullopt;
  return PixelRectangle{horizontal.begin, vertical.begin, width, height};
}

} // namespace lichen::exemplar
