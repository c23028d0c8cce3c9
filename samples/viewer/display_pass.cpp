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
  set_ = objects_.set(objects_.pool(1, kTypes), setLayout_);
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

const DeviceImage& DisplayPass::record(VkCommandBuffer commands, const DeviceImage& sum,
                                       std::uint32_t frames) {
  const VkExtent3D extent = sum.info.extent;
  if (picture_.info.extent.width != extent.width || picture_.info.extent.height != extent.height ||
      picture_.handle == VK_NULL_HANDLE) {
    DeviceImageInfo info;
    info.format = VK_FORMAT_R8G8B8A8_UNORM;
    info.extent = extent;
    info.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    picture_ = take(device_.createImage(info));
  }
  writeSet(device_.device(), set_, std::array{storageImage(sum.view), storageImage(picture_.view)});
  transition(commands, sum, kStorage, kStorage);
  transition(commands, picture_, kUndefined, kStorage);
  const auto divisor = float(frames);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0,
                          nullptr);
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof divisor, &divisor);
  vkCmdDispatch(commands, (extent.width + kGroup - 1) / kGroup,
                (extent.height + kGroup - 1) / kGroup, 1);
  transition(commands, picture_, kStorage, kCopySource);
  return picture_;
}

} // namespace lichen::renderer
