// SPDX-License-Identifier: MIT
// Names of noises -> indices; see noise_choice.h.
#include "noise_choice.h"

#include <lichen/bake_material.h>
#include <lichen/bundle_files.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace lichen::cli {
namespace {

/// Returns the ignored noise that the user means, or null: the one with the name `wanted`, unless a
/// known noise has that name too; without a name, the first noise of the file if it is ignored.
const IgnoredNoise* ignoredNoiseMeant(const Bundle& bundle, const std::string& wanted) {
  const auto isWanted = [&](const auto& noise) { return noise.name == wanted; };
  if (!wanted.empty() && std::any_of(bundle.noises.begin(), bundle.noises.end(), isWanted))
    return nullptr;
  const auto meant = std::find_if(bundle.ignoredNoises.begin(), bundle.ignoredNoises.end(),
                                  [&](const IgnoredNoise& noise) {
                                    return wanted.empty() ? noise.place == 0 : isWanted(noise);
                                  });
  return meant == bundle.ignoredNoises.end() ? nullptr : &*meant;
}

} // namespace

Result<std::size_t> indexOf(const std::string& wanted, const std::vector<std::string>& names,
                            const std::string& option, const std::string& kind,
                            const std::string& owner) {
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (wanted.empty() || found != names.end())
    return wanted.empty() ? 0 : std::size_t(found - names.begin());
  return Error{ErrorKind::usage, fmt::format("{}{}: {} has no such {}; expected {}", option, wanted,
                                             owner, kind, alternatives(names))};
}

Accepted<std::string> nameText() {
  return {"NAME", "UTF-8 text", [](const std::string& text) {
            return asUtf8(text) == text ? std::optional(text) : std::nullopt;
          }};
}

bool namesBundle(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& letter : extension)
    letter = char(std::tolower(static_cast<unsigned char>(letter)));
  return extension == ".glb" || extension == ".gltf" || extension == ".lichen";
}

Error noNoiseIn(const std::string& file) {
  return {ErrorKind::badInput, file + ": has no noise; expected a bundle of 'lichen bake', or a "
                                      "scene of 'lichen apply'"};
}

Result<std::size_t> findNoise(const Bundle& bundle, const std::string& file,
                              const std::string& wanted, const std::string& option) {
  std::vector<std::string> noises;
  for (const Noise& noise : bundle.noises)
    noises.push_back(noise.name);
  if (const IgnoredNoise* ignored = ignoredNoiseMeant(bundle, wanted))
    return Error{ErrorKind::badInput,
                 fmt::format("{}: noise '{}' has {}; use the version of lichen that wrote it{}{}",
                             file, ignored->name, ignored->reason(),
                             noises.empty() ? "" : ", or choose " + option, alternatives(noises))};
  if (bundle.noises.empty() && bundle.ignoredNoises.empty())
    return noNoiseIn(file);
  if (bundle.noises.empty())
    return Error{
        ErrorKind::badInput,
        file + ": has no noise that this version knows; use the version of lichen that wrote it"};
  return indexOf(wanted, noises, option, "noise", file);
}

Result<ChosenNoise> chosenNoise(const std::string& text) {
  std::error_code ignored;
  const std::size_t colon = text.rfind(':');
  const bool isNamed = colon != std::string::npos && !std::filesystem::exists(text, ignored) &&
                       std::filesystem::exists(text.substr(0, colon), ignored);
  const std::string file = isNamed ? text.substr(0, colon) : text;
  const std::string name = isNamed ? text.substr(colon + 1) : "";
  if (isNamed && name.empty())
    return Error{ErrorKind::usage,
                 fmt::format("{}: the name after the colon is empty; expected {} or {}:NAME", text,
                             file, file)};
  Result<Bundle> bundle = readBundle(file);
  if (!bundle)
    return bundle.error();
  const Result<std::size_t> index = findNoise(bundle.value(), file, name, file + ":");
  if (!index)
    return index.error();
  return ChosenNoise{file, std::move(bundle).value(), index.value()};
}

MaterialNoise materialOf(const Bundle& bundle, std::size_t noise) {
  for (const std::optional<MaterialNoise>& use : bundle.materials)
    if (use && use->noise == noise)
      return *use;
  MaterialNoise unused;
  unused.noise = noise;
  return unused;
}

} // namespace lichen::cli
