// SPDX-License-Identifier: MIT
// Multiple-kernels noises in a file: every fault that the checker must report by its code and the
// reader must reject, and what the shader's constants hold of them.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <cstring>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::smallestKernels()).value();
  return file;
}

json& sharedOf(GlbParts& parts) { return parts.extension()["noises"][0]["multipleKernels"]; }

/// Sets one float of the image, whose texels end the file.
void setFloat(GlbParts& parts, std::size_t kernel, std::size_t index, float value) {
  constexpr std::size_t kRow = 4 * kKernelTexels * sizeof(float);
  constexpr std::size_t kRows = 3; // two kernels, and below them the pattern
  std::memcpy(&parts.binary[parts.binary.size() - (kRows - kernel) * kRow + index * sizeof(float)],
              &value, sizeof value);
}

} // namespace

TEST_CASE("the example file of kernels has no faults, and is read as it was written") {
  CHECK(checkBundle(GlbParts(soundFile()).join()).empty());
  const Bundle bundle = parseBundle(soundFile(), "kernels").value();
  REQUIRE(bundle.noises.size() == 1);
  CHECK(bundle.noises[0] == example::smallestKernels().bundle.noises[0]);
}

TEST_CASE("every fault of what the kernels share is found") {
  example::checkFaults(
      soundFile(),
      {
          {"nothing shared", "required",
           [](GlbParts& p) { p.extension()["noises"][0].erase("multipleKernels"); }},
          {"a number", "type", [](GlbParts& p) { sharedOf(p) = 7; }},
          {"no size", "required", [](GlbParts& p) { sharedOf(p).erase("texelsPerTile"); }},
          {"no kernels", "range", [](GlbParts& p) { sharedOf(p)["kernels"] = 0; }},
          {"65 kernels", "range", [](GlbParts& p) { sharedOf(p)["kernels"] = 65; }},
          {"three kernels", "map-kernels", [](GlbParts& p) { sharedOf(p)["kernels"] = 3; }},
          {"more rings than kernels", "kernels-rings",
           [](GlbParts& p) { sharedOf(p)["rings"] = 3; }},
          {"a ring with a direction", "kernels-texels",
           [](GlbParts& p) { sharedOf(p)["rings"] = 2; }},
          {"too many cosines", "range", [](GlbParts& p) { sharedOf(p)["cosines"] = 97; }},
          {"four cosines", "map-kernels", [](GlbParts& p) { sharedOf(p)["cosines"] = 4; }},
          {"a pattern in a solid", "material-mapping",
           [](GlbParts& p) { p.use(0)["mapping"] = "solid"; }},
          {"no window", "required", [](GlbParts& p) { sharedOf(p).erase("window"); }},
          {"another window", "kernels-window", [](GlbParts& p) { sharedOf(p)["window"] = "box"; }},
          {"a sinc that is not upright", "kernels-texels",
           [](GlbParts& p) { sharedOf(p)["window"] = "sinc"; }},
          {"another spectrum", "spectrum", [](GlbParts& p) { sharedOf(p)["spectrum"] = "flat"; }},
          {"a pattern on a surface", "material-mapping",
           [](GlbParts& p) { p.use(0)["mapping"] = "surface"; }},
      });
}

TEST_CASE("every fault of an image of kernels is found") {
  const auto set = [](std::size_t kernel, std::size_t index, float value) {
    return [=](GlbParts& p) { setFloat(p, kernel, index, value); };
  };
  example::checkFaults(
      soundFile(),
      {
          {"no image", "required", [](GlbParts& p) { p.map(0, 0).erase("kernels"); }},
          {"no such image", "map-kernels-index", [](GlbParts& p) { p.map(0, 0)["kernels"] = 7; }},
          {"a huge frequency", "kernels-texels", set(0, 0, 20000.0f)},
          {"no columns", "kernels-texels", set(0, 2, 0.0f)},
          {"half a row", "kernels-texels", set(1, 3, 2.5f)},
          {"half a cube", "kernels-texels", set(0, 9, 0.5f)},
          {"no layers", "kernels-texels", set(0, 10, 0.0f)},
          {"a support of a thousand columns", "kernels-texels", set(0, 2, 32768.0f)},
          {"a support of a thousand cubes", "kernels-texels", set(0, 9, 32768.0f)},
          {"a support of a thousand layers", "kernels-texels", set(0, 10, 32768.0f)},
          {"a hundred thousand impacts, of cubes within reach", "kernels-texels",
           set(0, 9, 1600.0f)},
          {"no window along z", "kernels-texels", set(1, 11, 0.0f)},
          {"a matrix without an inverse", "kernels-texels", set(0, 4, 0.0f)},
          {"a huge matrix", "kernels-texels", set(0, 7, 1e6f)},
          {"a huge amplitude", "kernels-texels", set(1, 8, 2000.0f)},
          {"a huge colour", "kernels-texels", set(1, 23, -2000.0f)},
          {"half a cycle of a pattern", "kernels-texels", set(2, 8, 0.5f)},
          {"a huge wave of a pattern", "kernels-texels", set(2, 3, 2000.0f)},
      });
}

TEST_CASE("the constants of a noise and a material have the numbers of its kernels") {
  const Bundle bundle = parseBundle(soundFile(), "kernels").value();
  const shader::LichenKernelsNoise noise = kernelsPart(shaderNoise(bundle, 0));
  CHECK(noise.kernels == 2);
  CHECK(noise.rings == 1);
  CHECK(noise.cosines == 2);
  CHECK(noise.window == LICHEN_WINDOW_GABOR);
  Placement placement;
  placement.tileOriginX = 8 * 5 + 3;
  placement.tileOriginY = -8 - 1;
  const shader::LichenMaterial material =
      shaderMaterial(bundle, MaterialNoise(), placement).material;
  CHECK(material.cellI == 5);
  CHECK(material.offsetX == 3.0f);
  CHECK(material.cellJ == -2);
  CHECK(material.offsetY == 7.0f);
}
