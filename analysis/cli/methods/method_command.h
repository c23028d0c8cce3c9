// SPDX-License-Identifier: MIT
// What the verbs ask of a method. Each method implements it in a file of its own; methods.cpp lists
// them.
#pragma once

#include "../bake_risks.h"
#include "../command.h"
#include "../memory_need.h"
#include "../options.h"

#include <lichen/exemplar.h>
#include <lichen/noise_evaluator.h>
#include <lichen/progress.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen::cli {

/// What a method is given to bake.
struct BakeInput {
  const std::string& name;
  std::span<const MapExemplar> maps;
  Periodic borders{}; ///< as MaterialSet::periodic
  int bits = 8;       ///< of the tables' channels
  Progress progress;
};

/// A baked noise, and what the method says of it.
struct MethodBake {
  Noise noise; ///< its tables numbered from 0
  std::vector<Table> tables;
  MaterialNoise material; ///< with the method's parameters
  bool bordersWereBlended = false;
  std::vector<std::string> notes;
  nlohmann::ordered_json json = nlohmann::ordered_json::object(); ///< members of bake --json
  std::vector<std::pair<std::string, std::string>> facts;         ///< rows of the HTML report
};

/// A method's options of `lichen bake`.
class BakeOptions {
public:
  virtual ~BakeOptions() = default;

  /// The risks of each map, in their order.
  [[nodiscard]] virtual Result<std::vector<std::vector<Risk>>>
  assess(std::span<const MapExemplar> maps, Periodic borders,
         const SharedOptions& shared) const = 0;
  [[nodiscard]] virtual BakeMemory memory() const = 0;
  [[nodiscard]] virtual Result<MethodBake> bake(const BakeInput& input) const = 0;
  /// Members of bake --json that are measured on the finished bundle.
  [[nodiscard]] virtual Result<nlohmann::ordered_json>
  measure(const Bundle&, std::span<const MapExemplar>, const MethodBake&) const {
    return nlohmann::ordered_json::object();
  }
};

/// A method's options of the verbs that use a noise: they replace what the material says.
class UseOptions {
public:
  virtual ~UseOptions() = default;
  virtual void replace(MaterialNoise& material, EvaluationOptions& evaluation) const = 0;
  /// What a user may not have meant.
  [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
};

class MethodCommand {
public:
  virtual ~MethodCommand() = default;

  /// The heading of the method's options in help.
  [[nodiscard]] virtual std::string heading() const = 0;
  /// Declare the method's options of a verb, under its heading; the result outlives the parse.
  [[nodiscard]] virtual std::unique_ptr<const BakeOptions> addBakeOptions(CLI::App& verb) const = 0;
  [[nodiscard]] virtual std::unique_ptr<const UseOptions> addSynthOptions(CLI::App& verb) const = 0;
  [[nodiscard]] virtual std::unique_ptr<const UseOptions> addApplyOptions(CLI::App& verb) const = 0;

  /// What `inspect` says of a noise: members of its JSON, and lines, indented by two.
  virtual void describe(const Noise& noise, nlohmann::ordered_json& json) const = 0;
  [[nodiscard]] virtual std::vector<std::string> linesOf(const Noise& noise,
                                                         const MaterialNoise& use) const = 0;
  /// The same of a map, whose lines are indented by four.
  virtual void describe(const Bundle& bundle, const NoiseMap& map,
                        nlohmann::ordered_json& json) const = 0;
  [[nodiscard]] virtual std::vector<std::string> linesOf(const Bundle& bundle,
                                                         const NoiseMap& map) const = 0;
  /// Texture fetches of a pixel of one map on one plane, at most or about.
  [[nodiscard]] virtual int fetches(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                                    const MaterialNoise& use) const = 0;
  [[nodiscard]] virtual bool fetchesVary() const = 0;
  /// The table that the shader fetches from for a map.
  [[nodiscard]] virtual const Table& imageOf(const Bundle& bundle, const NoiseMap& map) const = 0;
};

[[nodiscard]] const MethodCommand& commandOf(Method method);

/// An option of another method than `method` that was given.
struct ForeignOption {
  std::string name;
  Method method{};
};
[[nodiscard]] std::optional<ForeignOption> foreignOption(const CLI::App& verb, Method method);

} // namespace lichen::cli
