// SPDX-License-Identifier: MIT
// Proxies between the plugin and the device: the table of Vulkan functions, a table that counts and
// fails on demand, and a host allocator.
#pragma once

#include <lichen/lichen_vulkan.h>
#include <lichen/vulkan_device.h>

#include <cstring>

namespace lichen::test {

/// The functions that a host without volk loads one by one.
[[nodiscard]] LichenVulkanFunctions loadedFunctions();

/// Counts objects that a function table creates and destroys, and fails the n-th call that may
/// fail. A failed call leaves garbage in its output, as Vulkan allows.
struct Proxy {
  static inline int untilFailure = 0; ///< counts down while positive
  /// Set after a failed allocation or mapping: all later allocations of any type fail as well.
  static inline bool exhausted = false;
  static inline int alive = 0;            ///< created and not yet destroyed
  static inline int garbageDestroyed = 0; ///< outputs of failed calls that were destroyed
  /// Called before and after each real function.
  static inline void (*enter)() = [] {};
  static inline void (*leave)() = [] {};

  [[nodiscard]] static LichenVulkanFunctions functions();

  static bool fails() { return untilFailure > 0 && --untilFailure == 0; }

  struct Inside {
    Inside() { enter(); }
    ~Inside() { leave(); }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
  };

  template <class Output>
  static void fillWithGarbage(Output* output) {
    constexpr int kGarbage = 0xA5;
    std::memset(static_cast<void*>(output), kGarbage, sizeof *output);
  }
  template <class Handle>
  static bool isGarbage(Handle handle) {
    Handle garbage;
    fillWithGarbage(&garbage);
    return handle == garbage;
  }

  /// Wraps a creating function.
  template <auto* kFunction, class Info, class Handle>
  static VkResult VKAPI_CALL create(VkDevice device, const Info* info,
                                    const VkAllocationCallbacks* callbacks, Handle* handle) {
    if (fails()) {
      fillWithGarbage(handle);
      return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    const Inside inside;
    const VkResult result = (*kFunction)(device, info, callbacks, handle);
    alive += result == VK_SUCCESS ? 1 : 0;
    return result;
  }
  /// Wraps a destroying function; does not count null handles.
  template <auto* kFunction, class Handle>
  static void VKAPI_CALL destroy(VkDevice device, Handle handle,
                                 const VkAllocationCallbacks* callbacks) {
    if (isGarbage(handle)) {
      ++garbageDestroyed;
      return;
    }
    const Inside inside;
    (*kFunction)(device, handle, callbacks);
    alive -= handle != VK_NULL_HANDLE ? 1 : 0;
  }
  /// Wraps a function that may fail but creates nothing.
  template <auto* kFunction, class... Arguments>
  static VkResult VKAPI_CALL call(Arguments... arguments) {
    if (fails())
      return VK_ERROR_OUT_OF_HOST_MEMORY;
    const Inside inside;
    return (*kFunction)(arguments...);
  }
  /// Wraps a function that cannot fail.
  template <auto* kFunction, class... Arguments>
  static void VKAPI_CALL pass(Arguments... arguments) {
    const Inside inside;
    (*kFunction)(arguments...);
  }
  static VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                      const VkAllocationCallbacks* callbacks,
                                      VkDeviceMemory* memory);
  static VkResult VKAPI_CALL map(VkDevice device, VkDeviceMemory memory, VkDeviceSize offset,
                                 VkDeviceSize size, VkMemoryMapFlags flags, void** data);
  static VkResult VKAPI_CALL allocateSets(VkDevice device, const VkDescriptorSetAllocateInfo* info,
                                          VkDescriptorSet* sets);
};

/// A host allocator: one VkDeviceMemory per request, at an offset.
struct HostMemory {
  explicit HostMemory(VulkanDevice& d);
  HostMemory(const HostMemory&) = delete;
  HostMemory& operator=(const HostMemory&) = delete;

  VulkanDevice& device;
  int alive = 0;
  int untilFailure = 0;
  LichenDeviceAllocator callbacks;

private:
  static VkResult allocate(void* userData, const LichenMemoryRequest* request,
                           LichenDeviceMemory* memory);
  static void release(void* userData, const LichenDeviceMemory* memory);
};

} // namespace lichen::test
