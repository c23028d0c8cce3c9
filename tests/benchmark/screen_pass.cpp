// SPDX-License-Identifier: MIT
// One full-screen draw with dynamic rendering; see screen_pass.h.
#include "screen_pass.h"

#include <array>
#include <stdexcept>
#include <vector>

namespace lichen::bench {
namespace {

void require(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(vulkanError(what, result).message);
}

VkShaderModule shaderModule(VkDevice device, std::span<const std::uint32_t> code) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  VkShaderModule module = VK_NULL_HANDLE;
  require(vkCreateShaderModule(device, &info, nullptr, &module), "a shader");
  return module;
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = which;
  info.module = module;
  info.pName = "main";
  return info;
}

VkPipeline screenPipeline(VkDevice device, VkPipelineLayout layout, VkShaderModule vertex,
                          VkShaderModule fragment) {
  const std::array stages{stage(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                          stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
  const VkPipelineVertexInputStateCreateInfo vertices{
      VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.lineWidth = 1.0f;
  VkPipelineMultisampleStateCreateInfo samples{
      VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState attachment{};
  attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                              VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  VkPipelineColorBlendStateCreateInfo blend{
      VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = 1;
  blend.pAttachments = &attachment;
  const std::array dynamics{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = std::uint32_t(dynamics.size());
  dynamic.pDynamicStates = dynamics.data();
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachmentFormats = &kScreenFormat;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.pNext = &rendering;
  info.stageCount = std::uint32_t(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &vertices;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  require(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "a pipeline");
  return pipeline;
}

void toColorAttachment(VkCommandBuffer commands, const DeviceImage& image) {
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  barrier.newLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.handle;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT,
                       VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0, 0, nullptr, 0, nullptr, 1,
                       &barrier);
}

} // namespace

ScreenPipeline::ScreenPipeline(VkDevice device, std::span<const std::uint32_t> vertex,
                               std::span<const std::uint32_t> fragment,
                               VkDescriptorSetLayout layout)
    : device_(device) {
  const VkPushConstantRange push{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(ScreenView)};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &layout;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &push;
  require(vkCreatePipelineLayout(device, &info, nullptr, &layout_), "a pipeline layout");
  const VkShaderModule vertexModule = shaderModule(device, vertex);
  const VkShaderModule fragmentModule = shaderModule(device, fragment);
  pipeline_ = screenPipeline(device, layout_, vertexModule, fragmentModule);
  vkDestroyShaderModule(device, vertexModule, nullptr);
  vkDestroyShaderModule(device, fragmentModule, nullptr);
}

ScreenPipeline::~ScreenPipeline() {
  vkDestroyPipeline(device_, pipeline_, nullptr);
  vkDestroyPipelineLayout(device_, layout_, nullptr);
}

ScreenPass::ScreenPass(VulkanDevice& device, std::span<const std::uint32_t> vertex,
                       std::span<const std::uint32_t> fragment, VkDescriptorSetLayout layout)
    : device_(device), pipeline_(device.device(), vertex, fragment, layout) {
  std::uint32_t count = device.queueFamily() + 1;
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device.physicalDevice(), &count, families.data());
  constexpr std::uint32_t kAllBits = 64;
  const std::uint32_t bits = families.back().timestampValidBits;
  if (bits == 0)
    throw std::runtime_error("the device's queue has no timestamps");
  ticks_ = ~std::uint64_t{0} >> (kAllBits - bits);
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = kTimestamps;
  require(vkCreateQueryPool(device.device(), &info, nullptr, &timestamps_), "a query pool");
}

ScreenPass::~ScreenPass() { vkDestroyQueryPool(device_.device(), timestamps_, nullptr); }

double ScreenPass::draw(const DeviceImage& target, VkDescriptorSet set, const ScreenView& view) {
  const VkExtent2D extent{target.info.extent.width, target.info.extent.height};
  VkRenderingAttachmentInfo attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  attachment.imageView = target.view;
  attachment.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  attachment.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = extent;
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachments = &attachment;
  const VkViewport viewport{0.0f, 0.0f, float(extent.width), float(extent.height), 0.0f, 1.0f};
  const Result<void> drawn = device_.submit([&](VkCommandBuffer commands) {
    vkCmdResetQueryPool(commands, timestamps_, 0, kTimestamps);
    toColorAttachment(commands, target);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, timestamps_, 0);
    vkCmdBeginRendering(commands, &rendering);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.handle());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.layout(), 0, 1,
                            &set, 0, nullptr);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
    vkCmdPushConstants(commands, pipeline_.layout(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof view,
                       &view);
    vkCmdDraw(commands, 4, 1, 0, 0);
    vkCmdEndRendering(commands);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, timestamps_, 1);
  });
  if (!drawn)
    throw std::runtime_error(drawn.error().message);
  std::array<std::uint64_t, kTimestamps> ticks{};
  require(vkGetQueryPoolResults(device_.device(), timestamps_, 0, kTimestamps, sizeof ticks,
                                ticks.data(), sizeof ticks[0], VK_QUERY_RESULT_64_BIT),
          "timestamps");
  return 1e-9 * double(device_.properties().limits.timestampPeriod) *
         double((ticks[1] - ticks[0]) & ticks_);
}

} // namespace lichen::bench
