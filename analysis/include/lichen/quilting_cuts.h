// SPDX-License-Identifier: MIT
// How well the tiles of a quilting noise fit together where they are cut.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>

#include <cstddef>
#include <optional>

namespace lichen {

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
