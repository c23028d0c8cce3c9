// SPDX-License-Identifier: MIT
// For cases that run a program on a Vulkan device.
#pragma once

namespace lichen::cli_test {

/// Whether `lichen-render` finds a Vulkan device. Where there is none the case returns, and unless
/// another case fails the test ends with the exit code that CTest takes as "skipped". Any other
/// failure of `lichen-render --list-devices` fails the case.
[[nodiscard]] bool hasDevice();

} // namespace lichen::cli_test
