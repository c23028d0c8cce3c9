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

MethodChoice chosenOf(const std::vector<MethodCandidate>& candidates, double budget) {
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
      fmt::format("--method auto chose {}: its look_distance is {:.4f}, and {} ({})",
                  nameOf(best.method), best.distance,
                  isCheapest
                      ? fmt::format("no other within {:g} plain fetches is clearly lower", budget)
                      : "that of cheaper methods is clearly higher",
                  others)};
}

} // namespace

Result<std::vector<MethodTrial>> tryMethods(const MapExemplar& map, Periodic borders,
                                            const MethodOptions& methods, double budget,
                                            const Progress& progress) {
  std::vector<MethodTrial> trials;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m]->plainFetches() > budget)
      continue;
    const auto count = double(methods.size());
    Result<MethodTrial> trial = trialOf(map, borders, *methods[m],
                                        partOf(progress, double(m) / count, double(m + 1) / count));
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
                                  const MethodOptions& methods, std::optional<double> budget,
                                  const SharedOptions& shared) {
  const double limit = budget.value_or(methods.front()->plainFetches());
  const auto affordable = std::count_if(methods.begin(), methods.end(), [&](const auto& method) {
    return method->plainFetches() <= limit;
  });
  const auto cheapest =
      std::min_element(methods.begin(), methods.end(), [](const auto& a, const auto& b) {
        return a->plainFetches() < b->plainFetches();
      });
  if (affordable == 0)
    return Error{ErrorKind::usage,
                 fmt::format("--budget {:g}: no method is that cheap; expected at least {:g}",
                             limit, (*cheapest)->plainFetches())};
  if (affordable == 1) {
    const auto only = Method(cheapest - methods.begin());
    double all = 0.0;
    for (const auto& method : methods)
      all = std::max(all, method->plainFetches());
    return MethodChoice{only,
                        fmt::format("--method auto chose {}, the only method within {:g} plain "
                                    "fetches a pixel; --budget {:g} tries all",
                                    nameOf(only), limit, std::ceil(all))};
  }
  const MapExemplar middle = middleOf(maps.front());
  if (std::min(middle.width, middle.height) < kLeastLookSide)
    return MethodChoice{
        Method(cheapest - methods.begin()),
        fmt::format("--method auto chose {}, the cheapest: an exemplar of {} x {} pixels is too "
                    "small to compare methods",
                    nameOf(Method(cheapest - methods.begin())), middle.width, middle.height)};
  ProgressLine progress("try", shared);
  const bool isWhole = middle.width == maps.front().width && middle.height == maps.front().height;
  constexpr double kBakes = 0.7; // of the time
  const Result<std::vector<MethodTrial>> trials =
      tryMethods(middle, isWhole ? borders : Periodic::no, methods, limit,
                 partOf(progress.asProgress(), 0.0, kBakes));
  if (!trials)
    return trials.error();
  std::vector<MethodCandidate> candidates;
  for (const MethodTrial& trial : trials.value()) {
    const auto done = double(candidates.size()), count = double(trials.value().size());
    const Result<MethodLook> look =
        lookOf(trial, middle, kTrialExemplars,
               partOf(progress.asProgress(), kBakes + (1.0 - kBakes) * done / count,
                      kBakes + (1.0 - kBakes) * (done + 1.0) / count));
    if (!look)
      return look.error();
    candidates.push_back(
        {trial.bundle.noises.front().method(), trial.plainFetches, look.value().distance});
  }
  progress.erase();
  return chosenOf(candidates, limit);
}

} // namespace lichen::cli
