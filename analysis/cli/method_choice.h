// SPDX-License-Identifier: MIT
// Bakes an exemplar by several methods, and chooses the one for --method auto.
#pragma once

#include "methods/method_command.h"

#include <lichen/method_sheet.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// The options of all methods, in the order of Method.
using MethodOptions = std::vector<std::unique_ptr<const BakeOptions>>;

/// The time of a pixel, in plain fetches.
inline constexpr NumberRange kBudgetRange{1.0, 10000.0};

/// Bakes one map by each of `tried`.
[[nodiscard]] Result<std::vector<MethodTrial>> tryMethods(const MapExemplar& map, Periodic borders,
                                                          const MethodOptions& methods,
                                                          std::span<const Method> tried,
                                                          const Progress& progress);

/// The most memory that a bake by any of the methods needs.
[[nodiscard]] BakeMemory largestMemory(const MethodOptions& methods);

struct MethodChoice {
  Method method{};
  std::string reason; ///< a sentence without a full stop
};

/// What nearestForItsCost() says of those of `candidates` within the budget [plain fetches], and the
/// cheapest for an exemplar that is too small for lookDistance(). The noises are baked from the
/// middle of the first map, at most 512 x 512 pixels. Source: docs/decisions/032-method-choice.md.
[[nodiscard]] Result<MethodChoice> chooseMethod(std::span<const MapExemplar> maps, Periodic borders,
                                                const MethodOptions& methods,
                                                std::span<const Method> candidates, double budget,
                                                const SharedOptions& shared);

} // namespace lichen::cli
