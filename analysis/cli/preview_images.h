// SPDX-License-Identifier: MIT
// The images for the core texture slots of a baked material.
#pragma once

#include <lichen/bundle_writer.h>

namespace lichen::cli {

/// Returns tileable images of the noise's maps for the core material, evaluated with the material's
/// parameters. The widest map of the noise determines their size.
[[nodiscard]] Result<PreviewImages> previewImages(const Bundle& bundle,
                                                  const MaterialNoise& material);

} // namespace lichen::cli
