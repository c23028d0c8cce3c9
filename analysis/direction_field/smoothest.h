// SPDX-License-Identifier: MIT
// The field that turns least from vertex to vertex: the eigenvector of the connection Laplacian to
// its smallest eigenvalue [K13].
#pragma once

#include "connection.h"
#include "progress_part.h"

#include <lichen/result.h>

namespace lichen::direction_field {

/// A direction of absolute value 1 for each vertex of the surface. Errors: badInput where the
/// system cannot be solved with the memory and time that a surface's takes. Throws std::bad_alloc.
[[nodiscard]] Result<std::vector<Complex>>
smoothestField(const Surface& surface, const Connection& connection, const ProgressPart& progress);

} // namespace lichen::direction_field
