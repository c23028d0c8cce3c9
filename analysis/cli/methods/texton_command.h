// SPDX-License-Identifier: MIT
// Texton noise on the command line; `lichen mix` uses it too, since its steps are textons.
#pragma once

#include "method_command.h"

#include <lichen/texton.h>
#include <lichen/texton_mix.h>

namespace lichen::cli {

class TextonCommand final : public MethodCommand {
public:
  [[nodiscard]] std::string heading() const override { return "Texton"; }
  [[nodiscard]] std::unique_ptr<const BakeOptions>
  addBakeOptions(CLI::App& verb, const CommonOptions& common) const override;
  [[nodiscard]] std::unique_ptr<const UseOptions> addSynthOptions(CLI::App& verb) const override;
  [[nodiscard]] std::unique_ptr<const UseOptions> addApplyOptions(CLI::App& verb) const override;
  void describe(const Noise& noise, nlohmann::ordered_json& json) const override;
  [[nodiscard]] std::vector<std::string> linesOf(const Noise& noise,
                                                 const MaterialNoise& use) const override;
  void describe(const Bundle& bundle, const NoiseMap& map,
                nlohmann::ordered_json& json) const override;
  [[nodiscard]] std::vector<std::string> linesOf(const Bundle& bundle,
                                                 const NoiseMap& map) const override;
  [[nodiscard]] int fetches(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                            const MaterialNoise& use) const override;
  [[nodiscard]] bool fetchesVary() const override { return true; }
  [[nodiscard]] const Table& imageOf(const Bundle& bundle, const NoiseMap& map) const override;
};

/// Measured: 90 to 101 bytes per pixel for one map of 512 to 2048 pixels a side, 275 for four maps
/// of 1024 pixels a side.
inline constexpr BakeMemory kTextonMemory{60.0, 40.0};

/// Declares the texton options that `bake` and `mix` share; not --precision.
void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material);

/// Returns the risks of each map for a texton with this support, in texels. The noise has
/// `widthTexels` texels across the width of the maps; 0 means the width in pixels of the widest
/// map.
[[nodiscard]] Result<std::vector<std::vector<Risk>>>
assessTextonMaps(std::span<const MapExemplar> maps, int support, const SharedOptions& shared,
                 int widthTexels = 0);

/// A note if the exemplar is smaller than the requested support.
[[nodiscard]] std::optional<std::string> supportNote(int supportWanted, const TextonShape& shape);

/// Says whether the textons of a mix are close to their Gaussian textures and to each other.
[[nodiscard]] std::string qualityNote(const TextonMixQuality& quality, const Noise& noise);

} // namespace lichen::cli
