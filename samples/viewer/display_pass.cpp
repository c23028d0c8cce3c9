// SPDX-License-Identifier: MIT
// The compute pass of display.comp and its output image.
#include "display_pass.h"

#include "failure.h"

#include <array>
#include <display.comp.h>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kGroup = 8; // local size in display.comp
constexpr std::array kTypes{VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};

} // namespace

DisplayPass::DisplayPass(VulkanDevice& device) : device_(device), objects_(device.device()) {
  setLayout_ = objects_.setLayout(kTypes, VK_SHADER_STAGE_COMPUTE_BIT);
  const VkDescriptorPool pool = objects_.pool(kFramesInFlight, kTypes);
  for (VkDescriptorSet& set : sets_)
    set = objects_.set(pool, setLayout_);
  layout_ = objects_.pipelineLayout(std::span(&setLayout_, 1), VK_SHADER_STAGE_COMPUTE_BIT,
                                    sizeof(float));
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = objects_.shader(display_comp);
  info.stage.pName = "main";
  info.layout = layout_;
  pipeline_ = objects_.computePipeline(info);
}

const DeviceImage& DisplayPass::record(const FrameCommands& frame, const DeviceImage& sum,
                                       std::uint32_t frames) {
  DeviceImage& picture = pictures_[frame.slot];
  const VkExtent3D extent = sum.info.extent;
  if (picture.info.extent.width != extent.width || picture.info.extent.height != extent.height ||
      picture.handle == VK_NULL_HANDLE) {
    DeviceImageInfo info;
    info.format = VK_FORMAT_R8G8B8A8_UNORM;
    info.extent = extent;
    info.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    picture = take(device_.createImage(info));
  }
  writeSet(device_.device(), sets_[frame.slot],
           std::array{storageImage(sum.view), storageImage(picture.view)});
  transition(frame.buffer, sum, kStorage, kStorage);
  transition(frame.buffer, picture, kUndefined, kStorage);
  const auto divisor = float(frames);
  vkCmdBindPipeline(frame.buffer, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(frame.buffer, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1,
                          &sets_[frame.slot], 0, nullptr);
  vkCmdPushConstants(frame.buffer, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof divisor,
                     &divisor);
  vkCmdDispatch(frame.buffer, (extent.width + kGroup - 1) / kGroup,
                (extent.height + kGroup - 1) / kGroup, 1);
  transition(frame.buffer, picture, kStorage, kCopySource);
  return picture;
}

} // namespace lichen::renderer
