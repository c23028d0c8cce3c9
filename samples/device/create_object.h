// SPDX-License-Identifier: MIT
// Creates Vulkan objects, with a defined handle on failure.
#pragma once

#include <volk.h>

namespace lichen {

/// Calls a vkCreate function. On failure Vulkan leaves the handle undefined [Vulkan, Return Codes],
/// so this sets it to null: destructors may then destroy it safely.
template <class Function, class Parent, class Info, class Handle>
VkResult createObject(Function function, Parent parent, const Info& info, Handle& handle) {
  const VkResult result = function(parent, &info, nullptr, &handle);
  if (result != VK_SUCCESS)
    handle = VK_NULL_HANDLE;
  return result;
}

} // namespace lichen
