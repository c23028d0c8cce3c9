// SPDX-License-Identifier: MIT
// glTF accessors -> numbers. Handles strided and sparse accessors and all component types.
// Sources: glTF 2.0 specification, sections 3.6.2 and 5.1; KHR_mesh_quantization.
#pragma once

#include "gltf_file.h"

namespace lichen {

/// Maximum number of elements of one accessor. Three floats take 12 bytes, and so does an index of
/// a strip, which becomes a triangle.
inline constexpr std::size_t kMostElements = std::size_t(1) << 25;

/// Code of the finding for an accessor of another type or component type than its use needs.
inline constexpr char kAccessorType[] = "accessor-type";

/// Component types of an accessor.
inline constexpr std::uint64_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122,
                               kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

/// The values of an accessor of 2 to 4 components, or of 16 of a 4 x 4 matrix, all finite, of one
/// of the component types. Integers become floats; normalized ones are divided by their range. On a
/// fault, records it and returns nothing. Throws std::bad_alloc.
template <std::size_t kComponents>
[[nodiscard]] std::optional<std::vector<std::array<float, kComponents>>>
readVectors(GltfFile& file, std::size_t accessor, FindingList& findings,
            std::initializer_list<std::uint64_t> types = {kByte, kUnsignedByte, kShort,
                                                          kUnsignedShort, kFloat});

/// The values of a scalar accessor of unsigned integers, all below `limit`. On a fault, records it
/// and returns nothing. Throws std::bad_alloc.
[[nodiscard]] std::optional<std::vector<std::uint32_t>>
readIndices(GltfFile& file, std::size_t accessor, std::size_t limit, FindingList& findings);

/// Modes of primitives [glTF 2.0, section 5.24]; strips are between the two.
inline constexpr std::uint64_t kTriangles = 4, kTriangleFan = 6;

/// Converts the indices of a mode to a list of triangles. All triangles of a strip or fan get the
/// winding of the first. Drops an incomplete last triangle of a list.
[[nodiscard]] std::vector<std::uint32_t> asTriangleList(std::vector<std::uint32_t> indices,
                                                        std::uint64_t mode);

} // namespace lichen
