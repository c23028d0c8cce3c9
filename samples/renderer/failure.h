// SPDX-License-Identifier: MIT
// Error handling inside the renderer's GPU code and the viewer. A long chain of Vulkan calls reads
// better with exceptions; renderScene() converts them into a Result, runProgram() into an exit
// code.
#pragma once

#include <lichen/result.h>
#include <lichen/vulkan_device.h>

#include <utility>

namespace lichen::renderer {

struct Failure {
  Error error;
};

/// Throws a Failure if the call failed. `what` says what could not be done.
inline void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw Failure{vulkanError(what, result)};
}

/// The value of a Result; throws its error as a Failure.
template <class T>
T take(Result<T> result) {
  if (!result)
    throw Failure{result.error()};
  return std::move(result).value();
}

inline void take(Result<void> result) {
  if (!result)
    throw Failure{result.error()};
}

} // namespace lichen::renderer
