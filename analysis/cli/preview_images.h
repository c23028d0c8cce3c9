// SPDX-License-Identifier: MIT
// What the core slots of a baked material show.
#pragma once

#include <lichen/bundle_writer.h>

namespace lichen::cli {

/// Tileable images of the maps of a material's noise for the core material, in the material's
/// pattern, as large as the noise's widest map asks for.
[[nodiscard]] Result<PreviewImages> previewImages(const Bundle& bundle,
                                                  const MaterialNoise& material);

} // namespace lichen::cli
