// SPDX-License-Identifier: MIT
// Error messages for the host.
#pragma once

#include <lichen/lichen.h>

namespace lichen::plugin {

/// Formats one line into the host's diagnostic. Escapes control characters and invalid UTF-8, for
/// example in names from a file, as \xNN. Truncates at a whole character if the line is too long.
#ifdef __GNUC__
[[gnu::format(printf, 2, 3)]]
#endif
void writeDiagnostic(LichenDiagnostic* diagnostic, const char* format, ...) noexcept;

} // namespace lichen::plugin
