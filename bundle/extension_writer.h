// SPDX-License-Identifier: MIT
// A bundle -> the extension's JSON objects.
#pragma once

#include "gltf_builder.h"

#include <lichen/bundle.h>

namespace lichen {

/// The root object. Appends each table's KTX2 bytes to `builder`.
[[nodiscard]] JsonTree describeBundle(const Bundle& bundle, GltfBuilder& builder);
/// A material's object; members that have their default value are left out.
[[nodiscard]] JsonTree describeMaterialNoise(const MaterialNoise& use);

} // namespace lichen
