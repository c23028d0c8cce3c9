// SPDX-License-Identifier: MIT
// Converts the values of a map to the pixels of the glTF core texture that holds it.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/result.h>

#include <cstddef>
#include <vector>

namespace lichen {

/// `values` holds decoded values, as synthesize() returns them: all channels of the map, in order.
/// Slopes become unit normals, stored as (n + 1) / 2 in RGB with green up. Occlusion, roughness and
/// metallic go to red, green and blue; absent ones are 1. Other maps are returned unchanged. Throws
/// std::bad_alloc, as all building blocks do.
[[nodiscard]] LinearImage coreTexture(const NoiseMap& map, LinearImage values);

/// The RGB of `color`, or white if that is empty, with `opacity`, of the same size, as alpha.
/// Throws std::bad_alloc.
[[nodiscard]] LinearImage withAlpha(const LinearImage& color, const LinearImage& opacity);

/// Encodes a core texture as PNG. Light is stored in sRGB; data and alpha are stored unchanged. The
/// file has 8 bits per channel, or 16 for a height, which no core material uses but `synth` writes.
/// Errors: as encodePng().
[[nodiscard]] Result<std::vector<std::byte>> encodeCoreTexture(MapTarget target,
                                                               LinearImage texture);

} // namespace lichen
