// SPDX-License-Identifier: MIT
// The field that turns least from vertex to vertex: the eigenvector of the connection Laplacian to
// its smallest eigenvalue; and one that keeps to an axis besides [K13].
#pragma once

#include "connection.h"
#include "progress_part.h"

#include <lichen/result.h>

namespace lichen::direction_field {

/// A direction of absolute value 1 for each vertex of the surface. Errors: badInput where the
/// system cannot be solved with the memory and time that a surface's takes. Throws std::bad_alloc.
[[nodiscard]] Result<std::vector<Complex>>
smoothestField(const Surface& surface, const Connection& connection, const ProgressPart& progress);

/// The same, of a field that turns little and keeps to the part of `axis`, of positive length, that
/// lies in the tangent plane: all the more, the longer that is. Where it vanishes, the smoothest
/// field decides.
[[nodiscard]] Result<std::vector<Complex>> alignedField(const Surface& surface,
                                                        const Connection& connection,
                                                        const Eigen::Vector3d& axis,
                                                        const ProgressPart& progress);

} // namespace lichen::direction_field
