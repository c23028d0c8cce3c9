// SPDX-License-Identifier: MIT
// The number and arrangement of the impacts that `lichen` shows for a texton noise: the material's,
// or those given to `synth`.
#include "command_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

/// A low-contrast grey grain, so that no value of its noise is clamped.
SrgbImage faintGrain() {
  SrgbImage image = speckled(64, 64, 1);
  for (float& value : image.values)
    value = 0.5f + 0.1f * (value - 0.5f);
  return image;
}

std::string bakeTexton(const Workplace& workplace, const std::string& name,
                       const Arguments& more = {}) {
  return bake(workplace, workplace.write("grain.png", encodePng(faintGrain(), 16).value()), name,
              Arguments{"--method", "texton", "--support", "16"} + more);
}

/// Returns the fourth central moment over the squared variance, minus 3.
double excessKurtosis(const std::vector<float>& values) {
  double mean = 0.0, second = 0.0, fourth = 0.0;
  for (const float value : values)
    mean += double(value) / double(values.size());
  for (const float value : values) {
    const double square = std::pow(double(value) - mean, 2.0);
    second += square / double(values.size());
    fourth += square * square / double(values.size());
  }
  return fourth / (second * second) - 3.0;
}

/// Returns the base colour's PNG in a GLB.
SrgbImage previewOf(const Workplace& workplace, const std::string& name) {
  const std::string file = workplace.read(name);
  std::uint32_t textBytes = 0;
  std::memcpy(&textBytes, file.data() + 12, sizeof textBytes);
  const auto gltf = nlohmann::json::parse(file.substr(20, textBytes));
  const nlohmann::json& view =
      gltf.at("bufferViews").at(gltf.at("images").at(0).at("bufferView").get<std::size_t>());
  const std::size_t chunk = 20 + textBytes + 8;
  workplace.write("preview.png", file.substr(chunk + view.value("byteOffset", std::size_t(0)),
                                             view.at("byteLength").get<std::size_t>()));
  return std::get<SrgbImage>(readImage(workplace.path("preview.png")).value().pixels);
}

} // namespace

TEST_CASE("synth uses the material's impacts and points, unless options override them") {
  const Workplace workplace;
  const std::string plain = bakeTexton(workplace, "plain.glb");
  const std::string sparse =
      bakeTexton(workplace, "sparse.glb", {"--impacts", "2", "--points", "poisson"});
  const Arguments size{"--size", "64x64"};
  const SrgbImage usual = synth(workplace, plain, size);
  const SrgbImage own = synth(workplace, sparse, size);
  CHECK(own.values != usual.values);
  CHECK(
      own.values ==
      synth(workplace, plain, {"--size", "64x64", "--impacts", "2", "--points", "poisson"}).values);
  CHECK(usual.values ==
        synth(workplace, sparse, {"--size", "64x64", "--impacts", "30", "--points", "stratified"})
            .values);
}

TEST_CASE("the preview, the measures and the report use the material's impacts") {
  const Workplace workplace;
  const std::string input = workplace.path("grain.png");
  const Arguments few{"--impacts", "1",        "--points",
                      "poisson",   "--report", workplace.path("report.html")};
  const std::string usual = bakeTexton(workplace, "usual.glb");
  const std::string sparse = bakeTexton(workplace, "sparse.glb", few);
  // With one impact on average, a point has none with probability 1/e and shows the mean colour.
  CHECK(excessKurtosis(previewOf(workplace, "sparse.glb").values) > 1.0);
  CHECK(std::abs(excessKurtosis(previewOf(workplace, "usual.glb").values)) < 0.3);
  const auto colorDistance = [&](const std::string& bundle) {
    const auto report =
        nlohmann::json::parse(runLichen({"compare", input, bundle, "--json"}).output);
    return report.at("measures").at(0).at("value").get<double>();
  };
  const double found = colorDistance(sparse);
  CHECK(found > 1.3 * colorDistance(usual));
  const std::string page = workplace.read("report.html");
  char shown[16];
  std::snprintf(shown, sizeof shown, "%.3g", found);
  CHECK_THAT(page, Catch::Contains(std::string(">") + shown + "<"));
  succeed({"merge", sparse, "-o", workplace.path("merged.glb")});
  CHECK(previewOf(workplace, "merged.glb").values == previewOf(workplace, "sparse.glb").values);
}

TEST_CASE("the error for an option of another method names that method") {
  const Workplace workplace;
  const std::string texton = bakeTexton(workplace, "grain.glb");
  const std::string tiling =
      bake(workplace, workplace.write("moss.png", smoothGrey(16)), "moss.glb");
  const auto synthOf = [&](const std::string& bundle) {
    return Arguments{"synth", bundle, "-o", workplace.path("new.png")};
  };
  checkRefusals(
      synthOf(tiling),
      std::vector<Refused>{{{"--impacts", "20"}, {"--impacts", "texton", "'moss'", "tiling"}},
                           {{"--points", "poisson"}, {"--points", "texton", "'moss'", "tiling"}}});
  checkRefusals(
      synthOf(texton),
      std::vector<Refused>{
          {{"--sharpness", "2"}, {"--sharpness", "tiling", "'grain'", "texton"}},
          {{"--tile-rotation", "4"}, {"--tile-rotation", "tiling", "'grain'", "texton"}}});
}

TEST_CASE("check finds no fault in textons of any order, precision or set") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("rock"));
  workplace.write("rock/rock_color.png", speckled(24, 20, 3));
  workplace.write("rock/rock_normal.png", smooth(16));
  workplace.write("rock/rock_rough.png", smoothGrey(12));
  for (const char* order : {"0", "1", "3"})
    for (const char* precision : {"8", "16"}) {
      INFO("order " << order << ", precision " << precision);
      const std::string bundle = bake(workplace, workplace.path("rock"), "rock.glb",
                                      {"--method", "texton", "--support", "12", "--order", order,
                                       "--precision", precision, "--preview", "none"});
      CHECK_THAT(succeed({"check", bundle}).output, Catch::EndsWith(": 0 errors, 0 warnings\n"));
    }
}
