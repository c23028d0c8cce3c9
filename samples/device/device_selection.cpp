// SPDX-License-Identifier: MIT
// Instance creation, the choice of a physical device, and device creation.
#include "create_object.h"

#include <lichen/vulkan_device.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <string_view>
#include <tuple>
#include <utility>

namespace lichen {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL collectMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                              VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* data,
                                              void* messages) {
  static_cast<ValidationMessages*>(messages)->add(
      (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0, data->pMessage);
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationMessages& messages) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                     VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = collectMessage;
  info.pUserData = &messages;
  return info;
}

Error noDevice() {
  return {ErrorKind::environment, "no Vulkan device: install a driver, such as "
                                  "mesa-vulkan-drivers (its lavapipe needs no GPU)"};
}

bool hasLayer(const char* name) {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [&](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, name) == 0;
  });
}

Result<void> loadVulkan() {
  if (volkInitialize() != VK_SUCCESS)
    return Error{ErrorKind::environment,
                 "no Vulkan loader (libvulkan.so.1): install libvulkan1 and a driver, such as "
                 "mesa-vulkan-drivers"};
  if (volkGetInstanceVersion() < VK_API_VERSION_1_3)
    return Error{ErrorKind::environment, "the Vulkan loader is older than 1.3: install a newer "
                                         "libvulkan1"};
  return {};
}

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance) {
  std::uint32_t count = 0;
  // Without a driver, some loaders return an error here instead of zero devices.
  if (vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS)
    return {};
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  devices.resize(count);
  return devices;
}

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

/// Rank of a device type; lower is better.
int preference(VkPhysicalDeviceType type) {
  switch (type) {
  case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
    return 0;
  case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
    return 1;
  case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
    return 2;
  default:
    return 3;
  }
}

/// Index of the device to use, or `devices.size()` when `choice` matches none.
std::size_t findChoice(const std::vector<VkPhysicalDeviceProperties>& devices,
                       const std::vector<bool>& haveQueue, const std::string& choice) {
  if (choice.empty()) {
    // Devices that are too old rank last, those without a usable queue second to last, whatever
    // their type.
    const auto rank = [&](std::size_t i) {
      return std::tuple(devices[i].apiVersion < VK_API_VERSION_1_3, !haveQueue[i],
                        preference(devices[i].deviceType));
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < devices.size(); ++i)
      if (rank(i) < rank(best))
        best = i;
    return best;
  }
  std::size_t index = 0;
  const char* end = choice.data() + choice.size();
  if (const auto parsed = std::from_chars(choice.data(), end, index);
      parsed.ec == std::errc() && parsed.ptr == end && index < devices.size())
    return index;
  const std::string lowerChoice = lowered(choice);
  return std::size_t(std::find_if(devices.begin(), devices.end(),
                                  [&](const auto& device) {
                                    return lowered(device.deviceName).find(lowerChoice) !=
                                           std::string::npos;
                                  }) -
                     devices.begin());
}

/// Index of a queue family with graphics and compute (both imply transfer) that can present if
/// options.canPresent asks for it; -1 if there is none.
int queueFamilyOf(VkInstance instance, VkPhysicalDevice device,
                  const VulkanDeviceOptions& options) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  constexpr VkQueueFlags kRequired = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (std::uint32_t i = 0; i < count; ++i)
    if ((families[i].queueFlags & kRequired) == kRequired &&
        (!options.canPresent || options.canPresent(instance, device, i)))
      return int(i);
  return -1;
}

} // namespace

Result<void> VulkanDevice::createInstance(const VulkanDeviceOptions& options) {
  if (Result<void> loaded = loadVulkan(); !loaded)
    return loaded;
  if (options.validation && !hasLayer(kValidationLayer))
    return Error{ErrorKind::environment, "no " + std::string(kValidationLayer) +
                                             ": install vulkan-validationlayers, or run without "
                                             "validation"};
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "lichen";
  application.apiVersion = VK_API_VERSION_1_3;

  std::vector<const char*> extensions = options.instanceExtensions;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  const VkValidationFeatureEnableEXT enabled =
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &enabled;
  VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(*messages_);
  if (options.validation) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
    features.pNext = &messenger;
    info.pNext = &features;
  }
  info.enabledExtensionCount = std::uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) // the loader's answer when it finds no driver
    return noDevice();
  if (result != VK_SUCCESS)
    return vulkanError("cannot create a Vulkan instance", result);
  // volkLoadDevice would load the entry points of one device, which do not serve another device.
  volkLoadInstance(instance_);
  if (options.validation) {
    destroyMessenger_ = vkDestroyDebugUtilsMessengerEXT;
    messenger.pNext = nullptr;
    if (const VkResult created =
            createObject(vkCreateDebugUtilsMessengerEXT, instance_, messenger, messenger_);
        created != VK_SUCCESS)
      return vulkanError("cannot receive validation messages", created);
  }
  return {};
}

Result<void> VulkanDevice::chooseDevice(const VulkanDeviceOptions& options) {
  const std::vector<VkPhysicalDevice> handles = physicalDevices(instance_);
  if (handles.empty())
    return noDevice();
  std::vector<VkPhysicalDeviceProperties> devices(handles.size());
  std::vector<bool> haveQueue;
  std::string names;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    vkGetPhysicalDeviceProperties(handles[i], &devices[i]);
    haveQueue.push_back(queueFamilyOf(instance_, handles[i], options) >= 0);
    names += (i ? ", " : "") + std::string("\"") + devices[i].deviceName + "\" (index " +
             std::to_string(i) + ")";
  }
  const std::size_t index = findChoice(devices, haveQueue, options.choice);
  if (index == devices.size())
    return Error{ErrorKind::usage, "--device " + options.choice +
                                       ": no such Vulkan device; this machine has " + names};
  if (devices[index].apiVersion < VK_API_VERSION_1_3)
    return Error{ErrorKind::environment,
                 "Vulkan device \"" + std::string(devices[index].deviceName) +
                     "\" is older than Vulkan 1.3; this machine has " + names};
  physicalDevice_ = handles[index];
  properties_ = devices[index];
  return {};
}

Result<void> VulkanDevice::createDevice(const VulkanDeviceOptions& options) {
  const std::string device = "Vulkan device \"" + std::string(properties_.deviceName) + "\"";
  const int family = queueFamilyOf(instance_, physicalDevice_, options);
  if (family < 0)
    return Error{ErrorKind::environment,
                 device + " has no queue for graphics and compute" +
                     (options.canPresent ? " that presents to this display" : "")};
  queueFamily_ = std::uint32_t(family);
  VkPhysicalDeviceFeatures available{};
  vkGetPhysicalDeviceFeatures(physicalDevice_, &available);
  VkPhysicalDeviceFeatures features{};
  features.fullDrawIndexUint32 = available.fullDrawIndexUint32;

  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queueFamily_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceVulkan13Features features13{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  features13.dynamicRendering = VK_TRUE;
  features13.synchronization2 = VK_TRUE;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &features13;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.pEnabledFeatures = &features;
  info.enabledExtensionCount = std::uint32_t(options.deviceExtensions.size());
  info.ppEnabledExtensionNames = options.deviceExtensions.data();
  if (const VkResult result = createObject(vkCreateDevice, physicalDevice_, info, device_);
      result != VK_SUCCESS)
    return vulkanError(device + " cannot be opened", result);
  vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = queueFamily_;
  VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkResult result = createObject(vkCreateCommandPool, device_, pool, commandPool_);
  if (result == VK_SUCCESS)
    result = createObject(vkCreateFence, device_, fence, fence_);
  if (result != VK_SUCCESS)
    return vulkanError(device + ": cannot create a command pool", result);
  return {};
}

Result<std::unique_ptr<VulkanDevice>> VulkanDevice::create(const VulkanDeviceOptions& options) {
  std::unique_ptr<VulkanDevice> device(new VulkanDevice);
  if (Result<void> result = device->createInstance(options); !result)
    return result.error();
  if (Result<void> result = device->chooseDevice(options); !result)
    return result.error();
  if (Result<void> result = device->createDevice(options); !result)
    return result.error();
  return device;
}

Result<std::vector<std::string>> VulkanDevice::listDevices() {
  VulkanDevice device;
  if (Result<void> result = device.createInstance({}); !result)
    return result.error();
  std::vector<std::string> names;
  for (const VkPhysicalDevice handle : physicalDevices(device.instance_)) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(handle, &properties);
    names.emplace_back(properties.deviceName);
  }
  return names;
}

VulkanDevice::~VulkanDevice() {
  if (device_ != VK_NULL_HANDLE) {
    vkDeviceWaitIdle(device_);
    vkDestroyFence(device_, fence_, nullptr);
    vkDestroyCommandPool(device_, commandPool_, nullptr);
    vkDestroyDevice(device_, nullptr);
  }
  if (messenger_ != VK_NULL_HANDLE)
    destroyMessenger_(instance_, messenger_, nullptr);
  if (instance_ != VK_NULL_HANDLE)
    vkDestroyInstance(instance_, nullptr);
}

} // namespace lichen
