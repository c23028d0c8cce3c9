// SPDX-License-Identifier: MIT
// A bundle -> the extension's JSON objects.
#pragma once

#include "gltf_builder.h"

#include <lichen/bundle.h>

namespace lichen {

/// One of its noises, and one of its tables, whose KTX2 bytes a view has.
[[nodiscard]] JsonTree describeNoise(const Noise& noise);
[[nodiscard]] JsonTree describeTable(const Table& table, std::size_t bufferView);

/// Of the bytes of a table: texels then lie aligned in the buffer as they do in the KTX2 file,
/// where those of RGBA32F take 16 bytes.
inline constexpr std::size_t kTableAlignment = 16;

/// The root object. Appends each table's KTX2 bytes to `builder`.
[[nodiscard]] JsonTree describeBundle(const Bundle& bundle, GltfBuilder& builder);
/// A material's object; members that have their default value are left out.
[[nodiscard]] JsonTree describeMaterialNoise(const MaterialNoise& use);

} // namespace lichen
