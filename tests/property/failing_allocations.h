// SPDX-License-Identifier: MIT
// Global allocation operators that fail when told to, for programs that link this file.
#pragma once

namespace lichen::test {

/// Counts down while positive; the allocation of this thread that reaches 0 fails. Those under
/// 1 KiB do not count: an error's own message must be storable.
extern thread_local int allocationsUntilFailure;

} // namespace lichen::test
