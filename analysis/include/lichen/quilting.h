// SPDX-License-Identifier: MIT
// Bakes exemplars for quilting: structure, such as bricks, planks and weaves, survives.
#pragma once

#include <lichen/baked_noise.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/regularity.h>
#include <lichen/result.h>

#include <optional>
#include <span>
#include <string>

namespace lichen {

struct QuiltingOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the images
  /// How closely tiles follow what repeats in the exemplar, kGuideRange: 0 places them
  /// anywhere. Absent: as clearly as it repeats.
  std::optional<double> guide;
  Progress progress; ///< empty: no reports
};

/// Finds the exemplar's cells, what repeats in it and the grain of its first map, and stores the
/// maps with mip levels. Needs at least one map, each within the ranges of MapExemplar; maps may
/// differ in size. `name` names the noise and, with the target, its tables. Errors: usage for
/// options or maps outside their ranges; resources if memory runs out; environment if
/// `options.progress` stops it. Thread-safe; same bytes for any number of threads. O(N log N) in
/// the number of pixels. Source: docs/decisions/012-quilting.md.
[[nodiscard]] Result<MethodBake> bakeQuilting(std::string name, std::span<const MapExemplar> maps,
                                              const QuiltingOptions& options);

/// How different two tiles are on the outlines of cells, where cuts lie: the mean squared
/// difference of their stored values there, over the difference of unrelated texels. 0 where a
/// joint meets a joint, 1 where tiles have nothing in common, more where joints meet the insides of
/// cells. Nothing for a map without variance, cells without outlines, or a list without offsets but
/// 0. Precondition: `noise` is one of quilting in `bundle`, and `map` one of its maps. Errors:
/// resources if memory runs out. O(texels of the image + texels of cells * offsets). Source:
/// docs/decisions/007-verdicts.md.
[[nodiscard]] Result<std::optional<double>> cutMismatch(const Bundle& bundle, const Noise& noise,
                                                        const NoiseMap& map);

} // namespace lichen
