// SPDX-License-Identifier: MIT
// A Vulkan 1.3 instance and device for the renderer, the GPU tests and the benchmark, with or
// without a window. Chooses the device, collects validation messages, creates plain buffers and
// images, submits work once and reads images back. Vulkan's functions come from volk.
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

/// dynamicRendering and synchronization2 are always enabled, and fullDrawIndexUint32 where the
/// device supports it: limits.maxDrawIndexedIndexValue applies unreduced.
struct VulkanDeviceOptions {
  /// An index into listDevices(), or part of a device name (case-insensitive). If empty, the first
  /// discrete GPU is used, else the first integrated GPU, virtual GPU or CPU device. With
  /// canPresent set, only devices that can present are considered.
  std::string choice;
  bool validation = false; ///< enables the Khronos layer with synchronization validation
  std::vector<const char*> instanceExtensions;
  std::vector<const char*> deviceExtensions;
  /// Returns whether a queue family can present to the program's window system. A program with a
  /// window sets it, together with the extensions above. Null: the program presents nothing.
  std::function<bool(VkInstance, VkPhysicalDevice, std::uint32_t queueFamily)> canPresent;
};

/// Messages of the validation layers. Thread-safe.
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

/// A buffer with its own memory, which it frees. Must not outlive its device.
class DeviceBuffer {
public:
  DeviceBuffer() = default;
  DeviceBuffer(DeviceBuffer&& other) noexcept { *this = std::move(other); }
  DeviceBuffer& operator=(DeviceBuffer&& other) noexcept;
  ~DeviceBuffer() { reset(); }
  void reset();

  VkBuffer handle = VK_NULL_HANDLE;
  VkDeviceSize size = 0;
  /// coherent and mapped for the buffer's lifetime; null when device-local
  std::byte* mapped = nullptr;

private:
  friend class VulkanDevice;
  VkDevice device_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  std::uint32_t* allocations_ = nullptr; ///< the device's allocation count
};

struct DeviceImageInfo {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent3D extent{1, 1, 1}; ///< a 3-D image when depth > 1
  std::uint32_t mipLevels = 1;
  std::uint32_t layers = 1;
  VkImageUsageFlags usage = 0;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT; ///< aspect of the view
  VkImageViewType viewType = VK_IMAGE_VIEW_TYPE_2D;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  VkImageCreateFlags flags = 0;
};

/// An optimally tiled, device-local image with a view of the whole image. Must not outlive its
/// device.
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
  std::uint32_t* allocations_ = nullptr; ///< the device's allocation count
};

/// One device with one queue for graphics, compute and transfer. Not thread-safe. Several devices
/// may exist at once: volk holds the loader's entry points, which serve every device. Extension
/// entry points work only if the most recently created device enabled the extension.
class VulkanDevice {
public:
  /// Errors: environment if the loader, device, layer, feature or extension is missing; usage if
  /// `choice` matches no device. The message lists the available devices.
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
  /// The messages, shared so that a caller can read those that device destruction adds.
  [[nodiscard]] std::shared_ptr<const ValidationMessages> keptMessages() const { return messages_; }

  /// If `hostVisible`, the memory is mapped and coherent; otherwise it is device-local. Errors of
  /// createBuffer() and createImage(): resources when memory or limits.maxMemoryAllocationCount is
  /// exhausted.
  [[nodiscard]] Result<DeviceBuffer> createBuffer(VkDeviceSize size, VkBufferUsageFlags usage,
                                                  bool hostVisible);
  [[nodiscard]] Result<DeviceImage> createImage(const DeviceImageInfo& info);

  /// Calls `record` with a new primary command buffer, submits the buffer and waits until it has
  /// finished.
  [[nodiscard]] Result<void> submit(const std::function<void(VkCommandBuffer)>& record);

  /// Level 0 of layer 0, tightly packed. The image must have TRANSFER_SRC usage and be in `layout`;
  /// it is in `layout` again afterwards. `texelBytes` is the size of one texel of the view's
  /// aspect.
  [[nodiscard]] Result<std::vector<std::byte>>
  readImage(const DeviceImage& image, VkImageLayout layout, std::size_t texelBytes);

private:
  VulkanDevice() = default;
  [[nodiscard]] Result<void> createInstance(const VulkanDeviceOptions& options);
  [[nodiscard]] Result<void> chooseDevice(const VulkanDeviceOptions& options);
  [[nodiscard]] Result<void> createDevice(const VulkanDeviceOptions& options);
  [[nodiscard]] Result<VkDeviceMemory> allocate(const VkMemoryRequirements& requirements,
                                                VkMemoryPropertyFlags required);

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
  std::uint32_t allocations_ = 0; ///< currently live
  std::shared_ptr<ValidationMessages> messages_ = std::make_shared<ValidationMessages>();
};

/// An Error for a failed Vulkan call: resources for exhausted memory, else environment.
[[nodiscard]] Error vulkanError(const std::string& what, VkResult result);

} // namespace lichen
