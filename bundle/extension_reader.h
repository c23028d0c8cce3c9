// SPDX-License-Identifier: MIT
// The extension's objects in a glTF document -> a bundle, with every fault recorded.
#pragma once

#include "gltf_file.h"
#include "object_reader.h"

namespace lichen {

/// Reads and checks the extension. The result may be used only when no error was recorded.
[[nodiscard]] Bundle readExtension(GltfFile& file, FindingList& findings);

using Tables = std::vector<std::optional<Table>>;

/// Reads and checks one map; of `noise`, what comes before its maps is read; `tables` are those
/// read so far, null where one could not be.
[[nodiscard]] NoiseMap readMap(ObjectReader& reader, const Noise& noise, const Tables& tables,
                               FindingList& findings);

/// Reads and checks what the textons of a noise have in common. One that is at fault has no
/// coefficients, and nothing is checked against it.
[[nodiscard]] TextonShape readTextonShape(ObjectReader& noise, FindingList& findings);

/// Reads and checks what a map of a texton noise has besides channels and statistics.
void readTexton(ObjectReader& reader, const TextonShape& shape, const Tables& tables,
                FindingList& findings, NoiseMap& map);

/// Checks the texels of a texton whose image, scale, statistics and losses have the right sizes.
/// Time: 70 ns for each channel of a texel. Memory: 60 bytes a texel (docs/benchmarks.md).
void checkTextonTexels(ObjectReader& reader, const TextonShape& shape, const NoiseMap& map,
                       const Table& image);

/// Reads and checks mean, covariance and losses of `n` channels; 0 of channels that are not known.
/// The losses are `lossRows` rows, of as many levels as is for the kind of image to say.
[[nodiscard]] MapStatistics readStatistics(ObjectReader& reader, ValueEncoding encoding,
                                           std::size_t n, std::size_t lossRows);

/// Reads and checks where a material takes the weight of a mix from; `textures` are glTF's.
[[nodiscard]] MixWeight readMixWeight(ObjectReader& material, std::size_t textures,
                                      FindingList& findings);

/// The table that member `key` names, or null. An index that is out of range is recorded.
[[nodiscard]] const Table* readTableIndex(ObjectReader& reader, const char* key, const char* code,
                                          const Tables& tables, std::size_t& index);
/// Its size, for messages.
[[nodiscard]] std::string shapeOf(const Table& table);
/// Colour channels of a table: alpha is unused.
[[nodiscard]] std::size_t usedChannels(TexelFormat format);

/// A bound that the schema states too; those of parameters are in bundle.h.
inline constexpr std::uint64_t kMaxTexCoord = 15;
/// Of the trace: how far rounding may take a covariance from symmetric and positive.
inline constexpr double kCovarianceTolerance = 1e-9;

} // namespace lichen
