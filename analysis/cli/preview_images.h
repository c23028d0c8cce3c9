// SPDX-License-Identifier: MIT
// What the core slots of a baked material show.
#pragma once

#include <lichen/bundle_writer.h>

namespace lichen::cli {

/// Tileable images of a noise's maps for the core material, in the pattern of `seed`, as large as
/// the noise's widest map asks for.
[[nodiscard]] Result<PreviewImages> previewImages(const Bundle& bundle, std::size_t noise,
                                                  std::uint32_t seed);

} // namespace lichen::cli
