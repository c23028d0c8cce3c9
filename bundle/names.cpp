// SPDX-License-Identifier: MIT
// The names that the extension's JSON uses for targets, channels, encodings, mappings, spaces,
// point processes and mix sources.
#include <lichen/bundle.h>

#include <algorithm>

namespace lichen {
namespace {

// Each list is in the order of its enumeration.
constexpr std::array<std::string_view, 6> kTargetNames = {
    "baseColor", "normal", "occlusionRoughnessMetallic", "emissive", "height", "opacity"};
constexpr std::array<std::string_view, 10> kChannelNames = {
    "red",       "green",     "blue",     "slopeX", "slopeY",
    "occlusion", "roughness", "metallic", "height", "opacity"};
constexpr std::array<std::string_view, 6> kEncodingNames = {"root", "linear", "slope",
                                                            "log2", "srgb",   "index"};
constexpr std::array<std::string_view, 4> kMappingNames = {"uv", "triplanar", "surface", "solid"};
constexpr std::array<std::string_view, 2> kSpaceNames = {"world", "object"};
constexpr std::array<std::string_view, 2> kPointProcessNames = {"stratified", "poisson"};
constexpr std::array<std::string_view, 4> kMixSourceNames = {"constant", "direction", "texture",
                                                             "vertexColor"};

template <class Value, std::size_t kCount>
std::optional<Value> find(const std::array<std::string_view, kCount>& names,
                          std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    return std::nullopt;
  return Value(found - names.begin());
}

} // namespace

std::string_view nameOf(MapTarget value) { return kTargetNames[std::size_t(value)]; }
std::string_view nameOf(MapChannel value) { return kChannelNames[std::size_t(value)]; }
std::string_view nameOf(ValueEncoding value) { return kEncodingNames[std::size_t(value)]; }
std::string_view nameOf(Mapping value) { return kMappingNames[std::size_t(value)]; }
std::string_view nameOf(NoiseSpace value) { return kSpaceNames[std::size_t(value)]; }
std::string_view nameOf(PointProcess value) { return kPointProcessNames[std::size_t(value)]; }
std::string_view nameOf(MixSource value) { return kMixSourceNames[std::size_t(value)]; }

std::optional<MapTarget> mapTargetFrom(std::string_view name) {
  return find<MapTarget>(kTargetNames, name);
}
std::optional<MapChannel> mapChannelFrom(std::string_view name) {
  return find<MapChannel>(kChannelNames, name);
}
std::optional<ValueEncoding> valueEncodingFrom(std::string_view name) {
  const std::optional<ValueEncoding> found = find<ValueEncoding>(kEncodingNames, name);
  return found >= ValueEncoding::srgb ? std::nullopt : found; // not in files
}
std::optional<Mapping> mappingFrom(std::string_view name) {
  return find<Mapping>(kMappingNames, name);
}
std::optional<NoiseSpace> noiseSpaceFrom(std::string_view name) {
  return find<NoiseSpace>(kSpaceNames, name);
}
std::optional<PointProcess> pointProcessFrom(std::string_view name) {
  return find<PointProcess>(kPointProcessNames, name);
}
std::optional<MixSource> mixSourceFrom(std::string_view name) {
  return find<MixSource>(kMixSourceNames, name);
}

} // namespace lichen
