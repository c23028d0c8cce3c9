// SPDX-License-Identifier: MIT
// Reads one map of a noise: the JSON members that all methods share, checked against one another.
#include "extension_reader.h"
#include "methods/method_reader.h"

#include <algorithm>

namespace lichen {
namespace {

using nlohmann::json;

/// The channels that a target may have, in order.
std::vector<MapChannel> channelsOf(MapTarget target) {
  switch (target) {
  case MapTarget::baseColor:
  case MapTarget::emissive:
    return {MapChannel::red, MapChannel::green, MapChannel::blue};
  case MapTarget::normal:
    return {MapChannel::slopeX, MapChannel::slopeY};
  case MapTarget::occlusionRoughnessMetallic:
    return {MapChannel::occlusion, MapChannel::roughness, MapChannel::metallic};
  case MapTarget::height:
    return {MapChannel::height};
  default:
    return {MapChannel::opacity};
  }
}

bool encodingFits(MapTarget target, ValueEncoding encoding) {
  switch (target) {
  case MapTarget::baseColor:
  case MapTarget::emissive:
    return encoding == ValueEncoding::root || encoding == ValueEncoding::log2;
  case MapTarget::normal:
    return encoding == ValueEncoding::slope;
  case MapTarget::height:
    return encoding == ValueEncoding::linear || encoding == ValueEncoding::log2;
  default:
    return encoding == ValueEncoding::linear;
  }
}

/// occlusionRoughnessMetallic may have any subset of its channels, in order; other targets must
/// have all.
bool channelsFit(MapTarget target, const std::vector<MapChannel>& channels) {
  const std::vector<MapChannel> all = channelsOf(target);
  if (target != MapTarget::occlusionRoughnessMetallic)
    return channels == all;
  const auto strictlyAscending = [](MapChannel a, MapChannel b) { return a >= b; };
  return std::all_of(
             channels.begin(), channels.end(),
             [&](MapChannel c) { return std::find(all.begin(), all.end(), c) != all.end(); }) &&
         std::adjacent_find(channels.begin(), channels.end(), strictlyAscending) == channels.end();
}

void readChannels(ObjectReader& reader, NoiseMap& map, bool targetKnown) {
  constexpr std::size_t kMostChannels = 3;
  const json* list = reader.array("channels", kMostChannels);
  if (list == nullptr)
    return;
  for (const json& name : *list) {
    const auto channel =
        name.is_string() ? mapChannelFrom(name.get_ref<const std::string&>()) : std::nullopt;
    if (!channel)
      return reader.error("map-channels", "channels",
                          "has an element that is not the name of a channel");
    map.channels.push_back(*channel);
  }
  if (!targetKnown || channelsFit(map.target, map.channels))
    return;
  std::string expected;
  for (const MapChannel channel : channelsOf(map.target))
    expected += (expected.empty() ? "" : ", ") + std::string(nameOf(channel));
  reader.error(
      "map-channels", "channels",
      "not the channels of " + std::string(nameOf(map.target)) + "; expected " + expected +
          (map.target == MapTarget::occlusionRoughnessMetallic ? " or some, in order" : ""));
}

} // namespace

std::size_t usedChannels(TexelFormat format) {
  return std::min<std::size_t>(std::size_t(channelCount(format)), 3);
}

std::string shapeOf(const Table& table) {
  std::string shape = std::to_string(table.width) + " x " + std::to_string(table.height);
  if (table.depth > 0)
    shape += " x " + std::to_string(table.depth);
  return shape;
}

const Table* readTableIndex(ObjectReader& reader, const char* key, const char* code,
                            const Tables& tables, std::size_t& index) {
  const auto value = reader.integer(key, tables.empty() ? 0 : tables.size() - 1, code);
  if (!value)
    return nullptr;
  if (tables.empty()) {
    reader.error(code, key, "there are no tables");
    return nullptr;
  }
  index = std::size_t(*value);
  return tables[index] ? &*tables[index] : nullptr;
}

NoiseMap readMap(ObjectReader& reader, const Noise& noise, const Tables& tables,
                 FindingList& findings) {
  NoiseMap map;
  bool targetKnown = false;
  if (const auto name = reader.text("target")) {
    const auto target = mapTargetFrom(*name);
    targetKnown = target.has_value();
    map.target = target.value_or(map.target);
    if (!target)
      reader.error("map-target", "target",
                   quoted(*name) + "; expected baseColor, normal, occlusionRoughnessMetallic, "
                                   "emissive, height or opacity");
  }
  if (const auto name = reader.text("encoding")) {
    const auto encoding = valueEncodingFrom(*name);
    map.encoding = encoding.value_or(map.encoding);
    if (!encoding || (targetKnown && !encodingFits(map.target, *encoding)))
      reader.error("map-encoding", "encoding",
                   quoted(*name) + " is not an encoding of " + std::string(nameOf(map.target)));
  }
  readChannels(reader, map, targetKnown);
  MapMoments moments = readMoments(reader, map.encoding, map.channels.size());
  map.mean = std::move(moments.mean);
  map.covariance = std::move(moments.covariance);
  map.data = readerOf(noise.method()).readMap(reader, noise, map, tables, findings);
  reader.warnOfUnknown();
  return map;
}

} // namespace lichen
