// SPDX-License-Identifier: MIT
// How the renderer's GPU code and the viewer's report failure inside themselves: a long chain of
// Vulkan calls reads better with an exception, which renderScene() and runProgram() turn back into
// a Result and an exit code.
#pragma once

#include <lichen/result.h>
#include <lichen/vulkan_device.h>

#include <utility>

namespace lichen::renderer {

struct Failure {
  Error error;
};

/// Throws a Failure unless the call succeeded.
inline void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw Failure{vulkanError(what, result)};
}

/// The value of a Result, or its error as a Failure.
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
