// SPDX-License-Identifier: MIT
// Values (width * height * channels) -> values of another width and height, first along x, then
// along y. Source of the filter: [MN88] eq. 8 with B = C = 1/3.
#include "resample.h"

#include "color_space.h"
#include "value_encoding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::exemplar {
namespace {

/// Radius of the cubic in pixels.
constexpr double kReach = 2.0;

/// [MN88] eq. 8 with B = C = 1/3: their compromise between blur, ringing and moire.
double mitchell(double x) {
  const double a = std::abs(x);
  if (a >= kReach)
    return 0.0;
  if (a >= 1.0)
    return ((-7.0 / 18.0 * a + 2.0) * a - 10.0 / 3.0) * a + 16.0 / 9.0;
  return (7.0 / 6.0 * a - 2.0) * a * a + 8.0 / 9.0;
}

/// The weights of one pixel of the result for the source pixels starting at `first`, which may lie
/// outside.
struct Window {
  int first = 0;
  std::vector<double> weights; ///< their sum is 1
};

std::vector<Window> windows(int from, int to) {
  const double step = double(from) / double(to);
  const double stretch = std::max(1.0, step);
  std::vector<Window> result(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    const double center = (i + 0.5) * step - 0.5;
    Window& window = result[std::size_t(i)];
    window.first = int(std::ceil(center - kReach * stretch));
    double sum = 0.0;
    for (int k = window.first; k <= center + kReach * stretch; ++k) {
      window.weights.push_back(mitchell((k - center) / stretch));
      sum += window.weights.back();
    }
    for (double& weight : window.weights)
      weight /= sum;
  }
  return result;
}

std::size_t inside(int k, int size, bool wraps) {
  return std::size_t(wraps ? ((k % size) + size) % size : std::clamp(k, 0, size - 1));
}

/// Replaces an axis of `from` values by one of `to` values: value (outer, k, inner) is
/// values[(outer * from + k) * inner + i].
std::vector<float> resampledAxis(const std::vector<float>& values, std::size_t outer, int from,
                                 int to, std::size_t inner, bool wraps) {
  const std::vector<Window> all = windows(from, to);
  std::vector<float> result(outer * std::size_t(to) * inner);
  tbb::parallel_for(std::size_t(0), outer * std::size_t(to), [&](std::size_t line) {
    const std::size_t o = line / std::size_t(to);
    const Window& window = all[line % std::size_t(to)];
    for (std::size_t i = 0; i < inner; ++i) {
      double sum = 0.0;
      for (std::size_t w = 0; w < window.weights.size(); ++w) {
        const std::size_t k = inside(window.first + int(w), from, wraps);
        sum += window.weights[w] * double(values[(o * std::size_t(from) + k) * inner + i]);
      }
      result[line * inner + i] = float(sum);
    }
  });
  return result;
}

} // namespace

MapExemplar cropped(const MapExemplar& map, const PixelRectangle& part) {
  MapExemplar result = map;
  result.width = part.width;
  result.height = part.height;
  result.values.clear();
  const std::size_t channels = map.channels.size();
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto row =
        map.values.begin() +
        std::ptrdiff_t((std::size_t(y) * std::size_t(map.width) + std::size_t(part.x)) * channels);
    result.values.insert(result.values.end(), row,
                         row + std::ptrdiff_t(std::size_t(part.width) * channels));
  }
  return result;
}

MapExemplar resampled(const MapExemplar& map, int width, int height, bool wraps) {
  if (width == map.width && height == map.height)
    return map;
  MapExemplar result = map;
  const std::size_t channels = map.channels.size();
  for (float& value : result.values)
    value = decoded(value, map.encoding);
  std::vector<ValueRange> ranges;
  for (std::size_t c = 0; c < channels; ++c)
    ranges.push_back(rangeOf(result.values, channels, c));
  result.values =
      resampledAxis(result.values, std::size_t(map.height), map.width, width, channels, wraps);
  result.values =
      resampledAxis(result.values, 1, map.height, height, std::size_t(width) * channels, wraps);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const auto [least, most] = ranges[i % channels];
    result.values[i] = encoded(std::clamp(result.values[i], least, most), map.encoding);
  }
  result.width = width;
  result.height = height;
  return result;
}

MapExemplar joined(std::span<const MapExemplar> parts, bool wraps) {
  const auto pixels = [](const MapExemplar& map) {
    return std::size_t(map.width) * std::size_t(map.height);
  };
  const MapExemplar& largest = *std::max_element(
      parts.begin(), parts.end(),
      [&](const MapExemplar& a, const MapExemplar& b) { return pixels(a) < pixels(b); });
  struct Source {
    MapChannel channel;
    std::size_t part;
    std::size_t place; ///< index among the part's channels
  };
  std::vector<Source> sources;
  std::vector<MapExemplar> sized;
  MapExemplar result = largest;
  result.channels.clear();
  for (std::size_t p = 0; p < parts.size(); ++p) {
    sized.push_back(resampled(parts[p], largest.width, largest.height, wraps));
    result.quantum = std::min(result.quantum, parts[p].quantum);
    for (std::size_t c = 0; c < parts[p].channels.size(); ++c)
      sources.push_back({parts[p].channels[c], p, c});
  }
  std::sort(sources.begin(), sources.end(),
            [](const Source& a, const Source& b) { return a.channel < b.channel; });
  for (const Source& source : sources)
    result.channels.push_back(source.channel);
  result.values.clear();
  for (std::size_t i = 0; i < pixels(largest); ++i)
    for (const Source& source : sources)
      result.values.push_back(
          sized[source.part].values[i * sized[source.part].channels.size() + source.place]);
  return result;
}

} // namespace lichen::exemplar
