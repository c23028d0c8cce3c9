// SPDX-License-Identifier: MIT
// A map's values -> the pixels that a glTF core texture has for them.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/result.h>

#include <cstddef>
#include <vector>

namespace lichen {

/// `values` are decoded ones, as synthesize() gives them, of all the map's channels in their order.
/// Slopes become unit normals, stored as (n + 1) / 2 in RGB with green up; occlusion, roughness and
/// metallic take red, green and blue, with 1 for those that are absent; others stay. Throws
/// std::bad_alloc, as building blocks do.
[[nodiscard]] LinearImage coreTexture(const NoiseMap& map, LinearImage values);

/// The PNG of a core texture: light in sRGB code, and data, which alpha is too, as it is. Of 8
/// bits; of 16 for a height, which no core material has but synth shows.
/// Errors as encodePng().
[[nodiscard]] Result<std::vector<std::byte>> encodeCoreTexture(MapTarget target,
                                                               LinearImage texture);

} // namespace lichen
