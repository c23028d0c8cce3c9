// SPDX-License-Identifier: MIT
// Cost of the tiling shader in units of one plain trilinear fetch, frame by frame in turn.
#include "exemplars.h"
#include "rows.h"
#include "screen_pass.h"

#include <lichen/bundle_writer.h>
#include <lichen/image_io.h>

#include <materials.h>
#include <plain.frag.h>
#include <plugin_host.h>
#include <stdexcept>
#include <tiling.frag.gaussian.h>
#include <tiling.frag.joint.h>
#include <tiling.frag.separable.h>
#include <view.vert.h>

namespace lichen::bench {
namespace {

constexpr std::uint32_t kWidth = 1920;
constexpr std::uint32_t kHeight = 1080;
constexpr int kExemplarSide = 256;
constexpr int kFrames = 31;
/// The first draws of a pipeline compile it.
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
void prepare(test::PluginHost& host) {
  LichenUniformInfo uniforms;
  LICHEN_INIT(uniforms, LICHEN_STRUCTURE_UNIFORM_INFO);
  const std::vector<test::Point> point(1);
  (void)host.evaluate(test::committedShader("tiling_evaluate.comp"), 0, uniforms, point);
}

Row ratioRow(const std::string& what, double target, ScreenPass& tiling, ScreenPass& plain,
             const DeviceImage& image, VkDescriptorSet set, const ScreenView& view,
             const std::string& device) {
  std::vector<double> tilingSeconds, plainSeconds;
  for (int frame = -kWarmUpFrames; frame < kFrames; ++frame) {
    const double plainTime = plain.draw(image, set, view);
    const double tilingTime = tiling.draw(image, set, view);
    if (frame < 0)
      continue;
    plainSeconds.push_back(plainTime);
    tilingSeconds.push_back(tilingTime);
  }
  const double unit = median(plainSeconds);
  char note[160];
  std::snprintf(note, sizeof note, "%s; plain %.1f ms, medians of %d", device.c_str(), 1e3 * unit,
                kFrames);
  return {what, median(tilingSeconds) / unit, target, "", note};
}

/// A kind of table, how its noise is baked, and the shader that has its code alone.
struct Kind {
  const char* name;
  TilingOptions baking;
  std::span<const std::uint32_t> fragment;
  double flatTarget;
  double floorTarget;
};

TilingOptions bakedWith(LookupTable lut, GaussianOnly gaussian) {
  TilingOptions options;
  options.lut = lut;
  options.gaussian = gaussian;
  return options;
}

void appendRows(std::vector<Row>& rows, const Kind& kind, HeadlessDevice& gpu,
                const DeviceImage& image) {
  test::PluginHost host(gpu, exemplarGlb(kind.baking));
  prepare(host);
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  if (lichenVulkanGetSetLayout(host.assets(), 0, &layout) != LICHEN_SUCCESS)
    throw std::runtime_error("no set layout");
  ScreenPass plain(gpu, view_vert, plain_frag, layout);
  ScreenPass tiling(gpu, view_vert, kind.fragment, layout);
  // Flat: one texel a pixel. Perspective: a floor, 1/4 of a texel a pixel at the near edge, 16
  // times as far at the other.
  const ScreenView flat{float(kWidth) / kExemplarSide, float(kHeight) / kExemplarSide, 1.0f};
  const ScreenView floor{0.25f * flat.uvPerScreenX, 0.25f * flat.uvPerScreenX, 16.0f};
  const std::string device = gpu.properties().deviceName;
  rows.push_back(ratioRow(std::string(kind.name) + " over one plain fetch, 1920 x 1080, flat",
                          kind.flatTarget, tiling, plain, image, host.set(), flat, device));
  rows.push_back(ratioRow("the same, perspective", kind.floorTarget, tiling, plain, image,
                          host.set(), floor, device));
}

std::vector<Row> measure() {
  Result<std::unique_ptr<HeadlessDevice>> device = HeadlessDevice::create({});
  if (!device)
    throw std::runtime_error(device.error().message);
  HeadlessDevice& gpu = *device.value();
  DeviceImageInfo info;
  info.format = kScreenFormat;
  info.extent = {kWidth, kHeight, 1};
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  Result<DeviceImage> image = gpu.createImage(info);
  if (!image)
    throw std::runtime_error(image.error().message);
  // Separable tables have no targets of their own: those of the joint one.
  const Kind kinds[] = {{"tiling with joint table", bakedWith(LookupTable::joint, GaussianOnly::no),
                         tiling_frag_joint, 3.6, 4.3},
                        {"tiling with separable table",
                         bakedWith(LookupTable::separable, GaussianOnly::no), tiling_frag_separable,
                         3.6, 4.3},
                        {"tiling, Gaussian only", bakedWith(LookupTable::joint, GaussianOnly::yes),
                         tiling_frag_gaussian, 2.5, 3.2}};
  std::vector<Row> rows;
  for (const Kind& kind : kinds)
    appendRows(rows, kind, gpu, image.value());
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
