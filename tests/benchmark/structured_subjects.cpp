// SPDX-License-Identifier: MIT
// Generated photographs -> the exemplars that bakes make of them, for those that repeat clearly.
#include "structured_subjects.h"

#include <lichen/regularity.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <prepared_exemplar.h>
#include <string_view>
#include <structured.h>

namespace lichen::bench {
namespace {

constexpr double kLeastStrength = 0.5;

/// The plans of structuredPlans() in four conditions, and one that tiles with unequal cells.
std::vector<exemplars::StructuredPlan> plans() {
  constexpr std::array<std::string_view, 4> kConditions{"even", "whole", "turned-3", "mixed"};
  std::vector<exemplars::StructuredPlan> result;
  for (const exemplars::StructuredPlan& plan : exemplars::structuredPlans()) {
    if (std::ranges::find(kConditions, plan.condition.name) != kConditions.end())
      result.push_back(plan);
    if (plan.condition.whole) {
      result.push_back(plan);
      result.back().condition.name = "whole-irregular-7";
      result.back().condition.irregularity = 0.07f;
    }
  }
  return result;
}

/// The shortest of the two periods, their sum and their difference.
double shortestPeriod(const std::array<exemplars::Point, 2>& periods) {
  const auto [a, b] = periods;
  const double other = std::min(std::hypot(a.x + b.x, a.y + b.y), std::hypot(a.x - b.x, a.y - b.y));
  return std::min({double(std::hypot(a.x, a.y)), double(std::hypot(b.x, b.y)), other});
}

SrgbImage imageOf(const MapExemplar& map) {
  SrgbImage image(map.width, map.height, int(map.channels.size()));
  image.values = map.values;
  return image;
}

std::optional<StructuredSubject> subjectOf(int side, const exemplars::StructuredPlan& plan) {
  exemplars::StructuredPicture picture = exemplars::structured(side, plan);
  std::vector<MapExemplar> maps = test::preparedExemplar(picture.image);
  const Regularity regularity = test::regularityOfPrepared(maps);
  if (regularity.strength <= kLeastStrength)
    return std::nullopt;
  maps = test::wholePeriodsOf(std::move(maps), regularity);
  StructuredSubject subject{
      plan.name(), plan.material, imageOf(maps.front()), shortestPeriod(picture.periods), {}};
  if (plan.condition.whole && !regularity.wholePeriods && maps.front().width == side)
    subject.cells = std::move(picture.cells);
  return subject;
}

} // namespace

std::vector<StructuredSubject> structuredSubjects(int sidePixels) {
  const std::vector<exemplars::StructuredPlan> all = plans();
  std::vector<std::optional<StructuredSubject>> found(all.size());
  tbb::parallel_for(
      std::size_t(0), all.size(), [&](std::size_t k) { found[k] = subjectOf(sidePixels, all[k]); },
      tbb::simple_partitioner());
  std::vector<StructuredSubject> result;
  for (std::optional<StructuredSubject>& subject : found)
    if (subject)
      result.push_back(std::move(*subject));
  return result;
}

} // namespace lichen::bench
