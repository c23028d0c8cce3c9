// SPDX-License-Identifier: MIT
// bake_and_evaluate PHOTOGRAPH OUT.glb: a photograph -> a bundle, and the noise at four points.
#include <lichen/bundle_writer.h>
#include <lichen/material_set.h>
#include <lichen/noise_evaluator.h>
#include <lichen/tiling.h>

#include <cstdio>

int main(int argc, char** argv) {
  const auto fail = [](const lichen::Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return 1;
  };
  if (argc != 3)
    return fail({lichen::ErrorKind::usage, "usage: bake_and_evaluate PHOTOGRAPH OUT.glb"});

  const std::filesystem::path inputs[] = {argv[1]};
  const auto set = lichen::readMaterialSet(inputs, {});
  if (!set)
    return fail(set.error());
  auto baked = lichen::bakeTiling("example", set.value().maps, {});
  if (!baked)
    return fail(baked.error());

  lichen::BundleFile file;
  file.bundle.tables = std::move(baked.value().tables);
  file.bundle.noises = {std::move(baked.value().noise)};
  file.bundle.materials = {lichen::MaterialNoise{}}; // noise 0, by texture coordinates
  file.previews.resize(1);                           // no textures for other viewers
  file.shape = lichen::PreviewShape::none;
  if (const auto written = lichen::writeBundle(argv[2], file); !written)
    return fail(written.error());

  const auto noise = lichen::NoiseEvaluator::create(file.bundle, *file.bundle.materials[0]);
  if (!noise)
    return fail(noise.error());
  for (const float u : {0.0f, 0.25f, 0.5f, 1000.75f}) {
    const auto light = noise.value()->evaluateUv(0, {{u, 0.5f}, {}, {}});
    std::printf("(%g, 0.5): %.3f %.3f %.3f\n", double(u), double(light[0]), double(light[1]),
                double(light[2]));
  }
}
