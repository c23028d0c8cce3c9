// SPDX-License-Identifier: MIT
// Finds a noise's map by target and a map's tables, classifies mappings, and explains why a noise
// is ignored.
#include "findings.h"

#include <lichen/bundle.h>

#include <algorithm>

namespace lichen {

std::optional<std::size_t> findMap(const Noise& noise, MapTarget target) {
  const auto found = std::find_if(noise.maps.begin(), noise.maps.end(),
                                  [&](const NoiseMap& map) { return map.target == target; });
  if (found == noise.maps.end())
    return std::nullopt;
  return std::size_t(found - noise.maps.begin());
}

std::size_t imageTableOf(const NoiseMap& map) {
  return std::visit([](const auto& data) { return data.imageTable(); }, map.data);
}

std::optional<std::size_t> decodingTableOf(const NoiseMap& map) {
  return std::visit([](const auto& data) { return data.decodingTable(); }, map.data);
}

bool isInSpace(Mapping mapping) { return mapping != Mapping::uv; }

std::string IgnoredNoise::reason() const {
  const std::optional<Method> known = methodFrom(method);
  if (!known)
    return "method " + quoted(method) + "; this version does not know it";
  return "revision " + std::to_string(revision) + " of " + method + "; this version knows " +
         std::to_string(revisionOf(*known));
}

} // namespace lichen
