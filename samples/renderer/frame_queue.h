// SPDX-License-Identifier: MIT
// Frames in flight: the host records one frame while the device draws those before it, and destroys
// an object when the last frame that uses it has completed.
#pragma once

#include "gpu_objects.h"
#include "uniform_blocks.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

namespace lichen::renderer {

/// Frames have numbers that grow from 1, and use kFramesInFlight slots in turn. The host writes to
/// a slot's data only when no frame that uses it is in flight. Functions throw a Failure.
class FrameQueue {
public:
  /// The device must outlive the queue.
  explicit FrameQueue(VulkanDevice& device);
  /// Waits for all frames and destroys what is retired.
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// Waits until no frame that uses the next slot is in flight, and destroys what was retired up to
  /// the last frame that has completed. A program that waits here before it reads the user's input
  /// shows that input soonest.
  void waitForSlot();

  /// The next slot's command buffer, to record one frame into. waitForSlot() comes before.
  [[nodiscard]] FrameCommands begin();
  /// The slot's semaphore that the window system may signal for submit() to wait for.
  [[nodiscard]] VkSemaphore acquired() const { return slots_[slot()].acquired; }
  /// Submits what was recorded after begin().
  void submit();
  /// Submits a frame that writes an acquired image in `stages`: waits for acquired() there, and
  /// signals `presentable` when the frame has completed.
  void submit(VkPipelineStageFlags2 stages, VkSemaphore presentable);

  /// Destroys the object when the device has completed all frames submitted so far. (Engines
  /// without such a queue can leave that to lichenVulkanRetireAssets.)
  void retire(std::shared_ptr<void> object) {
    retired_.emplace_back(submitted_, std::move(object));
  }

private:
  struct Slot {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    VkSemaphore acquired = VK_NULL_HANDLE;
    std::uint64_t frame = 0; ///< that uses the slot and may be in flight; 0 for none
  };

  /// The slot of the frame that is recorded next.
  [[nodiscard]] std::uint32_t slot() const { return std::uint32_t(submitted_ % kFramesInFlight); }
  /// Whether no frame that uses the slot is in flight. Waits for that if asked to.
  [[nodiscard]] bool isFree(Slot& slot, bool waits);
  void submit(VkSubmitInfo2 info);

  VulkanDevice& device_;
  ObjectOwner objects_;
  std::array<Slot, kFramesInFlight> slots_;
  std::uint64_t submitted_ = 0;                                         ///< the last frame
  std::deque<std::pair<std::uint64_t, std::shared_ptr<void>>> retired_; ///< with their last frames
};

} // namespace lichen::renderer
