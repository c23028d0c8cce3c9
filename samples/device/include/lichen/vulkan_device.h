// SPDX-License-Identifier: MIT
// A Vulkan 1.3 instance and device, with or without a window, for the renderer, the GPU tests and
// the benchmark: device choice, validation messages, plain buffers and images, one-shot submits and
// readback. Vulkan's own functions come from volk.
#pragma once

#include <lichen/result.h>

#include <volk.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace lichen {

struct VulkanDeviceOptions {
  /// An index into listDevices(), or a part of a name (case-insensitive). Empty: the first discrete
  /// GPU, else the first integrated, virtual, or CPU device, of those that can present where that
  /// is asked for.
  std::string choice;
  bool validation = false; ///< the Khronos layer, with synchronization validation
  /// Core features that must be there. dynamicRendering and synchronization2 always are, and
  /// fullDrawIndexUint32 where the device has it: limits.maxDrawIndexedIndexValue holds as it is.
  VkPhysicalDeviceFeatures features{};
  std::vector<const char*> instanceExtensions;
  std::vector<const char*> deviceExtensions;
  /// Of a program with a window, which brings the extensions too: whether a queue family presents
  /// to its window system. Null: nothing is presented.
  std::function<bool(VkInstance, VkPhysicalDevice, std::uint32_t queueFamily)> canPresent;
};

/// What the validation layers said. Thread-safe.
class ValidationMessages {
public:
  void add(bool isError, std::string text);
  void clear();
  [[nodiscard]] std::size_t errors() const;
  [[nodiscard]] std::size_t warnings() const;
  [[nodiscard]] std::vector<std::string> texts() const;

private:
  mutable std::mutex mutex_;
  std::size_t errors_ = 0;
  std::vector<std::string> texts_;
};

class VulkanDevice;

/// A buffer with memory of its own, freed with it; must not outlive its device.
class DeviceBuffer {
public:
  DeviceBuffer() = default;
  DeviceBuffer(DeviceBuffer&& other) noexcept { *this = std::move(other); }
  DeviceBuffer& operator=(DeviceBuffer&& other) noexcept;
  ~DeviceBuffer() { reset(); }
  void reset();

  VkBuffer handle = VK_NULL_HANDLE;
  VkDeviceSize size = 0;
  std::byte* mapped = nullptr; ///< coherent, for the buffer's whole life; null when device-local

private:
  friend class VulkanDevice;
  VkDevice device_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  std::uint32_t* allocations_ = nullptr; ///< of the device, which counts this memory
};

struct DeviceImageInfo {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent3D extent{1, 1, 1}; ///< a 3-D image when depth > 1
  std::uint32_t mipLevels = 1;
  std::uint32_t layers = 1;
  VkImageUsageFlags usage = 0;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT; ///< of the view
  VkImageViewType viewType = VK_IMAGE_VIEW_TYPE_2D;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  VkImageCreateFlags flags = 0;
};

/// An optimally tiled, device-local image and a view of all of it; must not outlive its device.
class DeviceImage {
public:
  DeviceImage() = default;
  DeviceImage(DeviceImage&& other) noexcept { *this = std::move(other); }
  DeviceImage& operator=(DeviceImage&& other) noexcept;
  ~DeviceImage() { reset(); }
  void reset();

  VkImage handle = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  DeviceImageInfo info;

private:
  friend class VulkanDevice;
  VkDevice device_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  std::uint32_t* allocations_ = nullptr; ///< of the device, which counts this memory
};

/// One device with one queue for graphics, compute and transfer. Not thread-safe, but several may
/// exist: volk holds the loader's own entry points, which serve every device (those of extensions
/// only where the device created last enabled them).
class VulkanDevice {
public:
  /// Errors: environment without a loader, device, layer, feature or extension; usage when `choice`
  /// names none. The message lists the devices there are.
  [[nodiscard]] static Result<std::unique_ptr<VulkanDevice>>
  create(const VulkanDeviceOptions& options);
  /// Names of the machine's Vulkan devices, in the loader's order.
  [[nodiscard]] static Result<std::vector<std::string>> listDevices();

  ~VulkanDevice();
  VulkanDevice(const VulkanDevice&) = delete;
  VulkanDevice& operator=(const VulkanDevice&) = delete;

  [[nodiscard]] VkInstance instance() const { return instance_; }
  [[nodiscard]] VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
  [[nodiscard]] VkDevice device() const { return device_; }
  [[nodiscard]] VkQueue queue() const { return queue_; }
  [[nodiscard]] std::uint32_t queueFamily() const { return queueFamily_; }
  [[nodiscard]] const VkPhysicalDeviceProperties& properties() const { return properties_; }
  [[nodiscard]] ValidationMessages& messages() { return *messages_; }
  /// The same, to be read after the device's end, which may add to them.
  [[nodiscard]] std::shared_ptr<const ValidationMessages> keptMessages() const { return messages_; }

  /// `hostVisible` memory is mapped and coherent; otherwise the buffer is device-local. Errors, of
  /// images too: resources when memory or limits.maxMemoryAllocationCount is exhausted.
  [[nodiscard]] Result<DeviceBuffer> createBuffer(VkDeviceSize size, VkBufferUsageFlags usage,
                                                  bool hostVisible);
  [[nodiscard]] Result<DeviceImage> createImage(const DeviceImageInfo& info);

  /// Records with `record` into a fresh primary command buffer, submits it and waits for its end.
  [[nodiscard]] Result<void> submit(const std::function<void(VkCommandBuffer)>& record);

  /// Level 0 of layer 0, tightly packed. The image has TRANSFER_SRC usage and is in `layout`, to
  /// which it returns; `texelBytes` is the size of one texel of the view's aspect.
  [[nodiscard]] Result<std::vector<std::byte>>
  readImage(const DeviceImage& image, VkImageLayout layout, std::size_t texelBytes);

private:
  VulkanDevice() = default;
  [[nodiscard]] Result<void> createInstance(const VulkanDeviceOptions& options);
  [[nodiscard]] Result<void> chooseDevice(const VulkanDeviceOptions& options);
  [[nodiscard]] Result<void> createDevice(const VulkanDeviceOptions& options);
  [[nodiscard]] Result<VkDeviceMemory> allocate(const VkMemoryRequirements& requirements,
                                                VkMemoryPropertyFlags wanted);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  PFN_vkDestroyDebugUtilsMessengerEXT destroyMessenger_ = nullptr;
  VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t queueFamily_ = 0;
  VkCommandPool commandPool_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  std::uint32_t allocations_ = 0; ///< that live
  std::shared_ptr<ValidationMessages> messages_ = std::make_shared<ValidationMessages>();
};

/// An Error for a failed Vulkan call: resources for exhausted memory, else environment.
[[nodiscard]] Error vulkanError(const std::string& what, VkResult result);

} // namespace lichen
