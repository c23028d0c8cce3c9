// SPDX-License-Identifier: MIT
// One frame: depth maps of the sun and of a few directions toward the sky, surfaces and the sky,
// and the frame added to the sum of frames. Set-up comes first, recording after it.
#include "renderer.h"

#include "environment.h"
#include "failure.h"
#include "frame_data.h"
#include "gpu_environment.h"
#include "gpu_scene.h"
#include "lighting.h"
#include "noise_host.h"
#include "pipelines.h"
#include "sky_cache.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <new>

namespace lichen::renderer {
namespace {

// Haze takes 63 % of what is this many times as far as the subject, whatever the scene's unit: it
// joins a ground to the sky and leaves the subject alone.
constexpr float kHazeDistance = 80.0f;
constexpr std::uint32_t kAccumulateGroup = 8; // local size in accumulate.comp

struct DebugView {
  std::string_view name;
  int value;
};
constexpr std::array kDebugViews{
    DebugView{"normals", DEBUG_NORMALS},     DebugView{"base-color", DEBUG_BASE_COLOR},
    DebugView{"weights", DEBUG_WEIGHTS},     DebugView{"lattice", DEBUG_LATTICE},
    DebugView{"mip-level", DEBUG_MIP_LEVEL}, DebugView{"gaussian", DEBUG_GAUSSIAN},
    DebugView{"impacts", DEBUG_IMPACTS},     DebugView{"planes", DEBUG_PLANES}};

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int debugViewValue(const std::string& name) {
  if (name.empty())
    return DEBUG_NONE;
  std::string names;
  for (const DebugView& view : kDebugViews) {
    if (view.name == name)
      return view.value;
    names += (names.empty() ? "" : ", ") + std::string(view.name);
  }
  throw Failure{{ErrorKind::usage, "no debug view \"" + name + "\"; there are " + names}};
}

/// Everything that stays the same from frame to frame, and the recording of one.
class SceneRenderer {
public:
  SceneRenderer(HeadlessDevice& device, const Scene& scene, const RenderSettings& settings)
      : device_(device), scene_(scene), settings_(settings), objects_(device.device()),
        debugView_(debugViewValue(settings.debugView)), noises_(device, objects_, scene),
        gpu_(uploadScene(device, objects_, scene, noises_)) {
    inputs_.subject = take(subjectOf(scene));
    const float aspect = float(settings.width) / float(settings.height);
    inputs_.camera = take(chooseCamera(scene, inputs_.subject, settings.camera, aspect));
    blendedOrder_ = blendedOrder();
    inputs_.lighting = arrangeLights(scene, inputs_.subject, settings.environment.has_value());
    inputs_.width = settings.width;
    inputs_.height = settings.height;
    inputs_.frames = settings.frames;
    environment_ = lightAround();
    collectNotes();
    const VkFilter filter = depthFilter();
    createTargets();
    createFrameSet(filter);
    createAccumulateSet();
    pipelines_ = createPipelines(
        objects_, {frameLayout_, gpu_.materialLayout, noises_.setLayout(), accumulateLayout_},
        {debugView_, noises_.hasOtherTables(), noises_.hasTilingNoises(), noises_.hasTextonNoises(),
         noises_.hasSurfaceNoises(), noises_.hasTriplanarNoises(), noises_.hasMixes()},
        pipelinesUsed());
  }

  void renderFrame(std::uint32_t index) {
    const FrameView view = frameView(inputs_, index);
    std::memcpy(frameData_.mapped, &view.data, sizeof view.data);
    take(device_.submit([&](VkCommandBuffer commands) {
      recordDepthMaps(commands, view);
      recordSurfaces(commands);
      recordAccumulate(commands, index);
    }));
  }

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  LinearImage average() {
    const auto bytes = take(device_.readImage(sum_, VK_IMAGE_LAYOUT_GENERAL, sizeof(glm::vec4)));
    LinearImage image(int(settings_.width), int(settings_.height), 3);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
      glm::vec4 value;
      std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
      for (std::size_t c = 0; c < 3; ++c)
        image.values[3 * i + c] = value[int(c)] / float(settings_.frames);
    }
    return image;
  }

private:
  /// The environment file's, or the built-in sky, whose white balance the lights then take too.
  GpuEnvironment lightAround() {
    if (settings_.environment) {
      const int longestSide = int(device_.properties().limits.maxImageDimension2D);
      return uploadEnvironment(device_, objects_,
                               prepareEnvironment(fitted(*settings_.environment, longestSide)));
    }
    Lighting& lighting = inputs_.lighting;
    const glm::vec3 sunlight =
        lighting.hasSun ? lighting.lights[0].color * lighting.lights[0].intensity : glm::vec3(0.0f);
    SkyCache own;
    SkyCache& skies = settings_.skies ? *settings_.skies : own;
    const PreparedSky& sky = skies.under(lighting.towardSun, sunlight, lighting.skyIrradiance);
    for (Light& light : lighting.lights)
      light.color *= sky.balance;
    inputs_.hazeDistance =
        kHazeDistance *
        glm::distance(inputs_.subject.center, glm::vec3(inputs_.camera.worldFromCamera[3]));
    return uploadEnvironment(device_, objects_, sky.environment);
  }

  void collectNotes() {
    notes_.assign(noises_.notes().begin(), noises_.notes().end());
    if (inputs_.lighting.dropped > 0)
      notes_.push_back("the scene has " +
                       std::to_string(inputs_.lighting.lights.size() + inputs_.lighting.dropped) +
                       " lights; the " + std::to_string(MAX_LIGHTS) +
                       " that light it most are drawn");
    const VkExtent3D panorama = environment_.panorama.info.extent;
    if (settings_.environment && (panorama.width != std::uint32_t(settings_.environment->width) ||
                                  panorama.height != std::uint32_t(settings_.environment->height)))
      notes_.push_back("the environment is larger than this device accepts; it is drawn at " +
                       std::to_string(panorama.width) + " x " + std::to_string(panorama.height));
  }

  DeviceImage target(VkFormat format, VkImageUsageFlags usage, std::uint32_t width,
                     std::uint32_t height) {
    DeviceImageInfo info;
    info.format = format;
    info.extent = {width, height, 1};
    info.usage = usage;
    if (format == kDepthFormat)
      info.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    return take(device_.createImage(info));
  }

  /// How depth maps are filtered. Vulkan guarantees all that is asked of the colour formats, and of
  /// depth only that some format can be drawn to.
  [[nodiscard]] VkFilter depthFilter() const {
    VkFormatProperties depth{};
    vkGetPhysicalDeviceFormatProperties(device_.physicalDevice(), kDepthFormat, &depth);
    constexpr VkFormatFeatureFlags kNeeded =
        VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    if ((depth.optimalTilingFeatures & kNeeded) != kNeeded)
      throw Failure{{ErrorKind::environment,
                     "Vulkan device \"" + std::string(device_.properties().deviceName) +
                         "\" cannot draw and sample VK_FORMAT_D32_SFLOAT, which shadows need"}};
    const bool linear =
        (depth.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
    return linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST; // nearest: harder edges of shadows
  }

  void createTargets() {
    const std::uint32_t w = settings_.width;
    const std::uint32_t h = settings_.height;
    const std::uint32_t longest = device_.properties().limits.maxImageDimension2D;
    if (std::max(w, h) > longest)
      throw Failure{{ErrorKind::usage, "--size " + std::to_string(w) + "x" + std::to_string(h) +
                                           ": this device accepts up to " +
                                           std::to_string(longest) + " on a side"}};
    color_ = target(kColorFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                    w, h);
    depth_ = target(kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, w, h);
    sum_ = target(kSumFormat, VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, w, h);
    constexpr VkImageUsageFlags kDepthMap =
        VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    sunDepth_ = target(kDepthFormat, kDepthMap, kSunDepthSide, kSunDepthSide);
    DeviceImageInfo sky;
    sky.format = kDepthFormat;
    sky.extent = {kSkyDepthSide, kSkyDepthSide, 1};
    sky.layers = SKY_DIRECTIONS;
    sky.usage = kDepthMap;
    sky.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
    sky.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    skyDepth_ = take(device_.createImage(sky));
    VkImageViewCreateInfo layer{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    layer.image = skyDepth_.handle;
    layer.viewType = VK_IMAGE_VIEW_TYPE_2D;
    layer.format = kDepthFormat;
    for (std::uint32_t k = 0; k < SKY_DIRECTIONS; ++k) {
      layer.subresourceRange = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, k, 1};
      skyDepthLayers_[k] = objects_.view(layer);
    }
  }

  void createFrameSet(VkFilter depthFilter) {
    VkSamplerCreateInfo compare{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    compare.magFilter = compare.minFilter = depthFilter;
    compare.addressModeU = compare.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    compare.compareEnable = VK_TRUE;
    compare.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    const VkSampler compareSampler = objects_.sampler(compare);
    frameData_ = take(
        device_.createBuffer(sizeof(shader::FrameData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true));
    std::array<Descriptor, FRAME_BINDINGS> descriptors{};
    descriptors[BINDING_FRAME] = uniformBlock(frameData_.handle, 0, sizeof(shader::FrameData));
    descriptors[BINDING_SPECULAR] =
        sampledImage(environment_.clampSampler, environment_.specular.view);
    descriptors[BINDING_DIFFUSE] =
        sampledImage(environment_.clampSampler, environment_.diffuse.view);
    descriptors[BINDING_BRDF] = sampledImage(environment_.clampSampler, environment_.brdf.view);
    descriptors[BINDING_PANORAMA] =
        sampledImage(environment_.panoramaSampler, environment_.panorama.view);
    descriptors[BINDING_SUN_DEPTH] = sampledImage(compareSampler, sunDepth_.view);
    descriptors[BINDING_SKY_DEPTH] = sampledImage(compareSampler, skyDepth_.view);
    frameSet_ = createSet(descriptors, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                          frameLayout_);
  }

  void createAccumulateSet() {
    const std::array descriptors{sampledImage(environment_.clampSampler, color_.view),
                                 storageImage(sum_.view)};
    accumulateSet_ = createSet(descriptors, VK_SHADER_STAGE_COMPUTE_BIT, accumulateLayout_);
  }

  /// A set of these, of a layout of its own.
  VkDescriptorSet createSet(std::span<const Descriptor> descriptors, VkShaderStageFlags stages,
                            VkDescriptorSetLayout& layout) {
    std::vector<VkDescriptorType> types;
    for (const Descriptor& descriptor : descriptors)
      types.push_back(descriptor.type);
    layout = objects_.setLayout(types, stages);
    const VkDescriptorSet set = objects_.set(objects_.pool(1, types), layout);
    writeSet(device_.device(), set, descriptors);
    return set;
  }

  static void beginRendering(VkCommandBuffer commands, VkExtent2D extent, VkImageView color,
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

  void bindGeometry(VkCommandBuffer commands) const {
    const VkDeviceSize zero = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &gpu_.vertices.handle, &zero);
    vkCmdBindIndexBuffer(commands, gpu_.indices.handle, 0, VK_INDEX_TYPE_UINT32);
  }

  void drawPrimitive(VkCommandBuffer commands, std::size_t primitive) const {
    const GpuPrimitive& range = gpu_.primitives[primitive];
    vkCmdDrawIndexed(commands, range.indexCount, 1, range.firstIndex, range.vertexOffset, 0);
  }

  [[nodiscard]] const Material& materialOf(const Instance& instance) const {
    return scene_.materials[scene_.primitives[instance.primitive].material];
  }

  [[nodiscard]] SurfaceKind kindOf(std::size_t material) const {
    const Material& drawn = scene_.materials[material];
    return {noises_.hasNoise(material), drawn.normalTexture.image.has_value(),
            drawn.alphaMode == AlphaMode::blend};
  }

  [[nodiscard]] PipelinesUsed pipelinesUsed() const {
    PipelinesUsed used;
    for (const Instance& instance : scene_.instances) {
      const std::size_t m = scene_.primitives[instance.primitive].material;
      used.surfaces[kindOf(m).index()] = true;
      if (scene_.materials[m].alphaMode != AlphaMode::opaque)
        used.depthWithGaps[noises_.hasNoise(m) ? 1 : 0] = true;
    }
    return used;
  }

  void bindMaterial(VkCommandBuffer commands, VkPipelineLayout layout, std::size_t material) {
    const std::array sets{gpu_.materialSets[material], noises_.set(material)};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, SET_MATERIAL,
                            std::uint32_t(sets.size()), sets.data(), 0, nullptr);
  }

  void recordDepthMap(VkCommandBuffer commands, VkImageView view, std::uint32_t side,
                      const glm::mat4& clipFromWorld) {
    beginRendering(commands, {side, side}, VK_NULL_HANDLE, view, 1.0f);
    bindGeometry(commands);
    for (const Instance& instance : scene_.instances) {
      const Material& material = materialOf(instance);
      const std::size_t m = scene_.primitives[instance.primitive].material;
      const bool hasGaps = material.alphaMode != AlphaMode::opaque;
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                        hasGaps ? pipelines_.depthWithGaps[noises_.hasNoise(m) ? 1 : 0]
                                : pipelines_.depthOpaque);
      if (hasGaps)
        bindMaterial(commands, pipelines_.depthLayout, m);
      const shader::DepthData draw{clipFromWorld * instance.worldFromObject,
                                   instance.worldFromObject};
      vkCmdPushConstants(commands, pipelines_.depthLayout, VK_SHADER_STAGE_VERTEX_BIT, 0,
                         sizeof draw, &draw);
      drawPrimitive(commands, instance.primitive);
    }
    vkCmdEndRendering(commands);
  }

  void recordDepthMaps(VkCommandBuffer commands, const FrameView& view) {
    transition(commands, sunDepth_, kUndefined, kDepthTarget);
    transition(commands, skyDepth_, kUndefined, kDepthTarget);
    recordDepthMap(commands, sunDepth_.view, kSunDepthSide, view.clipFromWorldOfSun);
    for (std::size_t k = 0; k < SKY_DIRECTIONS; ++k)
      recordDepthMap(commands, skyDepthLayers_[k], kSkyDepthSide, view.clipFromWorldOfSky[k]);
    transition(commands, sunDepth_, kDepthTarget, kSampled);
    transition(commands, skyDepth_, kDepthTarget, kSampled);
  }

  void drawSurface(VkCommandBuffer commands, const Instance& instance, VkCullModeFlags cull) {
    const std::size_t m = scene_.primitives[instance.primitive].material;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.surface(kindOf(m)));
    bindMaterial(commands, pipelines_.sceneLayout, m);
    const bool mirrored = glm::determinant(glm::mat3(instance.worldFromObject)) < 0.0f;
    vkCmdSetCullMode(commands, cull);
    vkCmdSetFrontFace(commands,
                      mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    const shader::DrawData draw{instance.worldFromObject};
    vkCmdPushConstants(commands, pipelines_.sceneLayout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof draw,
                       &draw);
    drawPrimitive(commands, instance.primitive);
  }

  void drawOpaque(VkCommandBuffer commands, const Instance& instance) {
    const bool twoSided = materialOf(instance).doubleSided;
    drawSurface(commands, instance, twoSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
  }

  /// Of two sides the back comes first, which in a convex body is the far one.
  void drawBlended(VkCommandBuffer commands, const Instance& instance) {
    if (materialOf(instance).doubleSided)
      drawSurface(commands, instance, VK_CULL_MODE_FRONT_BIT);
    drawSurface(commands, instance, VK_CULL_MODE_BACK_BIT);
  }

  /// Indices of the blended instances, the farthest first, by the middles of their boxes: nodes of
  /// many a file all have their origin in one place.
  [[nodiscard]] std::vector<std::size_t> blendedOrder() const {
    const glm::mat4& camera = inputs_.camera.worldFromCamera;
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < scene_.instances.size(); ++i)
      if (materialOf(scene_.instances[i]).alphaMode == AlphaMode::blend) {
        const glm::vec3 fromCamera = centerOf(scene_, scene_.instances[i]) - glm::vec3(camera[3]);
        order.emplace_back(glm::dot(fromCamera, glm::vec3(camera[2])), i); // looks along -z
      }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> indices;
    for (const auto& [height, index] : order)
      indices.push_back(index);
    return indices;
  }

  void recordSurfaces(VkCommandBuffer commands) {
    transition(commands, color_, kUndefined, kColorTarget);
    transition(commands, depth_, kUndefined, kDepthTarget);
    beginRendering(commands, {settings_.width, settings_.height}, color_.view, depth_.view, 0.0f);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.sceneLayout,
                            SET_FRAME, 1, &frameSet_, 0, nullptr);
    bindGeometry(commands);
    for (const Instance& instance : scene_.instances)
      if (materialOf(instance).alphaMode != AlphaMode::blend)
        drawOpaque(commands, instance);
    if (debugView_ == DEBUG_NONE) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.sky);
      vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
      vkCmdDraw(commands, 3, 1, 0, 0);
    }
    for (const std::size_t instance : blendedOrder_)
      drawBlended(commands, scene_.instances[instance]);
    vkCmdEndRendering(commands);
    transition(commands, color_, kColorTarget, kSampled);
  }

  void recordAccumulate(VkCommandBuffer commands, std::uint32_t index) {
    transition(commands, sum_, index == 0 ? kUndefined : kStorage, kStorage);
    const bool shaded = debugView_ == DEBUG_NONE;
    const AccumulateSettings push{shaded ? std::exp2(settings_.exposureEv) : 1.0f,
                                  shaded && settings_.toneMap, index == 0};
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.accumulate);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.accumulateLayout,
                            0, 1, &accumulateSet_, 0, nullptr);
    vkCmdPushConstants(commands, pipelines_.accumulateLayout, VK_SHADER_STAGE_COMPUTE_BIT, 0,
                       sizeof push, &push);
    vkCmdDispatch(commands, (settings_.width + kAccumulateGroup - 1) / kAccumulateGroup,
                  (settings_.height + kAccumulateGroup - 1) / kAccumulateGroup, 1);
  }

  HeadlessDevice& device_;
  const Scene& scene_;
  const RenderSettings& settings_;
  ObjectOwner objects_;
  int debugView_;
  NoiseHost noises_;
  GpuScene gpu_;
  FrameInputs inputs_;
  std::vector<std::size_t> blendedOrder_;
  GpuEnvironment environment_;
  DeviceImage color_, depth_, sum_, sunDepth_, skyDepth_;
  std::array<VkImageView, SKY_DIRECTIONS> skyDepthLayers_{};
  DeviceBuffer frameData_;
  VkDescriptorSetLayout frameLayout_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout accumulateLayout_ = VK_NULL_HANDLE;
  VkDescriptorSet frameSet_ = VK_NULL_HANDLE;
  VkDescriptorSet accumulateSet_ = VK_NULL_HANDLE;
  std::vector<std::string> notes_;
  Pipelines pipelines_;
};

} // namespace

std::vector<std::string_view> debugViewNames() {
  std::vector<std::string_view> names;
  for (const DebugView& view : kDebugViews)
    names.push_back(view.name);
  return names;
}

Result<Picture> renderScene(HeadlessDevice& device, const Scene& scene,
                            const RenderSettings& settings) {
  try {
    const Clock::time_point start = Clock::now();
    SceneRenderer renderer(device, scene, settings);
    Picture picture;
    picture.notes = renderer.notes();
    picture.setupSeconds = secondsSince(start);
    std::vector<double> seconds;
    for (std::uint32_t frame = 0; frame < settings.frames; ++frame) {
      const Clock::time_point frameStart = Clock::now();
      renderer.renderFrame(frame);
      seconds.push_back(secondsSince(frameStart));
      if (settings.frameDone)
        settings.frameDone(frame + 1);
    }
    std::sort(seconds.begin(), seconds.end());
    picture.medianFrameSeconds = seconds[seconds.size() / 2];
    picture.pixels = renderer.average();
    return picture;
  } catch (const Failure& failure) {
    return failure.error;
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, scene.name + ": not enough memory to draw it"};
  }
}

} // namespace lichen::renderer
