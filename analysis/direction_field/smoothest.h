// SPDX-License-Identifier: MIT
// The smoothest direction field, an eigenvector of the connection Laplacian to its smallest
// eigenvalue, and a smooth field that also follows an axis [K13].
#pragma once

#include "connection.h"
#include "progress_part.h"

#include <lichen/result.h>

namespace lichen::direction_field {

/// One direction of absolute value 1 per vertex of the surface. Errors: badInput if the system
/// cannot be solved within the memory and time limits for a surface. Throws std::bad_alloc.
[[nodiscard]] Result<std::vector<Complex>>
smoothestField(const Surface& surface, const Connection& connection, const ProgressPart& progress);

/// Like smoothestField(), but the field also follows the projection of `axis`, which has positive
/// length, on the tangent plane: the longer the projection, the more closely. Where the projection
/// vanishes, the smoothest field decides.
[[nodiscard]] Result<std::vector<Complex>> alignedField(const Surface& surface,
                                                        const Connection& connection,
                                                        const Eigen::Vector3d& axis,
                                                        const ProgressPart& progress);

} // namespace lichen::direction_field
