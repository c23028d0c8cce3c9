// SPDX-License-Identifier: MIT
// The interface between the verbs and a method. Each method implements it in its own file;
// methods.cpp lists them.
#pragma once

#include "../bake_risks.h"
#include "../command.h"
#include "../memory_need.h"
#include "../options.h"
#include "spectrum_option.h"

#include <lichen/exemplar.h>
#include <lichen/noise_evaluator.h>
#include <lichen/progress.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lichen::cli {

/// The input of a bake.
struct BakeInput {
  const std::string& name;
  std::span<const MapExemplar> maps;
  Periodic borders{}; ///< same meaning as MaterialSet::periodic
  int bits = 8;       ///< per channel of the tables
  Progress progress;
};

/// A baked noise, and what the method reports about it.
struct MethodBake {
  Noise noise; ///< table indices start at 0
  std::vector<Table> tables;
  MaterialNoise material; ///< including the method's parameters
  bool bordersWereBlended = false;
  std::string_view borderTreatment = "blends"; ///< what the bake does with borders that do not fit
  std::vector<std::string> notes;
  nlohmann::ordered_json json = nlohmann::ordered_json::object(); ///< members of `bake --json`
  std::vector<std::pair<std::string, std::string>> facts;         ///< rows of the HTML report
};

/// Options of `lichen bake` that several methods share.
struct CommonOptions {
  std::optional<SpectrumChoice> spectrum; ///< for methods with takesSpectrum()
  std::optional<double> guide;            ///< for methods with takesGuide()
};

/// A method's options for `lichen bake`.
class BakeOptions {
public:
  virtual ~BakeOptions() = default;

  [[nodiscard]] virtual BakeMemory memory() const = 0;
  [[nodiscard]] virtual Result<MethodBake> bake(const BakeInput& input) const = 0;
  /// Returns members of `bake --json` that need the finished bundle.
  [[nodiscard]] virtual Result<nlohmann::ordered_json>
  measure(const Bundle&, std::span<const MapExemplar>, const MethodBake&) const {
    return nlohmann::ordered_json::object();
  }
};

/// A method's options for the verbs that use a noise. They override the parameters of the material.
class UseOptions {
public:
  virtual ~UseOptions() = default;
  virtual void replace(MaterialNoise& material, EvaluationOptions& evaluation) const = 0;
};

class MethodCommand {
public:
  virtual ~MethodCommand() = default;

  /// The heading above the method's options in the help.
  [[nodiscard]] virtual std::string heading() const = 0;
  /// Whether a bake can take a spectrum in place of the exemplar's.
  [[nodiscard]] virtual bool takesSpectrum() const { return false; }
  /// Whether a bake can follow what repeats in the exemplar.
  [[nodiscard]] virtual bool takesGuide() const { return false; }
  /// Declare the method's options for a verb, under its heading. The result and `common` must
  /// outlive the parse.
  [[nodiscard]] virtual std::unique_ptr<const BakeOptions>
  addBakeOptions(CLI::App& verb, const CommonOptions& common) const = 0;
  [[nodiscard]] virtual std::unique_ptr<const UseOptions> addSynthOptions(CLI::App& verb) const = 0;
  [[nodiscard]] virtual std::unique_ptr<const UseOptions> addApplyOptions(CLI::App& verb) const = 0;

  /// How to bake a noise that supports a mapping, of a method not all of whose noises do:
  /// completes the message "bake it ...".
  [[nodiscard]] virtual std::string optionsFor(Mapping) const { return {}; }

  /// What `inspect` reports about a noise: JSON members, and lines indented by two spaces.
  virtual void describe(const Noise& noise, nlohmann::ordered_json& json) const = 0;
  [[nodiscard]] virtual std::vector<std::string> linesOf(const Noise& noise,
                                                         const MaterialNoise& use) const = 0;
  /// The same for a map; the lines are indented by four spaces.
  virtual void describe(const Bundle& bundle, const NoiseMap& map,
                        nlohmann::ordered_json& json) const = 0;
  [[nodiscard]] virtual std::vector<std::string> linesOf(const Bundle& bundle,
                                                         const NoiseMap& map) const = 0;
  /// Whether the noise has rows, such as rows of bricks, which only a period of whole exemplars
  /// continues.
  [[nodiscard]] virtual bool hasRows(const Noise&) const { return false; }
  /// The number of texture fetches per pixel for one map on one plane: an average if fetchesVary(),
  /// otherwise the maximum.
  [[nodiscard]] virtual int fetches(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                                    const MaterialNoise& use) const = 0;
  /// Those that all maps of a noise share, which fetches() leaves out.
  [[nodiscard]] virtual int sharedFetches() const { return 0; }
  [[nodiscard]] virtual bool fetchesVary() const = 0;
  /// The table from which the shader samples the map.
  [[nodiscard]] virtual const Table& imageOf(const Bundle& bundle, const NoiseMap& map) const = 0;
};

[[nodiscard]] const MethodCommand& commandOf(Method method);

/// An option that the user gave although it belongs to another method than `method`.
struct ForeignOption {
  std::string name;
  Method method{};
};
[[nodiscard]] std::optional<ForeignOption> foreignOption(const CLI::App& verb, Method method);

} // namespace lichen::cli
