// SPDX-License-Identifier: MIT
// Maps -> exemplar. The steps, in order: flatten, fill, rectify.
#include "prepared_maps.h"

#include <fmt/format.h>

#include <algorithm>

namespace lichen {
namespace {

/// Describes how map `m` was made. Moves its unflattened original out of `originals`, unless that
/// is empty.
ExemplarOrigin originOf(std::size_t m, const ExemplarOptions& options, const Flattened& flattened,
                        std::size_t filled, const RectifiedPart& part, const MaterialSet& set,
                        std::vector<MapExemplar>& originals) {
  const std::vector<MapExemplar>& maps = set.maps;
  ExemplarOrigin origin;
  if (set.crop)
    origin.steps.emplace_back("cropped");
  if (options.set.size)
    origin.steps.emplace_back("resized");
  const std::vector<MapTarget>& targets = flattened.maps;
  const bool isFlattened = std::ranges::count(targets, maps[m].target) > 0;
  const double period = flattened.periodPixels * maps[m].width / maps.front().width;
  if (isFlattened)
    origin.steps.push_back(fmt::format("without variation slower than {:.0f} pixels", period));
  if (filled > 0)
    origin.steps.push_back(filled == 1 ? "one part filled"
                                       : fmt::format("{} parts filled", filled));
  if (part.corners)
    origin.steps.emplace_back("straightened");
  if (!originals.empty() && (isFlattened || filled > 0 || part.corners))
    origin.original = std::move(originals[m]);
  return origin;
}

bool has(std::span<const MapExemplar> maps, MapTarget target) {
  return std::ranges::count(maps, target, &MapExemplar::target) > 0;
}

/// The part of the largest file that was used, unless --size hides how large that is.
std::optional<PhotographPart> photographPart(const ExemplarOptions& options,
                                             const MaterialSet& set) {
  if (set.crop)
    return PhotographPart{double(set.crop->x), double(set.crop->y), double(set.crop->width),
                          double(set.crop->height)};
  if (options.set.size)
    return std::nullopt;
  const auto largest = std::ranges::max_element(
      set.maps, {}, [](const MapExemplar& map) { return double(map.width) * map.height; });
  return PhotographPart{0.0, 0.0, double(largest->width), double(largest->height)};
}

Preparation preparationOf(const ExemplarOptions& options, const MaterialSet& set,
                          const Flattened& flattened, std::vector<FilledPlace> filled,
                          const std::optional<TileCorners>& corners) {
  Preparation made;
  if (set.crop)
    made.crop = {std::uint32_t(set.crop->x), std::uint32_t(set.crop->y),
                 std::uint32_t(set.crop->width), std::uint32_t(set.crop->height)};
  if (options.set.size)
    std::ranges::copy(*options.set.size, made.size.emplace().begin());
  made.isGreenDown =
      options.set.normal == NormalConvention::directX && has(set.maps, MapTarget::normal);
  made.usesAlpha = options.set.alpha == AlphaUse::opacity && has(set.maps, MapTarget::opacity);
  if (set.periodic != Periodic::detect)
    made.periodic = set.periodic == Periodic::yes;
  if (!flattened.maps.empty())
    made.flattenPeriod = flattened.periodPixels;
  made.flattened = flattened.maps;
  made.filled = std::move(filled);
  made.corners = corners;
  return made;
}

} // namespace

Result<PreparedExemplar> prepareExemplar(MaterialSet set, const ExemplarOptions& options,
                                         bool findsRegularity, const BakeObserver& observer) {
  std::vector<MapExemplar>& maps = set.maps;
  if (maps.empty())
    return Error{ErrorKind::usage, "no image to bake; expected at least one"};
  std::vector<MapExemplar> originals;
  if (options.keepsOriginals)
    originals = maps;
  const Result<Flattened> flattened =
      applyFlattening(maps, options.flattening, set.periodic, observer, set.notes);
  if (!flattened)
    return flattened.error();
  Result<std::vector<FilledPlace>> filled = applyOutliers(
      maps, options.outliers, set.periodic, photographPart(options, set), observer, set.notes);
  if (!filled)
    return filled.error();
  const Periodic given = options.set.periodic; // --size may have measured the whole picture
  Result<RectifiedPart> part = applyRectification(
      maps, options.rectification, options.rectification.corners ? given : set.periodic,
      findsRegularity, observer.words, set.notes);
  if (!part)
    return part.error();
  if (part.value().corners)
    set.periodic = given;
  PreparedExemplar prepared{
      std::move(set), {}, {}, part.value().regularity, part.value().widthShare};
  for (std::size_t m = 0; m < prepared.set.maps.size(); ++m)
    prepared.origins.push_back(originOf(m, options, flattened.value(), filled.value().size(),
                                        part.value(), prepared.set, originals));
  prepared.preparation = preparationOf(options, prepared.set, flattened.value(),
                                       std::move(filled).value(), part.value().corners);
  return prepared;
}

} // namespace lichen
