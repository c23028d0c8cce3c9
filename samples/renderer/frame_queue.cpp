// SPDX-License-Identifier: MIT
// One fence a slot, for which timeline semaphores would do as well: Debian's validation layers hang
// on those.
#include "frame_queue.h"

#include "failure.h"

#include <algorithm>

namespace lichen::renderer {

FrameQueue::FrameQueue(VulkanDevice& device) : device_(device), objects_(device.device()) {
  const VkCommandPool pool = objects_.commandPool(device.queueFamily());
  for (Slot& slot : slots_)
    slot = {objects_.commandBuffer(pool), objects_.fence(), objects_.semaphore(), 0};
}

FrameQueue::~FrameQueue() { vkDeviceWaitIdle(device_.device()); }

bool FrameQueue::isFree(Slot& slot, bool waits) {
  if (slot.frame == 0)
    return true;
  const VkResult result =
      vkWaitForFences(device_.device(), 1, &slot.fence, VK_TRUE, waits ? UINT64_MAX : 0);
  if (result == VK_TIMEOUT)
    return false;
  check(result, "cannot wait for a frame");
  check(vkResetFences(device_.device(), 1, &slot.fence), "cannot reset a fence");
  slot.frame = 0;
  return true;
}

void FrameQueue::waitForSlot() {
  std::uint64_t completed = submitted_;
  for (Slot& other : slots_)
    if (!isFree(other, &other == &slots_[slot()]))
      completed = std::min(completed, other.frame - 1);
  while (!retired_.empty() && retired_.front().first <= completed)
    retired_.pop_front();
}

FrameCommands FrameQueue::begin() {
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  const VkCommandBuffer commands = slots_[slot()].commands;
  check(vkBeginCommandBuffer(commands, &info), "cannot begin a command buffer");
  return {commands, slot()};
}

void FrameQueue::submit() { submit(VkSubmitInfo2{VK_STRUCTURE_TYPE_SUBMIT_INFO_2}); }

void FrameQueue::submit(VkPipelineStageFlags2 stages, VkSemaphore presentable) {
  VkSemaphoreSubmitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  wait.semaphore = acquired();
  wait.stageMask = stages;
  VkSemaphoreSubmitInfo signal{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  signal.semaphore = presentable;
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT; // includes the last layout transition
  VkSubmitInfo2 info{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  info.waitSemaphoreInfoCount = info.signalSemaphoreInfoCount = 1;
  info.pWaitSemaphoreInfos = &wait;
  info.pSignalSemaphoreInfos = &signal;
  submit(info);
}

void FrameQueue::submit(VkSubmitInfo2 info) {
  Slot& used = slots_[slot()];
  check(vkEndCommandBuffer(used.commands), "cannot end a command buffer");
  VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  commands.commandBuffer = used.commands;
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &commands;
  check(vkQueueSubmit2(device_.queue(), 1, &info, used.fence), "cannot submit a frame");
  used.frame = ++submitted_;
}

} // namespace lichen::renderer
