// SPDX-License-Identifier: MIT
// Vulkan objects whose creation may fail.
#pragma once

#include <volk.h>

namespace lichen {

/// Calls a vkCreate function. What a failed call leaves in the handle is undefined [Vulkan, Return
/// Codes], and must not be destroyed.
template <class Function, class Parent, class Info, class Handle>
VkResult createObject(Function function, Parent parent, const Info& info, Handle& handle) {
  const VkResult result = function(parent, &info, nullptr, &handle);
  if (result != VK_SUCCESS)
    handle = VK_NULL_HANDLE;
  return result;
}

} // namespace lichen
