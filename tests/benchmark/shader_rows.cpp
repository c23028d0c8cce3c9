// SPDX-License-Identifier: MIT
// Cost of the shaders, measured in alternating frames: tiling and textons relative to one plain
// trilinear fetch, textons on a surface and triplanar tiling relative to their costs on texture
// coordinates, and tiling's quality levels relative to the highest.
#include "exemplars.h"
#include "rows.h"
#include "screen_pass.h"

#include <lichen/bundle_writer.h>
#include <lichen/image_io.h>
#include <lichen/texton_mix.h>

#include <materials.h>
#include <plain.frag.h>
#include <plugin_host.h>
#include <stdexcept>
#include <surface.frag.h>
#include <synthetic_noise.h>
#include <synthetic_texton.h>
#include <texton.frag.h>
#include <texton.frag.mixed.h>
#include <tiling.frag.gaussian.h>
#include <tiling.frag.joint.h>
#include <tiling.frag.one_tap.h>
#include <tiling.frag.sharp.h>
#include <tiling.frag.turned.h>
#include <tiling.frag.two_taps.h>
#include <triplanar.frag.h>
#include <view.vert.h>

namespace lichen::bench {
namespace {

constexpr std::uint32_t kWidth = 1920;
constexpr std::uint32_t kHeight = 1080;
constexpr int kExemplarSide = 256;
constexpr int kFrames = 31;
/// A pipeline's first draws compile it.
constexpr int kWarmUpFrames = 3;

std::vector<std::byte> exemplarGlb(const TilingOptions& options) {
  BundleFile file;
  file.bundle = bakedBundle(exemplars::rust(kExemplarSide), options);
  PreviewImages preview;
  preview.baseColor = encodePng(SrgbImage(1, 1, 3), 8).value();
  file.previews = {preview};
  file.shape = PreviewShape::none;
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  if (!glb)
    throw std::runtime_error(glb.error().message);
  return std::move(glb).value();
}

/// Uploads the bundle and writes its uniforms.
void prepare(test::PluginHost& host, LichenMapping mapping = LICHEN_MAPPING_UV,
             double blendSharpness = 1.0, std::uint32_t tileRotation = 0) {
  LichenUniformInfo uniforms;
  LICHEN_INIT(uniforms, LICHEN_STRUCTURE_UNIFORM_INFO);
  uniforms.overrides =
      LICHEN_OVERRIDE_MAPPING | LICHEN_OVERRIDE_BLEND_SHARPNESS | LICHEN_OVERRIDE_TILE_ROTATION;
  uniforms.mapping = mapping;
  uniforms.blendSharpness = blendSharpness;
  uniforms.tileRotation = tileRotation;
  const std::vector<test::Point> point(1);
  (void)host.evaluate(test::committedShader("tiling_evaluate.comp"), 0, uniforms, point);
}

/// A shader and the noise that it draws.
struct Drawn {
  const char* name;
  ScreenPass& pass;
  VkDescriptorSet set;
};

Row ratioRow(const std::string& what, double target, Drawn noise, Drawn unit,
             const DeviceImage& image, const ScreenView& view, const std::string& device) {
  std::vector<double> noiseSeconds, unitSeconds;
  for (int frame = -kWarmUpFrames; frame < kFrames; ++frame) {
    const double unitTime = unit.pass.draw(image, unit.set, view);
    const double noiseTime = noise.pass.draw(image, noise.set, view);
    if (frame < 0)
      continue;
    unitSeconds.push_back(unitTime);
    noiseSeconds.push_back(noiseTime);
  }
  const double seconds = median(unitSeconds);
  char note[160];
  std::snprintf(note, sizeof note, "%s; %s %.1f ms, medians of %d", device.c_str(), unit.name,
                1e3 * seconds, kFrames);
  return {what, median(noiseSeconds) / seconds, target, "", note};
}

/// A method or kind of table, a noise of that kind, and the shader with only its code.
struct Kind {
  const char* name;
  std::vector<std::byte> glb;
  std::span<const std::uint32_t> fragment;
  double flatTarget;
  double floorTarget;
};

TilingOptions bakedWith(GaussianOnly gaussian) {
  TilingOptions options;
  options.gaussian = gaussian;
  return options;
}

/// Bilinear textons that reach 64 texels, with the default of 30 impacts.
test::SyntheticTexton textons() {
  return {.coefficientsX = 63,
          .coefficientsY = 63,
          .mipLevels = 4,
          .texelsPerTileX = kExemplarSide,
          .texelsPerTileY = kExemplarSide};
}

std::vector<std::byte> textonGlb() { return test::syntheticTextonGlb(textons()); }

/// A mix with as many steps as `lichen mix` makes from two exemplars. It goes from one to the other
/// over four tiles.
std::vector<std::byte> mixGlb() {
  test::SyntheticTexton texton = textons();
  texton.steps = TextonMixOptions{}.steps;
  BundleFile file = test::syntheticTextonBundle(texton);
  file.bundle.materials[0]->mix = {
      .source = MixSource::direction, .start = {0.0, 0.0}, .end = {4.0, 0.0}};
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  if (!glb)
    throw std::runtime_error(glb.error().message);
  return std::move(glb).value();
}

/// One texel per pixel.
constexpr ScreenView kFlat{float(kWidth) / kExemplarSide, float(kHeight) / kExemplarSide, 1.0f};
/// Slightly less than one texel: surface coordinates are rounded, and a pixel larger than a texel
/// reads two mips.
constexpr ScreenView kSurfaceFlat{0.999f * kFlat.uvPerScreenX, 0.999f * kFlat.uvPerScreenY, 1.0f};
/// A quarter of a tile per pixel. From this size on, the lowest tiling level uses one tap.
constexpr ScreenView kFar{0.25f * float(kWidth), 0.25f * float(kHeight), 1.0f};
/// A floor with 1/4 of a texel per pixel at the near edge; the far edge is 16 times as far.
constexpr ScreenView kFloor{0.25f * kFlat.uvPerScreenX, 0.25f * kFlat.uvPerScreenX, 16.0f};

VkDescriptorSetLayout layoutOf(const test::PluginHost& host) {
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  if (lichenVulkanGetSetLayout(host.assets(), 0, &layout) != LICHEN_SUCCESS)
    throw std::runtime_error("no set layout");
  return layout;
}

/// All ratios are relative to the plain fetch of the image of `unit`.
void appendRows(std::vector<Row>& rows, const Kind& kind, const test::PluginHost& unit,
                VulkanDevice& gpu, const DeviceImage& image) {
  test::PluginHost host(gpu, kind.glb);
  prepare(host);
  ScreenPass plain(gpu, view_vert, plain_frag, layoutOf(host));
  ScreenPass noise(gpu, view_vert, kind.fragment, layoutOf(host));
  const Drawn drawn{kind.name, noise, host.set()};
  const Drawn fetched{"plain", plain, unit.set()};
  const std::string device = gpu.properties().deviceName;
  rows.push_back(ratioRow(std::string(kind.name) + " over one plain fetch, 1920 x 1080, flat",
                          kind.flatTarget, drawn, fetched, image, kFlat, device));
  rows.push_back(
      ratioRow("the same, perspective", kind.floorTarget, drawn, fetched, image, kFloor, device));
}

void appendSurfaceRows(std::vector<Row>& rows, VulkanDevice& gpu, const DeviceImage& image) {
  constexpr double kTarget = 3.0;
  test::PluginHost plane(gpu, textonGlb());
  test::PluginHost surface(gpu, textonGlb());
  prepare(plane);
  prepare(surface, LICHEN_MAPPING_SURFACE);
  ScreenPass onPlane(gpu, view_vert, texton_frag, layoutOf(plane));
  ScreenPass onSurface(gpu, view_vert, surface_frag, layoutOf(surface));
  const Drawn unit{"texton", onPlane, plane.set()};
  const Drawn drawn{"surface texton", onSurface, surface.set()};
  const std::string device = gpu.properties().deviceName;
  rows.push_back(ratioRow("surface texton, 60 impacts, over texton, 30 impacts, 1920 x 1080, flat",
                          kTarget, drawn, unit, image, kSurfaceFlat, device));
  rows.push_back(ratioRow("the same, perspective", kTarget, drawn, unit, image, kFloor, device));
}

void appendTriplanarRow(std::vector<Row>& rows, const Kind& kind, VulkanDevice& gpu,
                        const DeviceImage& image) {
  constexpr double kTarget = 2.2;
  test::PluginHost plane(gpu, kind.glb);
  test::PluginHost planes(gpu, kind.glb);
  prepare(plane);
  prepare(planes, LICHEN_MAPPING_TRIPLANAR);
  ScreenPass onPlane(gpu, view_vert, kind.fragment, layoutOf(plane));
  ScreenPass onSphere(gpu, view_vert, triplanar_frag, layoutOf(planes));
  rows.push_back(ratioRow("triplanar tiling on a sphere over tiling, 1920 x 1080", kTarget,
                          {"triplanar tiling", onSphere, planes.set()},
                          {"tiling", onPlane, plane.set()}, image, kSurfaceFlat,
                          gpu.properties().deviceName));
}

/// The quality levels of tiling, and a sharper blend at the highest level.
void appendLevelRows(std::vector<Row>& rows, const Kind& kind, VulkanDevice& gpu,
                     const DeviceImage& image) {
  constexpr double kTarget = 1.0; // a level must be cheaper
  constexpr double kSharpTarget = 1.25, kSharpness = 4.0;
  test::PluginHost plain(gpu, kind.glb);
  test::PluginHost sharp(gpu, kind.glb);
  prepare(plain);
  prepare(sharp, LICHEN_MAPPING_UV, kSharpness);
  const auto row = [&](const char* what, double target, std::span<const std::uint32_t> fragment,
                       const test::PluginHost& host, const ScreenView& view) {
    ScreenPass three(gpu, view_vert, kind.fragment, layoutOf(plain));
    ScreenPass level(gpu, view_vert, fragment, layoutOf(host));
    rows.push_back(ratioRow(what, target, {what, level, host.set()},
                            {"three taps", three, plain.set()}, image, view,
                            gpu.properties().deviceName));
  };
  row("tiling with two taps over three, 1920 x 1080, flat", kTarget, tiling_frag_two_taps, plain,
      kFlat);
  row("the same, perspective", kTarget, tiling_frag_two_taps, plain, kFloor);
  row("tiling with one tap from 1/4 tile a pixel on over three, from there", kTarget,
      tiling_frag_one_tap, plain, kFar);
  row("tiling with blend sharpness 4 over 1, flat", kSharpTarget, tiling_frag_sharp, sharp, kFlat);
}

/// Rotated tiles relative to unrotated ones, for colours and for slopes, which are decoded tile by
/// tile.
void appendRotationRows(std::vector<Row>& rows, const Kind& colors, VulkanDevice& gpu,
                        const DeviceImage& image) {
  constexpr double kUnusedTarget = 1.1, kColorTarget = 1.3, kSlopeTarget = 2.5;
  const test::SyntheticMap slopeMap{2, kExemplarSide, kExemplarSide, false, 8};
  const auto row = [&](const std::string& what, double target, const std::vector<std::byte>& glb,
                       std::uint32_t steps) {
    test::PluginHost plain(gpu, glb);
    test::PluginHost turned(gpu, glb);
    prepare(plain);
    prepare(turned, LICHEN_MAPPING_UV, 1.0, steps);
    ScreenPass without(gpu, view_vert, tiling_frag_joint, layoutOf(plain));
    ScreenPass with(gpu, view_vert, tiling_frag_turned, layoutOf(turned));
    rows.push_back(ratioRow(what, target, {what.c_str(), with, turned.set()},
                            {"not turned", without, plain.set()}, image, kFlat,
                            gpu.properties().deviceName));
  };
  const std::vector<std::byte> slopes = test::syntheticGlb(std::span(&slopeMap, 1));
  row("colours, code of turned tiles that is not used, over none, 1920 x 1080, flat", kUnusedTarget,
      colors.glb, 0);
  row("colours, tiles turned in 2 steps over not turned", kColorTarget, colors.glb, 2);
  row("colours, tiles turned in 4 steps", kColorTarget, colors.glb, 4);
  row("colours, tiles turned freely", kColorTarget, colors.glb, kMostTileRotation);
  row("slopes, code of turned tiles that is not used", kUnusedTarget, slopes, 0);
  row("slopes, tiles turned in 2 steps", kSlopeTarget, slopes, 2);
  row("slopes, tiles turned in 4 steps", kSlopeTarget, slopes, 4);
  row("slopes, tiles turned freely", kSlopeTarget, slopes, kMostTileRotation);
}

std::vector<Row> measure() {
  Result<std::unique_ptr<VulkanDevice>> device = VulkanDevice::create({});
  if (!device)
    throw std::runtime_error(device.error().message);
  VulkanDevice& gpu = *device.value();
  DeviceImageInfo info;
  info.format = kScreenFormat;
  info.extent = {kWidth, kHeight, 1};
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  Result<DeviceImage> image = gpu.createImage(info);
  if (!image)
    throw std::runtime_error(image.error().message);
  // Mixes have the targets of one texton.
  const Kind kinds[] = {
      {"tiling with joint table", exemplarGlb(bakedWith(GaussianOnly::no)), tiling_frag_joint, 3.6,
       4.3},
      {"tiling, Gaussian only", exemplarGlb(bakedWith(GaussianOnly::yes)), tiling_frag_gaussian,
       2.5, 3.2},
      {"texton, 30 impacts", textonGlb(), texton_frag, 42.0, 50.0},
      {"mix of textons, 30 impacts", mixGlb(), texton_frag_mixed, 42.0, 50.0},
  };
  test::PluginHost unit(gpu, kinds[0].glb);
  prepare(unit);
  std::vector<Row> rows;
  for (const Kind& kind : kinds)
    appendRows(rows, kind, unit, gpu, image.value());
  appendSurfaceRows(rows, gpu, image.value());
  appendTriplanarRow(rows, kinds[0], gpu, image.value());
  appendLevelRows(rows, kinds[0], gpu, image.value());
  appendRotationRows(rows, kinds[0], gpu, image.value());
  return rows;
}

} // namespace

std::vector<Row> shaderRows() {
  try {
    return measure();
  } catch (const std::exception& problem) {
    return {{"tiling with joint table over one plain fetch, 1920 x 1080", 0.0, 3.6, "",
             problem.what(), true}};
  }
}

} // namespace lichen::bench
