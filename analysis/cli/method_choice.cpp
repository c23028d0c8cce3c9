// SPDX-License-Identifier: MIT
// Exemplar -> a noise of each method -> the method whose noise looks nearest for its cost.
#include "method_choice.h"

#include "progress_line.h"

#include <lichen/method_candidate.h>
#include <lichen/quality.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ranges>

namespace lichen::cli {
namespace {

constexpr int kTrialSide = 512;         // pixels: bakes of all methods take seconds
constexpr double kTrialExemplars = 2.0; // of a picture, per side

Result<MethodTrial> trialOf(const MapExemplar& map, Periodic borders, const BakeOptions& method,
                            const Progress& progress) {
  const std::string name = "trial";
  constexpr int kBits = 8;
  const auto start = std::chrono::steady_clock::now();
  Result<MethodBake> baked = method.bake({name, {&map, 1}, borders, kBits, progress});
  if (!baked)
    return baked.error();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  MethodBake& bake = baked.value();
  MethodTrial trial;
  trial.bundle.tables = std::move(bake.tables);
  trial.bundle.noises = {std::move(bake.noise)};
  trial.bundle.materials = {bake.material};
  trial.bakeSeconds = taken.count();
  trial.plainFetches = method.plainFetches();
  return trial;
}

/// The middle of a map, at most kTrialSide on each side.
MapExemplar middleOf(const MapExemplar& map) {
  MapExemplar middle{map.target,
                     map.channels,
                     map.encoding,
                     std::min(map.width, kTrialSide),
                     std::min(map.height, kTrialSide),
                     {},
                     map.quantum};
  const std::size_t channels = map.channels.size();
  const auto left = std::size_t(map.width - middle.width) / 2;
  const auto top = std::size_t(map.height - middle.height) / 2;
  for (std::size_t y = top; y < top + std::size_t(middle.height); ++y) {
    const auto row =
        map.values.begin() + std::ptrdiff_t((y * std::size_t(map.width) + left) * channels);
    middle.values.insert(middle.values.end(), row,
                         row + std::ptrdiff_t(std::size_t(middle.width) * channels));
  }
  return middle;
}

/// `further`: an end of the reason, on a greater budget.
MethodChoice chosenOf(const std::vector<MethodCandidate>& candidates, double budget,
                      const std::string& further) {
  const MethodCandidate& best = candidates[nearestForItsCost(candidates)];
  std::string others;
  bool isCheapest = true;
  for (const MethodCandidate& other : candidates) {
    if (&other == &best)
      continue;
    isCheapest = isCheapest && other.plainFetches >= best.plainFetches;
    others += fmt::format("{}{} {:.4f}", others.empty() ? "" : ", ", nameOf(other.method),
                          other.distance);
  }
  return {
      best.method,
      fmt::format("--method auto chose {}: its look_distance is {:.4f}, and {} ({}){}",
                  nameOf(best.method), best.distance,
                  isCheapest
                      ? fmt::format("no other within {:g} plain fetches is clearly lower", budget)
                      : "that of cheaper methods is clearly higher",
                  others, further)};
}

} // namespace

Result<std::vector<MethodTrial>> tryMethods(const MapExemplar& map, Periodic borders,
                                            const MethodOptions& methods,
                                            std::span<const Method> tried,
                                            const Progress& progress) {
  std::vector<MethodTrial> trials;
  for (const Method method : tried) {
    const auto done = double(trials.size()), count = double(tried.size());
    Result<MethodTrial> trial = trialOf(map, borders, *methods[std::size_t(method)],
                                        partOf(progress, done / count, (done + 1.0) / count));
    if (!trial)
      return trial.error();
    trials.push_back(std::move(trial).value());
  }
  return trials;
}

BakeMemory largestMemory(const MethodOptions& methods) {
  BakeMemory largest;
  for (const auto& method : methods) {
    const BakeMemory own = method->memory();
    largest = {std::max(largest.map, own.map), std::max(largest.largest, own.largest)};
  }
  return largest;
}

Result<MethodChoice> chooseMethod(std::span<const MapExemplar> maps, Periodic borders,
                                  const MethodOptions& methods, std::span<const Method> candidates,
                                  double budget, const SharedOptions& shared) {
  const auto costOf = [&](Method method) { return methods[std::size_t(method)]->plainFetches(); };
  std::vector<Method> affordable;
  for (const Method method : candidates)
    if (costOf(method) <= budget)
      affordable.push_back(method);
  const Method cheapest = *std::ranges::min_element(candidates, {}, costOf);
  if (affordable.empty())
    return Error{ErrorKind::usage,
                 fmt::format("--budget {:g}: no method is that cheap; expected at least {:g}",
                             budget, costOf(cheapest))};
  std::string further;
  if (affordable.size() < candidates.size())
    further = fmt::format("; --budget {:g} tries all",
                          std::ceil(std::ranges::max(candidates | std::views::transform(costOf))));
  if (affordable.size() == 1)
    return MethodChoice{
        cheapest,
        fmt::format("--method auto chose {}, the only method within {:g} plain fetches a pixel{}",
                    nameOf(cheapest), budget, further)};
  const MapExemplar middle = middleOf(maps.front());
  if (std::min(middle.width, middle.height) < kLeastLookSide)
    return MethodChoice{
        cheapest,
        fmt::format("--method auto chose {}, the cheapest: an exemplar of {} x {} pixels is too "
                    "small to compare methods",
                    nameOf(cheapest), middle.width, middle.height)};
  ProgressLine progress("try", shared);
  const bool isWhole = middle.width == maps.front().width && middle.height == maps.front().height;
  constexpr double kBakes = 0.7; // of the time
  const Result<std::vector<MethodTrial>> trials =
      tryMethods(middle, isWhole ? borders : Periodic::no, methods, affordable,
                 partOf(progress.asProgress(), 0.0, kBakes));
  if (!trials)
    return trials.error();
  std::vector<MethodCandidate> looks;
  for (const MethodTrial& trial : trials.value()) {
    const auto done = double(looks.size()), count = double(trials.value().size());
    const Result<MethodLook> look =
        lookOf(trial, middle, kTrialExemplars,
               partOf(progress.asProgress(), kBakes + (1.0 - kBakes) * done / count,
                      kBakes + (1.0 - kBakes) * (done + 1.0) / count));
    if (!look)
      return look.error();
    looks.push_back(
        {trial.bundle.noises.front().method(), trial.plainFetches, look.value().distance});
  }
  progress.erase();
  return chosenOf(looks, budget, further);
}

} // namespace lichen::cli
