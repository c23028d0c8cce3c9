// SPDX-License-Identifier: MIT
// `lichen bake --layers` and `lichen layer`.
#include "command_run.h"

#include <lichen/bundle_files.h>

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kSide = 128;

/// Whether a pixel is of the second material: discs on a grid, a third of the area.
bool isDisc(int x, int y) {
  const int dx = x % 32 - 16, dy = y % 32 - 16;
  return dx * dx + dy * dy < 108;
}

/// Dark and bright speckles, the bright ones in discs.
SrgbImage discs() {
  SrgbImage image = speckled(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int c = 0; c < 3; ++c) {
        float& value = image.values[std::size_t((y * kSide + x) * 3 + c)];
        value = (isDisc(x, y) ? 0.6f : 0.1f) + 0.3f * value;
      }
  return image;
}

SrgbImage painted() {
  SrgbImage image(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int c = 0; c < 3; ++c)
        image.values[std::size_t((y * kSide + x) * 3 + c)] = isDisc(x, y) ? 1.0f : 0.0f;
  return image;
}

} // namespace

TEST_CASE("a bake with labels makes a noise for each, with their colours and areas") {
  const Workplace workplace;
  const std::string photograph = workplace.write("coast.png", discs());
  const std::string labels = workplace.write("labels.png", painted());
  for (const std::string& which : {labels, std::string("2")}) {
    bake(workplace, photograph, "coast.glb", {"--layers", which});
    const Bundle bundle = readBundle(workplace.path("coast.glb")).value();
    REQUIRE(bundle.noises.size() == 3);
    const NoiseLayers& layers = *bundle.noises[0].layers;
    CHECK(layers.nodes[0].softness == 0.1);
    CHECK(layers.nodes[0].proportion == Approx(0.33).margin(0.03));
    CHECK(bundle.noises[2].method() == Method::tiling);
    // Speckles have a mean of some half of their range. Stored values are roots of light.
    const auto mean = [&](std::size_t noise) { return bundle.noises[noise].maps[0].mean[0]; };
    CHECK(mean(1) - mean(0) > 0.3);
    CHECK(bundle.materials.size() == 1);
    succeed({"check", workplace.path("coast.glb")});
  }
  CHECK_THAT(succeed({"inspect", workplace.path("coast.glb")}).output,
             Catch::Contains("      noises: coast, coast.layer2\n") &&
                 Catch::Contains("          softness: 0.1\n"));
}

TEST_CASE("layers are made of noises of several bundles, with the areas asked for") {
  const Workplace workplace;
  const std::string image = workplace.write("a.png", speckled(64, 64, 3));
  Arguments bundles;
  for (const std::string method : {"tiling", "texton", "multiple-kernels", "local-random-phase"})
    bundles.push_back(bake(workplace, image, method + ".glb",
                           {"--method", method, "--name", method, "--preview", "none"}));
  const std::string output = workplace.path("all.glb");
  succeed(Arguments{"layer"} + bundles + Arguments{"-o", output, "--shares", "4,3,2,1"});
  const Bundle bundle = readBundle(output).value();
  REQUIRE(bundle.noises.size() == 7); // with three index maps
  const std::vector<LayerNode>& nodes = bundle.noises[0].layers->nodes;
  CHECK(nodes[0].proportion == Approx(0.6));
  CHECK(nodes[1].proportion == Approx(0.5));
  CHECK(nodes[2].proportion == Approx(1.0 / 3.0));
  succeed({"synth", output, "-o", workplace.path("all.png"), "--size", "64"});

  // Any noise that may be a layer may be an index map.
  const Arguments two{"layer", bundles[0], bundles[1], "-o", output};
  for (const std::string& index : bundles)
    succeed(two + Arguments{"--index", index});
  checkRefusal({"layer", bundles[0], "-o", output}, kUsage, {"1 given; expected 2 to 4"});
  checkRefusals(two, std::vector<Refused>{
                         {{"--shares", "1"}, {"--shares: 1 for 2 bundles; expected one each"}},
                         {{"--shares", "1,500"}, {"--shares: a layer has 1, and all layers after it have 500"}},
                         {{"--index", "rings"}, {"rings"}, kBadInput}});
}

TEST_CASE("index maps are kernels where all layers have solids, and tiling elsewhere") {
  const Workplace workplace;
  const std::string image = workplace.write("a.png", speckled(64, 64, 3));
  const std::string output = workplace.path("out.glb");
  const auto baked = [&](const std::string& method) {
    return bake(workplace, image, method + ".glb", {"--method", method, "--preview", "none"});
  };
  const std::string tiling = baked("tiling"), kernels = baked("multiple-kernels");
  const auto indexOf = [&](const std::string& second) {
    succeed({"layer", kernels, second, "-o", output});
    return readBundle(output).value().noises[2].method();
  };
  CHECK(indexOf(kernels) == Method::multipleKernels);
  CHECK(indexOf(tiling) == Method::tiling);
}

TEST_CASE("a bake with layers does not advise a method that layers refuse") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", brickwork(128));
  const std::string output = workplace.path("bricks.glb");
  const Arguments bakeOf{"bake", bricks, "-o", output};
  const nlohmann::json tiling = jsonOf(bakeOf + Arguments{"--layers", "2", "--preview", "none"});
  CHECK(tiling.at("verdict").at("risk") == "structure");
  CHECK_THAT(tiling.dump(), Catch::Contains("a photograph without joints") &&
                                !Catch::Contains("--method quilting"));
  checkRefusals(
      bakeOf,
      std::vector<Refused>{
          {{"--layers", "2", "--method", "quilting"},
           {"--layers: layers do not take the method quilting; expected --method tiling, texton, "
            "local-random-phase or multiple-kernels"}},
          {{"--layers", bricks, "--guide", "0.5"},
           {"--layers: layers do not take the method quilting"}}});
}

TEST_CASE("layers that do not fit together are refused by name") {
  const Workplace workplace;
  const std::string image = workplace.write("a.png", speckled(256, 256, 3));
  const auto baked = [&](const std::string& name, const Arguments& more) {
    return bake(workplace, image, name, Arguments{"--preview", "none"} + more);
  };
  const std::string one = baked("one.glb", {}), large = baked("large.glb", {"--tile", "2"}),
                    wide = baked("wide.glb", {"--crop", "0,0,256,128"}),
                    quilting = baked("quilting.glb", {"--method", "quilting"});
  const std::string output = workplace.path("out.glb");
  const std::string quilted =
      "quilting.glb: the noise \"a\" has the method quilting, which layers do not take; expected "
      "tiling, texton, local-random-phase or multiple-kernels";
  checkRefusals({"layer", "-o", output},
                std::vector<Refused>{
                    {{one, large}, {"large.glb: the noise \"a\" has tiles of 2", "expected 1"}},
                    {{one, wide}, {"wide.glb: the noise \"a\" has tiles of another shape"}},
                    {{one, quilting}, {quilted}},
                    {{quilting, one}, {quilted}}});
  checkRefusals(
      {"bake", image, "-o", output},
      std::vector<Refused>{{{"--layers", "5"}, {"--layers 5", "2 to 4, or a picture"}},
                           {{"--layers", workplace.path("none.png")}, {"none.png"}, kBadInput}});
  const Ended ended = runLichen({"bake", workplace.write("a_diff.png", speckled(256, 256, 3)),
                                 workplace.write("a_height.png", speckled(256, 256, 3)), "-o",
                                 output, "--layers", "2"});
  CHECK(ended.code == kUsage);
  CHECK_THAT(ended.errors, Catch::Contains("2 layers with the map height") &&
                               Catch::Contains("16 images") &&
                               Catch::Contains("leave its file out"));
}
