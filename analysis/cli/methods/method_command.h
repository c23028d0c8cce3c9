// SPDX-License-Identifier: MIT
// The interface between the verbs and a method. Each method implements it in its own file;
// methods.cpp lists them.
#pragma once

#include "../command.h"
#include "../options.h"
#include "spectrum_option.h"

#include <lichen/bake_material.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen::cli {

/// Options of `lichen bake` that several methods share.
struct CommonOptions {
  std::optional<SpectrumChoice> spectrum; ///< for methods with takesSpectrum()
  std::optional<double> guide;            ///< for methods with takesGuide()
  MaterialNoise material; ///< its impacts for methods with takesImpacts(); methods set the rest
};

/// Returns the options of a bake that the command line gives, and adds notes on those without
/// effect. `maps` are the maps of the material; without any, the spectrum is left out. Errors:
/// usage for options that exclude each other; as readImage().
using BakeOptionsReader = std::function<Result<MethodOptions>(std::span<const MapExemplar> maps,
                                                              std::vector<std::string>& notes)>;

/// Replaces parameters of a material by what the command line gives.
using UseOptions = std::function<void(MaterialNoise& material)>;

using Json = nlohmann::ordered_json;

class MethodCommand {
public:
  virtual ~MethodCommand() = default;

  /// The heading above the method's options in the help.
  [[nodiscard]] virtual std::string heading() const = 0;
  /// Whether a bake can take a spectrum in place of the exemplar's.
  [[nodiscard]] virtual bool takesSpectrum() const { return false; }
  /// Whether the noise is a sum of impacts.
  [[nodiscard]] virtual bool takesImpacts() const { return false; }
  /// Whether a bake can follow what repeats in the exemplar.
  [[nodiscard]] virtual bool takesGuide() const { return false; }
  /// Declare the method's options for a verb, under its heading. `common` must outlive the result,
  /// and is complete after the parse.
  [[nodiscard]] virtual BakeOptionsReader addBakeOptions(CLI::App& verb,
                                                         CommonOptions& common) const = 0;
  /// The same for the verbs that use a noise; most methods have no parameters of a material.
  [[nodiscard]] virtual UseOptions addUseOptions(CLI::App&) const {
    return [](MaterialNoise&) {};
  }

  /// Members of `bake --json`, and of the report, on a noise of this method.
  [[nodiscard]] virtual Json figures(const BakedMaterial& baked) const = 0;

  /// How to bake a noise that supports a mapping, of a method not all of whose noises do:
  /// completes the message "bake it ...".
  [[nodiscard]] virtual std::string optionsFor(Mapping) const { return {}; }

  /// What `inspect` reports about a noise and about a map.
  virtual void describe(const Noise& noise, Json& json) const = 0;
  virtual void describe(const NoiseMap& map, Json& json) const = 0;
  /// Whether the noise has rows, such as rows of bricks, which only a period of whole exemplars
  /// continues.
  [[nodiscard]] virtual bool hasRows(const Noise&) const { return false; }
  /// The number of texture fetches per pixel for one map on one plane: an average for textons,
  /// otherwise the maximum.
  [[nodiscard]] virtual int fetches(const Noise& noise, const NoiseMap& map,
                                    const MaterialNoise& use) const = 0;
  /// Those that all maps of a noise share, which fetches() leaves out.
  [[nodiscard]] virtual int sharedFetches() const { return 0; }
};

[[nodiscard]] const MethodCommand& commandOf(Method method);

/// An option that the user gave although it belongs to another method than `method`.
struct ForeignOption {
  std::string name;
  Method method{};
};
[[nodiscard]] std::optional<ForeignOption> foreignOption(const CLI::App& verb, Method method);

} // namespace lichen::cli
