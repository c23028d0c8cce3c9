// SPDX-License-Identifier: MIT
#include "joined_channels.h"

#include "resample.h"

#include <algorithm>

namespace lichen::exemplar {

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
