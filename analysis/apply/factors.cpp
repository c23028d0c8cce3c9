// SPDX-License-Identifier: MIT
// Materials and a noise -> the material factors that multiply the noise.
// Source: glTF 2.0 specification, sections 5.19 and 5.22.
#include "steps.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace lichen::apply {
namespace {

using nlohmann::json;

constexpr std::size_t kColors = 3; // components of a factor without alpha
/// A smaller factor leaves less than a tenth of the noise's variation.
constexpr float kLeastFactor = 0.1f;

struct Factor {
  const char* parent; ///< object within the material; "" for the material itself
  const char* key;
  MapTarget target;
  MapChannel channel;
  std::vector<double> preset; ///< the value if the material does not set the factor
};

/// Returns the factors that multiply a channel of the noise.
std::vector<Factor> factorsOf(const Noise& noise) {
  constexpr const char* kMetallicRoughness = "pbrMetallicRoughness";
  std::vector<Factor> factors{
      {kMetallicRoughness, "baseColorFactor", MapTarget::baseColor, MapChannel::red, {1, 1, 1, 1}},
      {kMetallicRoughness,
       "metallicFactor",
       MapTarget::occlusionRoughnessMetallic,
       MapChannel::metallic,
       {1}},
      {kMetallicRoughness,
       "roughnessFactor",
       MapTarget::occlusionRoughnessMetallic,
       MapChannel::roughness,
       {1}},
      {"", "emissiveFactor", MapTarget::emissive, MapChannel::red, {0, 0, 0}}};
  std::erase_if(factors, [&](const Factor& factor) {
    const std::optional<std::size_t> map = findMap(noise, factor.target);
    if (!map)
      return true;
    const std::vector<MapChannel>& channels = noise.maps[*map].channels;
    return std::find(channels.begin(), channels.end(), factor.channel) == channels.end();
  });
  return factors;
}

/// Returns the components of a material's factor; the preset if they are absent or not numbers.
std::vector<double> valueOf(const json& material, const Factor& factor) {
  const json::json_pointer place((*factor.parent != '\0' ? "/" + std::string(factor.parent) : "") +
                                 "/" + factor.key);
  if (!material.contains(place))
    return factor.preset;
  const json& stored = material[place];
  const json list = stored.is_array() ? stored : json::array({stored});
  if (list.size() != factor.preset.size() ||
      !std::all_of(list.begin(), list.end(), [](const json& each) { return each.is_number(); }))
    return factor.preset;
  return list.get<std::vector<double>>();
}

/// Returns the components without alpha, which the notes do not cover.
std::span<const double> colorsOf(const std::vector<double>& value) {
  return std::span(value).first(std::min(value.size(), kColors));
}

bool isOne(const std::vector<double>& value) {
  const auto colors = colorsOf(value);
  return std::all_of(colors.begin(), colors.end(), [](double each) { return each == 1.0; });
}

/// Returns "0.8" or "[0.5,0.25,0.125,1]". Prints floats, as the file stores them, not the doubles
/// they were converted to.
std::string textOf(const std::vector<double>& value) {
  const std::vector<float> written(value.begin(), value.end());
  return written.size() == 1 ? fmt::format("{}", written.front())
                             : fmt::format("[{}]", fmt::join(written, ","));
}

} // namespace

std::vector<std::string> notesOnFactors(const GltfScene& scene,
                                        std::span<const std::size_t> materials, const Noise& noise,
                                        bool areSetToOne, SettingWords words) {
  const std::vector<Factor> factors = factorsOf(noise);
  std::vector<std::string> changing, hiding, glowing;
  for (const std::size_t material : materials) {
    const json& core = scene.document()["materials"][material];
    const std::string title = scene.materialTitle(material);
    for (const Factor& factor : factors) {
      const std::vector<double> value = valueOf(core, factor);
      if (isOne(value))
        continue;
      if (areSetToOne) {
        if (factor.target == MapTarget::emissive && !core.contains("emissiveTexture"))
          glowing.push_back(title);
        continue;
      }
      const auto colors = colorsOf(value);
      const bool hides = *std::max_element(colors.begin(), colors.end()) < kLeastFactor;
      (hides ? hiding : changing)
          .push_back(fmt::format("{} {} of {}", factor.key, textOf(value), title));
    }
  }
  std::vector<std::string> notes;
  const std::string path = scene.path().string();
  const auto verb = [](const std::vector<std::string>& items, const char* one, const char* many) {
    return items.size() == 1 ? one : many;
  };
  if (!changing.empty())
    notes.push_back(fmt::format("{}: {} {} the noise; use {} to show it as baked", path,
                                shortList(changing), verb(changing, "multiplies", "multiply"),
                                words({"factors", "one"})));
  if (!hiding.empty())
    notes.push_back(fmt::format(
        "{}: {} {} below {}, which almost hides the noise; use {} to show it", path,
        shortList(hiding), verb(hiding, "is", "are"), kLeastFactor, words({"factors", "one"})));
  if (!glowing.empty())
    notes.push_back(fmt::format("{}: emissiveFactor of {} is 1 without an emissiveTexture; viewers "
                                "without the extension show it white",
                                path, shortList(glowing)));
  return notes;
}

void setFactorsToOne(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise) {
  for (const std::size_t material : materials)
    for (const Factor& factor : factorsOf(noise)) {
      std::vector<double> value = valueOf(scene.document()["materials"][material], factor);
      if (isOne(value))
        continue;
      std::fill_n(value.begin(), std::min(value.size(), kColors), 1.0);
      scene.setFactor(material, factor.parent, factor.key, value);
    }
}

} // namespace lichen::apply
