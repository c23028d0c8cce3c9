// SPDX-License-Identifier: MIT
// Allocates device memory from the host's allocator, or in blocks of the plugin's own.
#include "abi.h"
#include "vulkan_objects.h"

namespace lichen::plugin {
namespace {

/// The properties that an ordinary memory type may have. Others are slow (AMD's device-coherent
/// memory), need a feature (protected) or cannot be the target of copies (lazily allocated).
constexpr VkMemoryPropertyFlags kOrdinaryMemory =
    VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
    VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

VkMemoryPropertyFlags propertiesOf(MemoryUse use) {
  return use == MemoryUse::staging
             ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
             : VkMemoryPropertyFlags(VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
}

const char* nameOf(MemoryUse use) {
  switch (use) {
  case MemoryUse::images:
    return "memory for the images";
  case MemoryUse::constants:
    return "memory for the noises' constants";
  default:
    return "memory for the staging buffer";
  }
}

/// Allocates one block, and maps it for staging. On failure, nothing stays allocated.
VkResult allocateBlock(const LichenVulkanContext_T& context, const VkMemoryAllocateInfo& info,
                       MemoryUse use, LichenDeviceMemory& block) {
  const LichenVulkanFunctions& f = context.functions;
  VkResult result = create(context, f.allocateMemory, info, block.memory);
  if (result != VK_SUCCESS || use != MemoryUse::staging)
    return result;
  result = f.mapMemory(context.device, block.memory, 0, VK_WHOLE_SIZE, 0, &block.mapped);
  if (result != VK_SUCCESS)
    f.freeMemory(context.device, block.memory, context.callbacks);
  return result;
}

LichenResult allocateOwn(const LichenVulkanContext_T& context,
                         const VkMemoryRequirements& requirements, MemoryUse use,
                         std::optional<LichenDeviceMemory>& memory, LichenDiagnostic* diagnostic) {
  const VkMemoryPropertyFlags needed = propertiesOf(use);
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = requirements.size;
  VkResult firstFailure = VK_SUCCESS; // of the best type, which drivers list first
  for (std::uint32_t type = 0; type < context.memory.memoryTypeCount; ++type) {
    const VkMemoryPropertyFlags has = context.memory.memoryTypes[type].propertyFlags;
    if ((requirements.memoryTypeBits & (1u << type)) == 0 || (has & needed) != needed ||
        (has & ~kOrdinaryMemory) != 0)
      continue;
    info.memoryTypeIndex = type;
    LichenDeviceMemory block;
    LICHEN_INIT(block, LICHEN_STRUCTURE_DEVICE_MEMORY);
    const VkResult result = allocateBlock(context, info, use, block);
    if (result == VK_SUCCESS) {
      memory = block;
      return LICHEN_SUCCESS;
    }
    if (firstFailure == VK_SUCCESS)
      firstFailure = result;
    // Try the next type: its heap may have room, or it may be mappable.
  }
  if (firstFailure != VK_SUCCESS)
    return vulkanFailure(nameOf(use), firstFailure, diagnostic);
  writeDiagnostic(
      diagnostic,
      "%s: the device has no ordinary memory type with VkMemoryPropertyFlags 0x%x among the "
      "suitable types 0x%x",
      nameOf(use), needed, requirements.memoryTypeBits);
  return LICHEN_ERROR_UNSUPPORTED;
}

LichenResult allocateByHost(const LichenVulkanContext_T& context,
                            const VkMemoryRequirements& requirements, MemoryUse use,
                            std::optional<LichenDeviceMemory>& memory,
                            LichenDiagnostic* diagnostic) {
  LichenMemoryRequest request;
  LICHEN_INIT(request, LICHEN_STRUCTURE_MEMORY_REQUEST);
  request.requirements = requirements;
  request.properties = propertiesOf(use);
  request.optimalTiling = use == MemoryUse::images ? VK_TRUE : VK_FALSE;
  LichenDeviceMemory allocated;
  LICHEN_INIT(allocated, LICHEN_STRUCTURE_DEVICE_MEMORY);
  const VkResult result =
      context.allocator.allocate(context.allocator.userData, &request, &allocated);
  if (result != VK_SUCCESS)
    return vulkanFailure(nameOf(use), result, diagnostic);
  memory = allocated;
  if (use != MemoryUse::staging || allocated.mapped != nullptr)
    return LICHEN_SUCCESS;
  writeDiagnostic(diagnostic,
                  "deviceAllocator returned HOST_VISIBLE memory without setting `mapped`");
  return LICHEN_ERROR_USAGE;
}

} // namespace

LichenResult allocateMemory(const LichenVulkanContext_T& context,
                            const VkMemoryRequirements& requirements, MemoryUse use,
                            std::optional<LichenDeviceMemory>& memory,
                            LichenDiagnostic* diagnostic) {
  return context.hostAllocates ? allocateByHost(context, requirements, use, memory, diagnostic)
                               : allocateOwn(context, requirements, use, memory, diagnostic);
}

void releaseMemory(const LichenVulkanContext_T& context,
                   std::optional<LichenDeviceMemory>& memory) noexcept {
  if (!memory)
    return;
  const LichenDeviceMemory released = *memory;
  memory.reset();
  if (!context.hostAllocates)
    return context.functions.freeMemory(context.device, released.memory, context.callbacks);
  try {
    context.allocator.release(context.allocator.userData, &released);
  } catch (...) { // it must not throw, and there is no way to report it
  }
}

} // namespace lichen::plugin
