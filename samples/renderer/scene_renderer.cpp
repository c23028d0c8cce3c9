// SPDX-License-Identifier: MIT
// Setup of the renderer and changes to it. scene_frame.cpp renders frames, scene_notes.cpp writes
// the notes.
#include "scene_renderer.h"

#include "debug_views.h"
#include "environment.h"
#include "failure.h"
#include "lighting.h"
#include "relative_to.h"
#include "sky_cache.h"

#include <algorithm>
#include <cmath>

namespace lichen::renderer {
namespace {

// Haze absorbs 63 % of the light over this many times the distance to the subject, whatever the
// scene's unit: it blends ground into sky and leaves the subject clear.
constexpr float kHazeDistance = 80.0f;

} // namespace

SceneRenderer::SceneRenderer(VulkanDevice& device, const Scene& scene,
                             const RenderSettings& settings)
    : device_(device), scene_(scene), exposureEv_(settings.exposureEv), toneMap_(settings.toneMap),
      debugView_(take(debugViewValue(settings.debugView))), objects_(device.device()),
      store_(settings.pipelines ? *settings.pipelines : ownStore_.emplace(device)),
      noises_(device, objects_, store_.noiseContext(), scene),
      gpu_(uploadScene(device, objects_, scene)) {
  inputs_.subject = take(subjectOf(scene));
  const float aspect = float(settings.width) / float(settings.height);
  inputs_.lighting = arrangeLights(scene, inputs_.subject, settings.environment.has_value());
  inputs_.width = settings.width;
  inputs_.height = settings.height;
  setFrames(settings.frames);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (materialOf(scene.instances[i]).alphaMode == AlphaMode::blend)
      blended_.emplace_back(i, centerOf(scene, scene.instances[i]));
  hasHaze_ = !settings.environment; // a panorama has its own background
  setCamera(take(chooseCamera(scene, inputs_.subject, settings.camera, aspect)));
  environment_ = prepareLight(settings);
  const VkFilter filter = depthFilter(device);
  targets_ = createFrameTargets(device, settings.width, settings.height);
  lightMaps_ = createLightMaps(device, objects_);
  createFrameSet(filter);
  accumulateSet_ =
      createSet(accumulateDescriptors(), VK_SHADER_STAGE_COMPUTE_BIT, accumulateLayout_);
  choosePipelines();
}

/// Uploads the environment file, or else the built-in sky, and applies the sky's white balance to
/// the lights.
GpuEnvironment SceneRenderer::prepareLight(const RenderSettings& settings) {
  if (settings.environment) {
    const int longestSide = int(device_.properties().limits.maxImageDimension2D);
    GpuEnvironment environment = uploadEnvironment(
        device_, objects_, prepareEnvironment(fitInto(*settings.environment, longestSide)));
    const VkExtent3D uploaded = environment.panorama.info.extent;
    if (uploaded.width != std::uint32_t(settings.environment->width) ||
        uploaded.height != std::uint32_t(settings.environment->height))
      environmentNotes_.push_back(
          "the environment exceeds the device's image size; it is reduced to " +
          std::to_string(uploaded.width) + " x " + std::to_string(uploaded.height));
    return environment;
  }
  Lighting& lighting = inputs_.lighting;
  const glm::vec3 sunlight =
      lighting.hasSun ? lighting.lights[0].color * lighting.lights[0].intensity : glm::vec3(0.0f);
  SkyCache ownCache;
  SkyCache& skies = settings.skies ? *settings.skies : ownCache;
  const PreparedSky& sky = skies.prepare(lighting.towardSun, sunlight, lighting.skyIrradiance);
  for (Light& light : lighting.lights)
    light.color *= sky.balance;
  return uploadEnvironment(device_, objects_, sky.environment);
}

void SceneRenderer::createFrameSet(VkFilter depthFilter) {
  VkSamplerCreateInfo compare{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  compare.magFilter = compare.minFilter = depthFilter;
  compare.addressModeU = compare.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  compare.compareEnable = VK_TRUE;
  compare.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  const VkSampler compareSampler = objects_.sampler(compare);
  frameData_ = UniformBlocks(device_, 1, sizeof(shader::FrameData));
  std::array<Descriptor, FRAME_BINDINGS> descriptors{};
  descriptors[BINDING_FRAME] = frameData_.descriptor();
  descriptors[BINDING_SPECULAR] =
      sampledImage(environment_.clampSampler, environment_.specular.view);
  descriptors[BINDING_DIFFUSE] = sampledImage(environment_.clampSampler, environment_.diffuse.view);
  descriptors[BINDING_BRDF] = sampledImage(environment_.clampSampler, environment_.brdf.view);
  descriptors[BINDING_PANORAMA] =
      sampledImage(environment_.panoramaSampler, environment_.panorama.view);
  descriptors[BINDING_SUN_DEPTH] = sampledImage(compareSampler, lightMaps_.sunDepth.view);
  descriptors[BINDING_SKY_DEPTH] = sampledImage(compareSampler, lightMaps_.skyDepth.view);
  frameSet_ = createSet(descriptors, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                        frameLayout_);
}

std::array<Descriptor, 2> SceneRenderer::accumulateDescriptors() const {
  return {sampledImage(environment_.clampSampler, targets_.color.view),
          storageImage(targets_.sum.view)};
}

/// Creates a layout, a pool and a set for the descriptors.
VkDescriptorSet SceneRenderer::createSet(std::span<const Descriptor> descriptors,
                                         VkShaderStageFlags stages, VkDescriptorSetLayout& layout) {
  std::vector<VkDescriptorType> types;
  for (const Descriptor& descriptor : descriptors)
    types.push_back(descriptor.type);
  layout = objects_.setLayout(types, stages);
  const VkDescriptorSet set = objects_.set(objects_.pool(1, types), layout);
  writeSet(device_.device(), set, descriptors);
  return set;
}

PipelinesUsed SceneRenderer::pipelinesUsed() const {
  PipelinesUsed used;
  for (const Instance& instance : scene_.instances) {
    const std::size_t m = scene_.primitives[instance.primitive].material;
    used.surfaces[kindOf(m).index()] = true;
    used.depths[depthKindOf(m).index()] = true;
  }
  return used;
}

void SceneRenderer::choosePipelines() {
  pipelines_ = store_.pipelinesFor({frameLayout_, gpu_.materialLayout, accumulateLayout_},
                                   {debugView_, noises_.features()}, pipelinesUsed());
}

void SceneRenderer::setSize(std::uint32_t width, std::uint32_t height) {
  targets_ = FrameTargets(); // free their memory first
  targets_ = createFrameTargets(device_, width, height);
  inputs_.width = width;
  inputs_.height = height;
  writeSet(device_.device(), accumulateSet_, accumulateDescriptors());
}

void SceneRenderer::setCamera(const Camera& camera) {
  inputs_.camera = camera;
  const glm::dvec3 origin = originNear(camera, inputs_.subject.center);
  if (origin != std::exchange(inputs_.origin, origin))
    noises_.setOrigin(origin);
  if (hasHaze_) // a camera inside the subject counts as on its border
    inputs_.hazeDistance =
        kHazeDistance * std::max(glm::length(relativeTo(inputs_.subject.center, eyeOf(camera))),
                                 inputs_.subject.radius);
  blendedOrder_ = blendedOrder();
}

void SceneRenderer::setFrames(std::uint32_t frames) {
  inputs_.frames = frames;
  inputs_.skyDirections = skyDirectionsOf(frames);
}

void SceneRenderer::setPreview() {
  inputs_.frames = 1;
  inputs_.skyDirections = kLeastSkyDirections;
}

void SceneRenderer::setDebugView(const std::string& name) {
  const int view = take(debugViewValue(name));
  if (view == debugView_)
    return;
  debugView_ = view;
  choosePipelines();
}

void SceneRenderer::setNoise(const NoiseChanges& changes) {
  const NoiseFeatures before = noises_.features();
  noises_.change(changes);
  if (noises_.features() != before)
    choosePipelines();
}

/// Indices of the blended instances, farthest first. Compares the centres of bounding boxes,
/// because in many files all nodes have the same origin.
std::vector<std::size_t> SceneRenderer::blendedOrder() const {
  const glm::dmat4& camera = inputs_.camera.worldFromCamera;
  std::vector<std::pair<float, std::size_t>> order;
  for (const auto& [instance, center] : blended_) {
    const glm::vec3 fromCamera = relativeTo(eyeOf(inputs_.camera), center);
    // the camera looks along -z
    order.emplace_back(glm::dot(fromCamera, glm::vec3(camera[2])), instance);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> indices;
  for (const auto& [height, index] : order)
    indices.push_back(index);
  return indices;
}

} // namespace lichen::renderer
