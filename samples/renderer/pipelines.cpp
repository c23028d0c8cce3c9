// SPDX-License-Identifier: MIT
// Pipeline state of each pass. Specialization constants select the surface variants. Depth is
// reversed for the camera, but not for lights.
#include "pipelines.h"

#include "scene.h"
#include "shaders/scene_interface.h"

#include <accumulate.comp.h>
#include <algorithm>
#include <cstddef>
#include <depth.frag.bare.h>
#include <depth.frag.h>
#include <depth.vert.h>
#include <displaced.vert.h>
#include <optional>
#include <scene.frag.bare.h>
#include <scene.frag.h>
#include <scene.frag.layers.h>
#include <scene.frag.tiled_layers.h>
#include <scene.vert.h>
#include <scene_variants.h>
#include <sky.frag.h>
#include <sky.vert.h>
#include <span>
#include <utility>
#include <vector>

namespace lichen::renderer {
namespace {

// Slope factor of the depth bias in a light's depth map.
constexpr float kSlopeBias = 2.0f;

struct Description {
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkShaderModule vertex = VK_NULL_HANDLE;
  VkShaderModule fragment = VK_NULL_HANDLE; ///< null for depth-only passes
  const VkSpecializationInfo* specialization = nullptr;
  std::span<const VkVertexInputAttributeDescription> attributes;
  bool color = true;
  bool blends = false;
  bool writesDepth = true;
  bool slopeBias = false;
  VkCompareOp compare = VK_COMPARE_OP_GREATER_OR_EQUAL;
};

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = which;
  info.module = module;
  info.pName = "main";
  return info;
}

constexpr VkVertexInputAttributeDescription at(std::uint32_t location, VkFormat format,
                                               std::size_t offset, std::uint32_t binding = 0) {
  return {location, binding, format, std::uint32_t(offset)};
}

constexpr std::array kAttributes{at(0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)),
                                 at(1, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)),
                                 at(2, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, tangent)),
                                 at(3, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, texCoord0)),
                                 at(4, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, texCoord1)),
                                 at(5, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, color)),
                                 at(6, VK_FORMAT_R32_SFLOAT, offsetof(Vertex, mixWeight))};

constexpr std::uint32_t kDisplacement = 1; // binding of VertexDisplacement

/// kAttributes and the attributes of displacement.
constexpr auto kDisplacedAttributes = [] {
  std::array<VkVertexInputAttributeDescription, kAttributes.size() + 2> all{};
  std::copy(kAttributes.begin(), kAttributes.end(), all.begin());
  static_assert(offsetof(VertexDisplacement, weight) == sizeof(glm::vec3)); // w of the direction
  all[kAttributes.size()] =
      at(7, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(VertexDisplacement, direction), kDisplacement);
  all[kAttributes.size() + 1] =
      at(8, VK_FORMAT_R32_SFLOAT, offsetof(VertexDisplacement, texCoordsPerUnit), kDisplacement);
  return all;
}();

VkPipelineColorBlendAttachmentState blending(bool enabled) {
  VkPipelineColorBlendAttachmentState state{};
  state.blendEnable = enabled;
  state.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
  state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                         VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  return state;
}

VkPipeline graphics(ObjectOwner& objects, const Description& d) {
  std::vector<VkPipelineShaderStageCreateInfo> stages;
  for (const auto& [which, module] : {std::pair{VK_SHADER_STAGE_VERTEX_BIT, d.vertex},
                                      {VK_SHADER_STAGE_FRAGMENT_BIT, d.fragment}})
    if (module != VK_NULL_HANDLE) {
      stages.push_back(stage(which, module));
      stages.back().pSpecializationInfo = d.specialization;
    }
  constexpr std::array kBindings{
      VkVertexInputBindingDescription{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX},
      VkVertexInputBindingDescription{kDisplacement, sizeof(VertexDisplacement),
                                      VK_VERTEX_INPUT_RATE_VERTEX}};
  VkPipelineVertexInputStateCreateInfo input{
      VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  input.vertexBindingDescriptionCount = d.attributes.empty() ? 0 : d.attributes.back().binding + 1;
  input.pVertexBindingDescriptions = kBindings.data();
  input.vertexAttributeDescriptionCount = std::uint32_t(d.attributes.size());
  input.pVertexAttributeDescriptions = d.attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.lineWidth = 1.0f;
  raster.depthBiasEnable = d.slopeBias;
  raster.depthBiasSlopeFactor = d.slopeBias ? kSlopeBias : 0.0f;
  VkPipelineMultisampleStateCreateInfo samples{
      VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{
      VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = d.writesDepth;
  depth.depthCompareOp = d.compare;
  const VkPipelineColorBlendAttachmentState attachment = blending(d.blends);
  VkPipelineColorBlendStateCreateInfo blend{
      VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = d.color ? 1 : 0;
  blend.pAttachments = &attachment;
  const std::array dynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                           VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};
  VkPipelineDynamicStateCreateInfo dynamics{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamics.dynamicStateCount = std::uint32_t(dynamic.size());
  dynamics.pDynamicStates = dynamic.data();
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = d.color ? 1 : 0;
  rendering.pColorAttachmentFormats = &kColorFormat;
  rendering.depthAttachmentFormat = kDepthFormat;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.pNext = &rendering;
  info.stageCount = std::uint32_t(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamics;
  info.layout = d.layout;
  return objects.graphicsPipeline(info);
}

/// For opaque surfaces, which need no fragment shader. The caller adds the stages before it.
Description depthDescription(VkPipelineLayout layout) {
  Description d;
  d.layout = layout;
  d.color = false;
  d.slopeBias = true;
  d.compare = VK_COMPARE_OP_LESS_OR_EQUAL;
  return d;
}

/// Specialization constants of surface.glsl, noise_point.glsl and debug_views.glsl.
struct Constants {
  VkBool32 hasNormalMap = VK_FALSE;
  std::int32_t debugView = DEBUG_NONE;
  std::uint32_t features = 0;
  std::uint32_t roles = 0;
  VkBool32 objectSpaces = VK_FALSE;
};

constexpr std::array kConstants{
    VkSpecializationMapEntry{1, offsetof(Constants, hasNormalMap), sizeof(VkBool32)},
    VkSpecializationMapEntry{2, offsetof(Constants, debugView), sizeof(std::int32_t)},
    VkSpecializationMapEntry{3, offsetof(Constants, features), sizeof(std::uint32_t)},
    VkSpecializationMapEntry{4, offsetof(Constants, roles), sizeof(std::uint32_t)},
    VkSpecializationMapEntry{5, offsetof(Constants, objectSpaces), sizeof(VkBool32)}};

VkSpecializationInfo specializationOf(const Constants& constants) {
  return {std::uint32_t(kConstants.size()), kConstants.data(), sizeof constants, &constants};
}

struct NoiseCode {
  std::span<const std::uint32_t> surface, depth; ///< fragment shaders
  std::span<const std::uint32_t> displaced;      ///< vertex shader
};

/// The smallest variant of the shaders that has the methods and mappings of all noises.
NoiseCode codeFor(const NoiseSwitches& noises) {
  struct Variant {
    std::uint32_t methods, mappings; // as CMakeLists.txt defines them
    NoiseCode code;
  };
  static const Variant kVariants[] = {SCENE_VARIANTS};
  for (const Variant& variant : kVariants)
    if ((noises.methods & ~variant.methods) == 0 && (noises.mappings & ~variant.mappings) == 0)
      return variant.code;
  return {scene_frag, depth_frag, displaced_vert};
}

std::span<const std::uint32_t> layeredCodeFor(const NoiseSwitches& noises) {
  if (noises.methods == 1)
    return scene_frag_tiled_layers;
  return scene_frag_layers;
}

Constants constantsOf(const SurfaceConstants& shared, const NoiseSwitches& noises) {
  return {.debugView = shared.debugView,
          .features = noises.features,
          .roles = noises.roles,
          .objectSpaces = shared.noises.objectSpaces};
}

/// Sets the vertex shader and its attributes, with this shader for surfaces that are not displaced.
void setVertexStage(ObjectOwner& objects, bool displaces, const NoiseSwitches& noises,
                    std::span<const std::uint32_t> vertex, Description& d) {
  d.attributes = kAttributes;
  if (displaces)
    d.attributes = kDisplacedAttributes;
  d.vertex = objects.shader(displaces ? codeFor(noises).displaced : vertex);
}

/// The pipeline of that key in `stored`, which `create` makes the first time.
template <class Stored, class Create>
VkPipeline found(std::vector<Stored>& stored, const SurfaceConstants& constants, std::size_t kind,
                 const Create& create) {
  for (const Stored& one : stored)
    if (one.kind == kind && one.constants == constants)
      return one.pipeline;
  stored.push_back({constants, kind, create()});
  return stored.back().pipeline;
}

} // namespace

VkPipeline PipelineStore::surface(const SurfaceConstants& constants, std::size_t kind) {
  return found(surfaces_, constants, kind, [&] {
    const bool hasNoise = (kind & 4) != 0, isLayered = (kind & 16) != 0;
    const NoiseSwitches& noises = isLayered ? constants.noises.layered : constants.noises.plain;
    Constants values = constantsOf(constants, noises);
    values.hasNormalMap = (kind & 2) != 0;
    const VkSpecializationInfo specialization = specializationOf(values);
    Description d;
    d.layout = shared_.sceneLayout;
    setVertexStage(objects_, (kind & 8) != 0, noises, scene_vert, d);
    d.fragment = objects_.shader(isLayered  ? layeredCodeFor(noises)
                                 : hasNoise ? codeFor(noises).surface
                                            : scene_frag_bare);
    d.specialization = &specialization;
    d.blends = (kind & 1) != 0;
    d.writesDepth = !d.blends;
    return graphics(objects_, d);
  });
}

VkPipeline PipelineStore::depth(const SurfaceConstants& constants, std::size_t kind) {
  return found(depths_, constants, kind, [&] {
    const NoiseSwitches& noises = constants.noises.plain;
    const Constants values = constantsOf(constants, noises);
    const VkSpecializationInfo specialization = specializationOf(values);
    Description d = depthDescription(shared_.sceneLayout);
    setVertexStage(objects_, (kind & 4) != 0, noises, depth_vert, d);
    if ((kind & 1) != 0)
      d.fragment = objects_.shader((kind & 2) != 0 ? codeFor(noises).depth : depth_frag_bare);
    d.specialization = &specialization;
    return graphics(objects_, d);
  });
}

void PipelineStore::createShared(const PipelineLayouts& layouts) {
  Pipelines made;
  const std::array sceneSets{layouts.frame, layouts.material, noises_.setLayout()};
  made.sceneLayout = objects_.pipelineLayout(sceneSets, VK_SHADER_STAGE_VERTEX_BIT, kDrawBytes);
  made.accumulateLayout = objects_.pipelineLayout(
      std::span(&layouts.accumulate, 1), VK_SHADER_STAGE_COMPUTE_BIT, sizeof(AccumulateSettings));

  Description sky;
  sky.layout = made.sceneLayout;
  sky.vertex = objects_.shader(sky_vert);
  sky.fragment = objects_.shader(sky_frag);
  sky.writesDepth = false;
  made.sky = graphics(objects_, sky);

  VkComputePipelineCreateInfo accumulate{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  accumulate.stage = stage(VK_SHADER_STAGE_COMPUTE_BIT, objects_.shader(accumulate_comp));
  accumulate.layout = made.accumulateLayout;
  made.accumulate = objects_.computePipeline(accumulate);
  shared_ = made;
}

Pipelines PipelineStore::pipelinesFor(const PipelineLayouts& layouts,
                                      const SurfaceConstants& constants,
                                      const PipelinesUsed& used) {
  if (shared_.accumulate == VK_NULL_HANDLE)
    createShared(layouts);
  // A surface without a noise takes no constants from the noises of other materials.
  const SurfaceConstants bare{.debugView = constants.debugView};
  Pipelines pipelines = shared_;
  for (std::size_t kind = 0; kind < pipelines.surfaces.size(); ++kind)
    if (used.surfaces[kind])
      pipelines.surfaces[kind] = surface((kind & 4) != 0 ? constants : bare, kind);
  for (std::size_t kind = 0; kind < pipelines.depths.size(); ++kind)
    if (used.depths[kind]) {
      SurfaceConstants seen = (kind & 2) != 0 ? constants : bare;
      seen.debugView = DEBUG_NONE; // a depth is the same in every view
      pipelines.depths[kind] = depth(seen, kind);
    }
  return pipelines;
}

} // namespace lichen::renderer
