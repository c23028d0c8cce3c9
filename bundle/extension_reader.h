// SPDX-License-Identifier: MIT
// The extension's objects in a glTF document -> a bundle, recording every fault.
#pragma once

#include "gltf_tables.h"

namespace lichen {

/// Reads the readable parts of a file and records every fault. Returns nothing if the file is no
/// complete glTF.
[[nodiscard]] std::optional<Bundle> inspectBundle(std::span<const std::byte> file,
                                                  ExternalFile externalFile, FindingList& findings);

/// Reads and checks the extension of a document, and its tables. The result is valid only if no
/// error was recorded.
[[nodiscard]] Bundle readExtension(const nlohmann::json& root, GltfTables& source,
                                   FindingList& findings);

using Tables = std::vector<std::optional<Table>>;

/// Reads and checks one map. `noise` must be complete except for its maps. `tables` are the tables
/// read so far; a table that could not be read is empty.
[[nodiscard]] NoiseMap readMap(ObjectReader& reader, const Noise& noise, const Tables& tables,
                               FindingList& findings);

/// Mean and covariance of stored values.
struct MapMoments {
  std::vector<double> mean;
  std::vector<double> covariance;
};
/// Reads and checks the moments of `n` channels; `n` is 0 if the channels are unknown.
[[nodiscard]] MapMoments readMoments(ObjectReader& reader, ValueEncoding encoding, std::size_t n);
/// Reads and checks the member mipLoss, which has `rows` rows. The caller checks the number of
/// levels.
[[nodiscard]] std::vector<double> readLosses(ObjectReader& reader, std::size_t rows);

/// Reads the member `layers` of the noise `own`, if there is one. `places` has the index of each
/// noise of the file in Bundle::noises, of ignored ones none. layersFault() checks the rest.
[[nodiscard]] std::optional<NoiseLayers>
readLayers(ObjectReader& noise, std::size_t own, std::span<const std::optional<std::size_t>> places,
           FindingList& findings);

/// Reads the member `preparation` of a noise, if there is one.
[[nodiscard]] Preparation readPreparation(ObjectReader& noise, FindingList& findings);

/// Reads and checks the mix weight of a material. `textures` is the number of textures in the glTF
/// document.
[[nodiscard]] MixWeight readMixWeight(ObjectReader& material, std::size_t textures,
                                      FindingList& findings);

/// Reads the member `key` as a table index, and returns the table or null. Records an index that is
/// out of range.
[[nodiscard]] const Table* readTableIndex(ObjectReader& reader, const char* key, const char* code,
                                          const Tables& tables, std::size_t& index);
/// The size of a table, for messages.
[[nodiscard]] std::string shapeOf(const Table& table);
/// Number of colour channels of a table, at most 3: alpha is unused.
[[nodiscard]] std::size_t usedChannels(TexelFormat format);

/// Bound from the format's schema. bundle.h has the bounds of the parameters.
inline constexpr std::uint64_t kMaxTexCoord = 15;
inline constexpr std::size_t kMaxMaps = 6; ///< one per target
/// Tolerance for rounding errors: for the eigenvalues of a covariance as a share of its trace, for
/// its symmetry as a share of its largest value.
inline constexpr double kCovarianceTolerance = 1e-9;
/// Whether all eigenvalues of a symmetric n x n matrix are above `share` of its trace, or, if share
/// is not positive, the matrix is 0: whether the rest has a Cholesky factor.
[[nodiscard]] bool hasEigenvaluesFrom(std::vector<double> matrix, std::size_t n, double share);

} // namespace lichen
