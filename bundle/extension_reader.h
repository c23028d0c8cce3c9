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

/// Mean and covariance of stored values.
struct MapMoments {
  std::vector<double> mean;
  std::vector<double> covariance;
};
/// Reads and checks those of `n` channels, 0 where the channels are not known.
[[nodiscard]] MapMoments readMoments(ObjectReader& reader, ValueEncoding encoding, std::size_t n);
/// Reads and checks the member mipLoss: `rows` rows of as many levels as the caller wants to see.
[[nodiscard]] std::vector<double> readLosses(ObjectReader& reader, std::size_t rows);

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
