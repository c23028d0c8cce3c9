// SPDX-License-Identifier: MIT
// Messages to the host.
#pragma once

#include <lichen/lichen.h>

namespace lichen::plugin {

/// Writes one line into the host's diagnostic: control characters and bytes that are no UTF-8, of
/// names in a file or of the host's, as \xNN; cut after a whole character where it does not fit.
[[gnu::format(printf, 2, 3)]] void say(LichenDiagnostic* diagnostic, const char* format,
                                       ...) noexcept;

} // namespace lichen::plugin
