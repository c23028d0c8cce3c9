// SPDX-License-Identifier: MIT
// Records one frame: depth maps for the sun and some sky directions, then surfaces and sky, then
// accumulation.
#include "failure.h"
#include "relative_to.h"
#include "scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kAccumulateGroup = 8; // local size in accumulate.comp

// Least footprint of a height in a depth map, in texels: a shadow's filter is wider.
constexpr float kDepthFootprint = 2.0f;

void beginRendering(VkCommandBuffer commands, VkExtent2D extent, VkImageView color,
                    VkImageView depth, float depthClear) {
  VkRenderingAttachmentInfo colorInfo{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  colorInfo.imageView = color;
  colorInfo.imageLayout = kColorTarget.layout;
  colorInfo.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  colorInfo.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  VkRenderingAttachmentInfo depthInfo{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  depthInfo.imageView = depth;
  depthInfo.imageLayout = kDepthTarget.layout;
  depthInfo.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  depthInfo.storeOp =
      color == VK_NULL_HANDLE ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
  depthInfo.clearValue.depthStencil = {depthClear, 0};
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = {{0, 0}, extent};
  info.layerCount = 1;
  info.colorAttachmentCount = color != VK_NULL_HANDLE ? 1 : 0;
  info.pColorAttachments = &colorInfo;
  info.pDepthAttachment = &depthInfo;
  vkCmdBeginRendering(commands, &info);
  const VkViewport viewport{0, 0, float(extent.width), float(extent.height), 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &info.renderArea);
  vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
  vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

} // namespace

void SceneRenderer::recordFrame(VkCommandBuffer commands, std::uint32_t index) {
  const FrameView view = frameView(inputs_, index);
  std::memcpy(frameData_.data(), &view.data, sizeof view.data);
  writeMaterials(scene_, noises_, gpu_);
  noises_.fillBlocks();
  recordDepthMaps(commands, view);
  recordSurfaces(commands, view);
  recordAccumulate(commands, index);
}

void SceneRenderer::drawFrame(std::uint32_t index) {
  take(device_.submit([&](VkCommandBuffer commands) { recordFrame(commands, index); }));
}

LinearImage SceneRenderer::average(std::uint32_t frames) {
  const auto bytes =
      take(device_.readImage(targets_.sum, VK_IMAGE_LAYOUT_GENERAL, sizeof(glm::vec4)));
  LinearImage image(int(inputs_.width), int(inputs_.height), 3);
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    glm::vec4 value;
    std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
    for (std::size_t c = 0; c < 3; ++c)
      image.values[3 * i + c] = value[int(c)] / float(frames);
  }
  return image;
}

void SceneRenderer::bindGeometry(VkCommandBuffer commands) const {
  const VkDeviceSize zero = 0;
  vkCmdBindVertexBuffers(commands, 0, 1, &gpu_.vertices.handle, &zero);
  if (gpu_.displacements.handle != VK_NULL_HANDLE)
    vkCmdBindVertexBuffers(commands, 1, 1, &gpu_.displacements.handle, &zero);
  vkCmdBindIndexBuffer(commands, gpu_.indices.handle, 0, VK_INDEX_TYPE_UINT32);
}

void SceneRenderer::drawPrimitive(VkCommandBuffer commands, std::size_t primitive) const {
  const GpuPrimitive& range = gpu_.primitives[primitive];
  vkCmdDrawIndexed(commands, range.indexCount, 1, range.firstIndex, range.vertexOffset, 0);
}

const Material& SceneRenderer::materialOf(const Instance& instance) const {
  return scene_.materials[scene_.primitives[instance.primitive].material];
}

bool SceneRenderer::displaces(std::size_t material) const {
  return noises_.hasNoise(material) && scene_.materials[material].displacement > 0.0f;
}

SurfaceKind SceneRenderer::kindOf(std::size_t material) const {
  const Material& properties = scene_.materials[material];
  return {noises_.hasNoise(material), properties.normalTexture.image.has_value(),
          properties.alphaMode == AlphaMode::blend, displaces(material),
          noises_.hasNoise(material) && noises_.isLayered(material)};
}

DepthKind SceneRenderer::depthKindOf(std::size_t material) const {
  const bool hasGaps = scene_.materials[material].alphaMode != AlphaMode::opaque;
  const bool moves = displaces(material);
  return {hasGaps, (hasGaps || moves) && noises_.hasNoise(material), moves};
}

/// Pushes what a displaced surface in a view of `size` pixels needs, whose heights have a footprint
/// of so many pixels.
void SceneRenderer::pushDisplaced(VkCommandBuffer commands, const glm::mat4& clipFromWorld,
                                  glm::vec2 size, float footprint,
                                  const glm::mat4& worldFromObject) const {
  const glm::mat4 rows = glm::transpose(worldFromObject);
  const shader::DisplacedData draw{
      clipFromWorld,
      {rows[0], rows[1], rows[2]},
      {footprint / pixelsPerUnit(clipFromWorld, size), 0.0f, 0.0f, 0.0f}};
  static_assert(sizeof draw == kDrawBytes);
  vkCmdPushConstants(commands, pipelines_.sceneLayout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof draw,
                     &draw);
}

void SceneRenderer::bindMaterial(VkCommandBuffer commands, VkPipelineLayout layout,
                                 std::size_t material) const {
  const std::uint32_t data = gpu_.materialData.offset(material);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, SET_MATERIAL, 1,
                          &gpu_.materialSets[material], 1, &data);
  if (!noises_.hasNoise(material))
    return;
  const VkDescriptorSet noise = noises_.set(material);
  const std::uint32_t block = noises_.dynamicOffset(material);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, SET_NOISE, 1, &noise,
                          1, &block);
}

/// The distance of displaced vertices where the subject is nearest to the camera, in world units.
float SceneRenderer::spacingOfSubject(const FrameView& view) const {
  const glm::mat4& clip = view.data.clipFromWorld;
  const glm::vec4 depth = glm::transpose(clip)[3];
  const glm::vec4 center(relativeTo(inputs_.origin, inputs_.subject.center), 1.0f);
  const float nearest =
      glm::dot(depth, center) - glm::length(glm::vec3(depth)) * inputs_.subject.radius;
  return std::max(nearest, 0.0f) * kVertexSpacing /
         pixelsPerUnit(clip, {inputs_.width, inputs_.height});
}

void SceneRenderer::recordDepthMap(VkCommandBuffer commands, VkImageView view, std::uint32_t side,
                                   const glm::mat4& clipFromWorld, float spacing) const {
  const float texel = 2.0f * inputs_.subject.radius / float(side); // in world units
  const float texels = std::max(spacing / texel, kDepthFootprint);
  beginRendering(commands, {side, side}, VK_NULL_HANDLE, view, 1.0f);
  bindGeometry(commands);
  for (const Instance& instance : scene_.instances) {
    if (debugView_ != DEBUG_NONE)
      break; // other views have no shadows
    const std::size_t m = scene_.primitives[instance.primitive].material;
    const DepthKind kind = depthKindOf(m);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.depth(kind));
    if (kind.hasGaps || kind.displaces)
      bindMaterial(commands, pipelines_.sceneLayout, m);
    const glm::mat4 placed = relativeTo(inputs_.origin, instance.worldFromObject);
    const shader::DepthData draw{clipFromWorld * placed, placed};
    if (kind.displaces)
      pushDisplaced(commands, clipFromWorld, glm::vec2(float(side)), texels, placed);
    else
      vkCmdPushConstants(commands, pipelines_.sceneLayout, VK_SHADER_STAGE_VERTEX_BIT, 0,
                         sizeof draw, &draw);
    drawPrimitive(commands, instance.primitive);
  }
  vkCmdEndRendering(commands);
}

void SceneRenderer::recordDepthMaps(VkCommandBuffer commands, const FrameView& view) const {
  transition(commands, lightMaps_.sunDepth, discarded(kSampled), kDepthTarget);
  transition(commands, lightMaps_.skyDepth, discarded(kSampled), kDepthTarget);
  const float spacing = spacingOfSubject(view); // shadows need no finer heights
  recordDepthMap(commands, lightMaps_.sunDepth.view, kSunDepthSide, view.clipFromWorldOfSun,
                 spacing);
  for (std::size_t k = 0; k < std::size_t(view.data.counts.y); ++k)
    recordDepthMap(commands, lightMaps_.skyLayers[k], kSkyDepthSide, view.clipFromWorldOfSky[k],
                   spacing);
  transition(commands, lightMaps_.sunDepth, kDepthTarget, kSampled);
  transition(commands, lightMaps_.skyDepth, kDepthTarget, kSampled);
}

void SceneRenderer::drawSurface(VkCommandBuffer commands, const FrameView& view,
                                const Instance& instance, VkCullModeFlags cull) const {
  const std::size_t m = scene_.primitives[instance.primitive].material;
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.surface(kindOf(m)));
  bindMaterial(commands, pipelines_.sceneLayout, m);
  const shader::DrawData draw{relativeTo(inputs_.origin, instance.worldFromObject)};
  const bool mirrored = glm::determinant(glm::mat3(draw.worldFromObject)) < 0.0f;
  vkCmdSetCullMode(commands, cull);
  vkCmdSetFrontFace(commands, mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
  if (displaces(m))
    pushDisplaced(commands, view.data.clipFromWorld, {inputs_.width, inputs_.height},
                  kVertexSpacing, draw.worldFromObject);
  else
    vkCmdPushConstants(commands, pipelines_.sceneLayout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof draw,
                       &draw);
  drawPrimitive(commands, instance.primitive);
}

void SceneRenderer::drawOpaque(VkCommandBuffer commands, const FrameView& view,
                               const Instance& instance) const {
  const bool twoSided = materialOf(instance).doubleSided;
  drawSurface(commands, view, instance, twoSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
}

/// Draws the back faces of a double-sided material first: on a convex body they are farther away.
void SceneRenderer::drawBlended(VkCommandBuffer commands, const FrameView& view,
                                const Instance& instance) const {
  if (materialOf(instance).doubleSided)
    drawSurface(commands, view, instance, VK_CULL_MODE_FRONT_BIT);
  drawSurface(commands, view, instance, VK_CULL_MODE_BACK_BIT);
}

void SceneRenderer::recordSurfaces(VkCommandBuffer commands, const FrameView& view) const {
  transition(commands, targets_.color, discarded(kSampled), kColorTarget);
  transition(commands, targets_.depth, discarded(kDepthTarget), kDepthTarget);
  const std::uint32_t frameData = frameData_.offset();
  beginRendering(commands, {inputs_.width, inputs_.height}, targets_.color.view,
                 targets_.depth.view, 0.0f);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.sceneLayout,
                          SET_FRAME, 1, &frameSet_, 1, &frameData);
  bindGeometry(commands);
  for (const Instance& instance : scene_.instances)
    if (materialOf(instance).alphaMode != AlphaMode::blend)
      drawOpaque(commands, view, instance);
  if (debugView_ == DEBUG_NONE) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.sky);
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdDraw(commands, 3, 1, 0, 0);
  }
  for (const std::size_t instance : blendedOrder_)
    drawBlended(commands, view, scene_.instances[instance]);
  vkCmdEndRendering(commands);
  transition(commands, targets_.color, kColorTarget, kSampled);
}

void SceneRenderer::recordAccumulate(VkCommandBuffer commands, std::uint32_t index) const {
  transition(commands, targets_.sum, index == 0 ? discarded(kStorage) : kStorage, kStorage);
  const bool shaded = debugView_ == DEBUG_NONE;
  const AccumulateSettings push{shaded ? std::exp2(exposureEv_) : 1.0f, shaded && toneMap_,
                                index == 0};
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.accumulate);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.accumulateLayout, 0,
                          1, &accumulateSet_, 0, nullptr);
  vkCmdPushConstants(commands, pipelines_.accumulateLayout, VK_SHADER_STAGE_COMPUTE_BIT, 0,
                     sizeof push, &push);
  vkCmdDispatch(commands, (inputs_.width + kAccumulateGroup - 1) / kAccumulateGroup,
                (inputs_.height + kAccumulateGroup - 1) / kAccumulateGroup, 1);
}

} // namespace lichen::renderer
