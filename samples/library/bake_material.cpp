// SPDX-License-Identifier: MIT
// bake_material OUT.glb: pixels in memory -> a material, its noise at a point, a glTF file.
#include <lichen/bake_material.h>
#include <lichen/noise_evaluator.h>

#include <cstdio>
#include <random>
#include <utility>

int main(int argc, char** argv) {
  const auto fail = [](const lichen::Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return 1;
  };
  if (argc != 2)
    return fail({lichen::ErrorKind::usage, "usage: bake_material OUT.glb"});

  lichen::SrgbImage sand(256, 256, 3); // a photograph of yours; values are sRGB codes over 255
  std::mt19937 random(1);
  std::normal_distribution<float> grain(0.0f, 0.05f);
  for (std::size_t k = 0; k < sand.values.size(); ++k)
    sand.values[k] = 0.6f - 0.1f * float(k % 3) + grain(random);

  lichen::BakeObserver observer;
  observer.note = [](const std::string& line) { std::printf("%s\n", line.c_str()); };
  observer.progress = [](std::string_view, double) { return true; }; // false stops the bake
  lichen::Photograph photograph;
  photograph.name = "sand.png"; // says which map it is, as in a folder
  photograph.image.pixels = std::move(sand);
  auto baked = lichen::bakeMaterial({photograph}, lichen::BakeOptions{}, observer);
  if (!baked)
    return fail(baked.error());
  std::printf("%s\n", baked.value().judgement.verdict.worst.sentence.c_str());

  const lichen::Bundle& bundle = baked.value().bundle;
  const auto noise = lichen::NoiseEvaluator::create(bundle, *bundle.materials[0]);
  if (!noise)
    return fail(noise.error());
  const auto light = noise.value()->evaluateUv(0, {{1000.75f, 0.5f}, {}, {}});
  std::printf("%.3f %.3f %.3f\n", double(light[0]), double(light[1]), double(light[2]));

  const auto file = lichen::withPreviews(bundle, lichen::PreviewShape::sphere, "bake_material");
  const auto written = file ? lichen::writeBundle(argv[1], file.value()) : file.error();
  return written ? 0 : fail(written.error());
}
