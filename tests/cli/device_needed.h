// SPDX-License-Identifier: MIT
// Skips test cases that need a Vulkan device.
#pragma once

namespace lichen::cli_test {

/// Returns whether `lichen-render` finds a Vulkan device. If it finds none, the test case should
/// return; unless another case fails, the test program then exits with the code that CTest reads as
/// "skipped". Any other failure of `lichen-render --list-devices` fails the case.
[[nodiscard]] bool hasDevice();

} // namespace lichen::cli_test
