// SPDX-License-Identifier: MIT
// A bundle -> the extension's JSON objects.
#pragma once

#include "gltf_builder.h"

#include <lichen/bundle.h>

namespace lichen {

/// Returns the JSON object of a noise, which has this index in the file.
[[nodiscard]] nlohmann::ordered_json describeNoise(const Noise& noise, std::size_t index);
/// Returns the JSON object of a table. The buffer view `bufferView` holds its KTX2 file.
[[nodiscard]] nlohmann::ordered_json describeTable(const Table& table, std::size_t bufferView);

/// Alignment of a table's bytes in the buffer. It preserves the texel alignment of the KTX2 file;
/// RGBA32F texels take 16 bytes.
inline constexpr std::size_t kTableAlignment = 16;

/// The extension's root object. Appends each table's KTX2 bytes to `builder`.
[[nodiscard]] nlohmann::ordered_json describeBundle(const Bundle& bundle, GltfBuilder& builder);
/// The extension's object of a material. Members with their default value are omitted.
[[nodiscard]] nlohmann::ordered_json describeMaterialNoise(const MaterialNoise& use);

} // namespace lichen
