// SPDX-License-Identifier: MIT
// Options -> the mix weight of a material.
#include "steps.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lichen::apply {
namespace {

/// Sources of the weight that need no texture coordinates.
std::string withoutTexCoords(SettingWords words) {
  return words({"mix", ""}) + " or " + words({"mix-vertex-color", ""});
}

Error usage(std::string message) { return {ErrorKind::usage, std::move(message)}; }

/// Returns the options that the user gave and that choose a source of the weight.
std::vector<std::string> sourcesOf(const MixOptions& options, SettingWords words) {
  std::vector<std::string> sources;
  const auto add = [&](bool isGiven, const char* option) {
    if (isGiven)
      sources.push_back(words({option, ""}));
  };
  add(options.weight.has_value(), "mix");
  add(options.direction.has_value(), "mix-direction");
  add(!options.texture.empty(), "mix-texture");
  add(options.colorSet.has_value(), "mix-vertex-color");
  return sources;
}

/// Checks that the options fit each other and the noise.
Result<void> check(const MixOptions& options, const Noise& noise, SettingWords words) {
  const std::vector<std::string> sources = sourcesOf(options, words);
  const std::string channel = words({"mix-channel", ""});
  if (!isMix(noise))
    return notMixed(sources.empty() ? channel : sources.front(), noise);
  if (sources.size() > 1)
    return usage(fmt::format("{}: {} sources of the weight; expected one of them",
                             fmt::join(sources, ", "), sources.size()));
  if (options.channel && options.texture.empty() && !options.colorSet)
    return usage(fmt::format("{}: no texture and no vertex colours; add {} or {}", channel,
                             words({"mix-texture", ""}), words({"mix-vertex-color", ""})));
  return {};
}

/// Returns the materials whose meshes have the texture coordinates of the direction. For the
/// mapping uv the caller has chosen them already. `whose` names the direction in messages.
Result<std::vector<std::size_t>>
withDirection(const GltfScene& scene, const ChosenMaterials& chosen, const MaterialNoise& use,
              const std::string& whose, SettingWords words, std::vector<std::string>& notes) {
  if (use.mapping == Mapping::uv)
    return chosen.indices;
  return materialsWith(fmt::format("TEXCOORD_{}", use.texCoord), scene, chosen, whose,
                       withoutTexCoords(words), notes);
}

/// Returns the scene's texture with the index `wanted`, or a new texture from the image file
/// `wanted`, which must have the channel.
Result<std::size_t> textureOf(const std::string& wanted, int channel, GltfScene& scene,
                              SettingWords words) {
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (code == std::errc{} && end == wanted.data() + wanted.size()) {
    if (index < scene.textureCount())
      return index;
    return usage(fmt::format("{}: {} has {} textures; expected the index of one, or a file",
                             words({"mix-texture", wanted}), scene.path().string(),
                             scene.textureCount()));
  }
  const Result<std::vector<std::byte>> file = readFile(wanted);
  if (!file)
    return file.error();
  constexpr std::byte kFirstOfPng{0x89}, kFirstOfJpeg{0xff};
  const std::byte first = file.value().empty() ? std::byte{} : file.value().front();
  if (first != kFirstOfPng && first != kFirstOfJpeg)
    return Error{
        ErrorKind::badInput,
        fmt::format("{}: not a PNG or JPEG; expected one of them, which glTF needs for a mask, "
                    "or the index of a texture of the scene",
                    wanted)};
  const Result<ImageFile> image = decodeImage(file.value(), wanted);
  if (!image)
    return image.error();
  const auto& mask = std::get<SrgbImage>(image.value().pixels);
  constexpr int kAlpha = 3;
  if (channel == kAlpha && mask.channels % 2 != 0)
    return Error{ErrorKind::badInput,
                 fmt::format("{}: has no alpha, which {} asks for; expected red, green or blue",
                             wanted, words({"mix-channel", ""}))};
  return withinMemory([&] { return wanted + ": not enough memory to add it to the scene"; },
                      [&]() -> Result<std::size_t> {
                        return scene.addTexture(file.value(),
                                                first == kFirstOfPng ? "image/png" : "image/jpeg");
                      });
}

/// Returns whether a texture repeats along u and along v. One that textureOf() added does not.
std::array<bool, 2> repeats(const GltfScene& scene, std::size_t texture) {
  constexpr std::uint64_t kRepeat = 10497, kClampToEdge = 33071; // [glTF 2.0, section 5.26]
  const nlohmann::json& document = scene.document();
  const auto number = [&](const std::string& place) -> std::optional<std::uint64_t> {
    const nlohmann::json::json_pointer pointer(place);
    if (!document.contains(pointer) || !document[pointer].is_number_unsigned())
      return std::nullopt;
    return document[pointer].get<std::uint64_t>();
  };
  const std::string place = fmt::format("/textures/{}", texture);
  if (!document.contains(nlohmann::json::json_pointer(place)))
    return {false, false};
  const std::optional<std::uint64_t> sampler = number(place + "/sampler");
  const auto isRepeated = [&](const char* axis) {
    const auto wrap =
        sampler ? number(fmt::format("/samplers/{}/{}", *sampler, axis)) : std::nullopt;
    return wrap.value_or(kRepeat) != kClampToEdge;
  };
  return {isRepeated("wrapS"), isRepeated("wrapT")};
}

/// Adds a note on the first primitive of the materials for which `describe` returns a text, with
/// the number of the others. `describe` gets the range of the primitive's attribute.
template <class Describe>
Result<void> noteRanges(GltfScene& scene, std::span<const std::size_t> materials,
                        const std::string& attribute, const Describe& describe,
                        std::vector<std::string>& notes) {
  std::string first;
  std::size_t count = 0;
  for (const std::size_t material : materials)
    for (const PrimitivePlace place : scene.primitivesOf(material)) {
      const Result<std::optional<GltfScene::Range2>> read = scene.rangeOf(place, attribute);
      if (!read)
        return read.error();
      if (!read.value())
        continue; // compressed vertices
      const std::string text = describe(*read.value());
      if (!text.empty() && count++ == 0)
        first = scene.primitiveTitle(place) + ": " + text;
    }
  if (count > 0)
    notes.push_back(
        fmt::format("{}: {}{}", scene.path().string(), first,
                    count > 1 ? "; the same for " + counted(count - 1, "more primitive") : ""));
  return {};
}

/// Returns "TEXCOORD_0 from (0, 0) to (2, 1)".
std::string textOf(const std::string& attribute, const GltfScene::Range2& range) {
  return fmt::format("{} from ({:.4g}, {:.4g}) to ({:.4g}, {:.4g})", attribute, range.least[0],
                     range.least[1], range.most[0], range.most[1]);
}

/// Adds a note if texture coordinates lie outside the mask.
Result<void> noteMaskRange(GltfScene& scene, std::span<const std::size_t> materials,
                           std::size_t texture, std::vector<std::string>& notes) {
  constexpr float kSlack = 0.001f; // rounding errors of exporters, far below a texel
  const std::array<bool, 2> isRepeated = repeats(scene, texture);
  const auto describe = [&](const GltfScene::Range2& range) -> std::string {
    const auto leaves = [&](std::size_t axis) {
      return range.least[axis] < -kSlack || range.most[axis] > 1.0f + kSlack;
    };
    if (!leaves(0) && !leaves(1))
      return "";
    const bool isClamped = (leaves(0) && !isRepeated[0]) || (leaves(1) && !isRepeated[1]);
    return fmt::format("{} exceeds 0 to 1, the range of the mask; outside, {}",
                       textOf("TEXCOORD_0", range),
                       isClamped ? "its border continues" : "it repeats");
  };
  return noteRanges(scene, materials, "TEXCOORD_0", describe, notes);
}

/// Adds a note if a direction is so short, or so far off, that its change of weight hardly shows.
/// `whose` names the direction.
Result<void> noteDirectionRange(GltfScene& scene, std::span<const std::size_t> materials,
                                const MaterialNoise& use, const MixWeight& mix,
                                const std::string& whose, std::vector<std::string>& notes) {
  // A share of the range of texture coordinates: a shorter change looks like a border (judged by
  // eye).
  constexpr double kLeastShare = 0.1;
  const std::string attribute = fmt::format("TEXCOORD_{}", use.texCoord);
  const auto describe = [&](const GltfScene::Range2& range) -> std::string {
    // Range of the unclamped weight over the corners of the rectangle.
    double least = 0.0, most = 0.0, squared = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      const double along = mix.end[k] - mix.start[k];
      const double a = along * (double(range.least[k]) - mix.start[k]);
      const double b = along * (double(range.most[k]) - mix.start[k]);
      least += std::min(a, b);
      most += std::max(a, b);
      squared += along * along;
    }
    if (most <= 0.0 || least >= squared)
      return fmt::format("{} lies outside {}, so the weight is {} everywhere",
                         textOf(attribute, range), whose, most <= 0.0 ? 0 : 1);
    const double share = squared / (most - least);
    if (share >= kLeastShare)
      return "";
    return fmt::format("{} spans {:.2g} % of {}; elsewhere the weight is 0 or 1", whose,
                       100.0 * share, textOf(attribute, range));
  };
  return noteRanges(scene, materials, attribute, describe, notes);
}

/// chosenMix() for a direction.
Result<ChosenMix> directedMix(MixWeight mix, const MaterialNoise& use,
                              const ChosenMaterials& chosen, const std::string& whose,
                              GltfScene& scene, SettingWords words,
                              std::vector<std::string>& notes) {
  Result<std::vector<std::size_t>> fit = withDirection(scene, chosen, use, whose, words, notes);
  if (!fit)
    return fit.error();
  if (Result<void> noted = noteDirectionRange(scene, fit.value(), use, mix, whose, notes); !noted)
    return noted.error();
  return ChosenMix{mix, std::move(fit).value()};
}

/// chosenMix() when the user gave options.
Result<ChosenMix> givenMix(const MixOptions& options, const MaterialNoise& use,
                           const ChosenMaterials& chosen, GltfScene& scene, SettingWords words,
                           std::vector<std::string>& notes) {
  MixWeight mix;
  mix.channel = options.channel.value_or(0);
  if (options.weight) {
    mix.weight = *options.weight;
    return ChosenMix{mix, chosen.indices};
  }
  if (options.direction) {
    const auto [startU, startV, endU, endV] = *options.direction;
    mix.source = MixSource::direction;
    mix.start = {startU, startV};
    mix.end = {endU, endV};
    return directedMix(mix, use, chosen, words({"mix-direction", ""}), scene, words, notes);
  }
  if (options.colorSet) {
    mix.source = MixSource::vertexColor;
    mix.colorSet = *options.colorSet;
    Result<std::vector<std::size_t>> fit = materialsWith(
        fmt::format("COLOR_{}", mix.colorSet), scene, chosen, words({"mix-vertex-color", ""}),
        fmt::format("{}, {} or {}", words({"mix", ""}), words({"mix-direction", ""}),
                    words({"mix-texture", ""})),
        notes);
    if (!fit)
      return fit.error();
    return ChosenMix{mix, std::move(fit).value()};
  }
  mix.source = MixSource::texture;
  Result<std::vector<std::size_t>> fit = materialsWith(
      "TEXCOORD_0", scene, chosen, words({"mix-texture", ""}), withoutTexCoords(words), notes);
  if (!fit)
    return fit.error();
  const Result<std::size_t> texture = textureOf(options.texture, mix.channel, scene, words);
  if (!texture)
    return texture.error();
  mix.texture = texture.value();
  if (Result<void> noted = noteMaskRange(scene, fit.value(), mix.texture, notes); !noted)
    return noted.error();
  return ChosenMix{mix, std::move(fit).value()};
}

} // namespace

Result<ChosenMix> chosenMix(const MixOptions& options, const Noise& noise, const MaterialNoise& use,
                            const ChosenMaterials& chosen, GltfScene& scene, SettingWords words,
                            std::vector<std::string>& notes) {
  if (options.isGiven()) {
    if (Result<void> checked = check(options, noise, words); !checked)
      return checked.error();
    return givenMix(options, use, chosen, scene, words, notes);
  }
  if (use.mix.source == MixSource::texture)
    return ChosenMix{MixWeight{}, chosen.indices}; // its texture belongs to another file
  if (use.mix.source == MixSource::direction && isMix(noise))
    return directedMix(use.mix, use, chosen, "the bundle's mix direction", scene, words, notes);
  return ChosenMix{use.mix, chosen.indices};
}

} // namespace lichen::apply

namespace lichen {

Error notMixed(const std::string& option, const Noise& noise) {
  return {
      ErrorKind::usage,
      fmt::format("{}: noise '{}' is not a mix; expected one made by 'lichen mix', which blends "
                  "photographs",
                  option, noise.name)};
}

} // namespace lichen
