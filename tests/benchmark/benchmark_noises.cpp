// SPDX-License-Identifier: MIT
#include "benchmark_noises.h"

#include "exemplars.h"
#include "shader_frames.h"

#include <lichen/bundle_merge.h>
#include <lichen/bundle_writer.h>
#include <lichen/image_io.h>
#include <lichen/index_map.h>
#include <lichen/texton_mix.h>

#include <materials.h>
#include <stdexcept>
#include <synthetic_noise.h>
#include <synthetic_texton.h>

namespace lichen::bench {
namespace {

std::vector<std::byte> encoded(const BundleFile& file) {
  Result<std::vector<std::byte>> glb = encodeGlb(file);
  if (!glb)
    throw std::runtime_error(glb.error().message);
  return std::move(glb).value();
}

/// A GLB with previews of one pixel.
std::vector<std::byte> bundleGlb(Bundle bundle) {
  BundleFile file;
  file.bundle = std::move(bundle);
  PreviewImages preview;
  preview.baseColor = encodePng(SrgbImage(1, 1, 3), 8).value();
  file.previews = {preview};
  file.shape = PreviewShape::none;
  return encoded(file);
}

test::SyntheticTexton textons() {
  return {.coefficientsX = 63,
          .coefficientsY = 63,
          .mipLevels = 4,
          .texelsPerTileX = kShaderExemplarSide,
          .texelsPerTileY = kShaderExemplarSide};
}

LichenVulkanInfo infoFor(const VulkanDevice& gpu, const NoiseUse& use) {
  LichenVulkanInfo info = test::defaultVulkanInfo(gpu);
  info.flags = use.isLayered ? LICHEN_VULKAN_LAYERS : 0;
  return info;
}

} // namespace

std::vector<std::byte> tilingGlb(GaussianOnly gaussian) {
  TilingOptions options;
  options.gaussian = gaussian;
  return bundleGlb(bakedBundle(exemplars::rust(kShaderExemplarSide), options));
}

std::vector<std::byte> textonGlb() { return test::syntheticTextonGlb(textons()); }

std::vector<std::byte> localRandomPhaseGlb(double structure) {
  LocalRandomPhaseOptions options;
  options.structure = structure;
  return bundleGlb(localRandomPhaseBundle(exemplars::rust(kShaderExemplarSide), options));
}

std::vector<std::byte> multipleKernelsGlb() {
  return bundleGlb(multipleKernelsBundle(exemplars::rust(kShaderExemplarSide)));
}

std::vector<std::byte> layeredGlb() {
  const Bundle below = bakedBundle(exemplars::rust(kShaderExemplarSide));
  const Bundle above = bakedBundle(exemplars::granite(kShaderExemplarSide));
  SpectrumPicture patches; // about five across a tile
  patches.width = patches.height = 17;
  for (int y = -8; y <= 8; ++y)
    for (int x = -8; x <= 8; ++x)
      patches.amplitudes.push_back(x * x + y * y > 1 && x * x + y * y <= 25 ? 1.0f : 0.0f);
  const Bundle index = bakeIndexMap(patches, 1.0, false).value();
  const std::array noises{BundledNoise{&below, 0}, BundledNoise{&above, 0}};
  const std::array indices{BundledNoise{&index, 0}};
  const std::vector nodes{LayerNode{0, 0.5, 0.2, {false, 0}, {false, 1}}};
  return bundleGlb(layerNoises("layered", noises, indices, nodes).value());
}

std::vector<std::byte> bricksGlb() {
  return bundleGlb(localRandomPhaseBundle(exemplars::bricks(kShaderExemplarSide)));
}

std::vector<std::byte> quiltingGlb() {
  return bundleGlb(quiltingBundle(exemplars::bricks(kShaderExemplarSide)));
}

std::vector<std::byte> mixGlb() {
  test::SyntheticTexton texton = textons();
  texton.steps = TextonMixOptions{}.steps;
  BundleFile file = test::syntheticTextonBundle(texton);
  file.bundle.materials[0]->mix = {
      .source = MixSource::direction, .start = {0.0, 0.0}, .end = {4.0, 0.0}};
  return encoded(file);
}

std::vector<std::byte> slopeGlb() {
  const test::SyntheticMap slopes{2, kShaderExemplarSide, kShaderExemplarSide, false, 5};
  return test::syntheticGlb(std::span(&slopes, 1));
}

ReadyNoise::ReadyNoise(VulkanDevice& gpu, const std::vector<std::byte>& glb, const NoiseUse& use)
    : host_(gpu, glb, infoFor(gpu, use)) {
  test::MaterialUse material = host_.use();
  material.parameters.mapping = use.mapping;
  material.parameters.tileRotation = use.tileRotation;
  const std::vector<test::Point> point(1);
  // The first run uploads the noise.
  (void)host_.evaluate(test::committedShader("tiling_evaluate.comp"), 0, material, point);
}

} // namespace lichen::bench
