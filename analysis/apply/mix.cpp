// SPDX-License-Identifier: MIT
// Options -> the mix weight of a material.
#include "steps.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <fmt/format.h>

#include <charconv>

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

/// chosenMix() for a direction, which needs texture coordinates. For the mapping uv the caller has
/// chosen the materials that have them. `whose` names the direction in messages.
Result<ChosenMix> directedMix(const MixWeight& mix, const MaterialNoise& use,
                              const ChosenMaterials& chosen, const std::string& whose,
                              const GltfScene& scene, SettingWords words,
                              std::vector<std::string>& notes) {
  if (use.mapping == Mapping::uv)
    return ChosenMix{mix, chosen.indices};
  Result<std::vector<std::size_t>> fit =
      materialsWith(fmt::format("TEXCOORD_{}", use.texCoord), scene, chosen, whose,
                    withoutTexCoords(words), notes);
  if (!fit)
    return fit.error();
  return ChosenMix{mix, std::move(fit).value()};
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
