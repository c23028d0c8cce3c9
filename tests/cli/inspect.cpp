// SPDX-License-Identifier: MIT
// `lichen inspect` on bundles whose contents are known.
#include "bundle_example.h"
#include "command_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kSide = 24;

nlohmann::json inspected(const std::string& bundle) { return jsonOf({"inspect", bundle}); }

std::string pageOf(const std::string& bundle) { return succeed({"inspect", bundle}).output; }

std::string written(const Workplace& workplace, const BundleFile& file) {
  REQUIRE(writeBundle(workplace.path("noise.glb"), file).ok());
  return workplace.path("noise.glb");
}

} // namespace

TEST_CASE("inspect --json lists size, precision, mean and parameters of a bake") {
  const Workplace workplace;
  const SrgbImage image = smooth(kSide);
  const std::string bundle = bake(workplace, workplace.write("moss.png", image), "moss.glb",
                                  {"--seed", "7", "--tile", "2.5", "--precision", "16"});
  const nlohmann::json report = inspected(bundle);
  CHECK(report.at("file") == bundle);
  CHECK(report.at("bytesOnDisk") == std::filesystem::file_size(bundle));
  REQUIRE(report.at("noises").size() == 1);
  const nlohmann::json& noise = report["noises"][0];
  CHECK(noise.at("name") == "moss");
  CHECK(noise.at("method") == "tiling");
  CHECK(noise.at("tileSize") == 2.5);
  REQUIRE(noise.at("maps").size() == 1);
  const nlohmann::json& map = noise["maps"][0];
  CHECK(map.at("target") == "baseColor");
  CHECK(map.at("encoding") == "root");
  CHECK(map.at("channels") == nlohmann::json{"red", "green", "blue"});
  CHECK(map.at("width") == kSide);
  CHECK(map.at("height") == kSide);
  CHECK(map.at("bits") == 16);
  SrgbImage roots = image;
  for (float& value : roots.values)
    value = std::sqrt(srgbToLinear(value));
  const std::vector<double> mean = meanOf(roots);
  for (std::size_t c = 0; c < 3; ++c) // the file rounds codes to 8 bits
    CHECK(map.at("mean")[c].get<double>() == Approx(mean[c]).margin(0.5 / 255.0));
  REQUIRE(noise.at("materials").size() == 1);
  CHECK(noise["materials"][0].at("seed") == 7);
  CHECK(noise["materials"][0].at("mapping") == "uv");
}

TEST_CASE("inspect counts the texel bytes on the GPU and the file bytes on disk") {
  const Workplace workplace;
  // Grey: one channel and the loss, of 8 bits each. The mip levels of 24 x 24 have 24, 12, 6, 3 and
  // 1 texels a side.
  const std::string input = workplace.write("moss.png", smoothGrey(kSide));
  const nlohmann::json report =
      inspected(bake(workplace, input, "dry moss %.gltf", {"--preview", "none"}));
  const nlohmann::json& tables = report.at("tables");
  REQUIRE(tables.size() == 2);
  CHECK(report.at("noises")[0].at("fetchesPerPixel") == 4); // 3 taps, 1 table fetch
  CHECK(tables[0].at("bytes") == 2 * (24 * 24 + 12 * 12 + 6 * 6 + 3 * 3 + 1));
  CHECK(tables[0].at("mipLevels") == 5);
  std::size_t sum = 0;
  for (const nlohmann::json& table : tables)
    sum += table.at("bytes").get<std::size_t>();
  CHECK(report.at("bytesOnGpu") == sum);
  std::uintmax_t onDisk = 0;
  for (const std::string& name : workplace.names())
    onDisk += name == "moss.png" ? 0 : std::filesystem::file_size(workplace.path(name));
  CHECK(report.at("bytesOnDisk") == onDisk);
}

TEST_CASE("inspect prints a member a line") {
  const Workplace workplace;
  const std::string bundle =
      bake(workplace, workplace.write("moss.png", smooth(kSide)), "moss.glb", {"--seed", "7"});
  const std::string page = pageOf(bundle);
  for (const char* word :
       {"\nnoises:\n  - name: moss\n    method: tiling\n", "\n    fetchesPerPixel: 4\n    maps:\n",
        "      - target: baseColor\n        channels: red, green, blue\n", "        bits: 8\n",
        "        mapping: uv\n", "        seed: 7\n", "        mix:\n          source: constant\n",
        "\ntables:\n  - name: moss.baseColor", "  - name: moss.baseColor.inverse\n"})
    CHECK_THAT(page, Catch::Contains(word));
  CHECK_THAT(page, Catch::StartsWith("file: " + bundle + "\n") && !Catch::Contains("null") &&
                       !Catch::Contains("ignoredNoises"));
  CHECK(runLichen({"inspect", bundle, "--quiet"}).output.empty());
}

TEST_CASE("inspect counts the fetches that all maps of a quilting share once") {
  const Workplace workplace;
  const std::string bundle = written(workplace, example::smallestQuilting());
  const nlohmann::json noise = inspected(bundle).at("noises")[0];
  REQUIRE(noise.at("maps").size() == 2);
  for (const nlohmann::json& map : noise["maps"])
    CHECK(map.at("fetchesPerPixel") == 2);
  CHECK(noise.at("fetchesPerPixel") == 2 * 2 + 3);
}

TEST_CASE("inspect shows a grain") {
  const Workplace workplace;
  BundleFile file = example::smallest();
  CHECK_FALSE(inspected(written(workplace, file)).at("noises")[0].contains("grain"));
  CHECK_THAT(pageOf(workplace.path("noise.glb")), !Catch::Contains("grain"));
  const auto check = [&](const std::string& axis) {
    const std::string bundle = written(workplace, file);
    CHECK(inspected(bundle).at("noises")[0].at("grain") == axis);
    CHECK_THAT(pageOf(bundle), Catch::Contains("    grain: " + axis + "\n"));
  };
  file.bundle.noises[0].as<TilingNoise>().grain = Grain::y;
  check("y");
  file = example::smallestQuilting();
  file.bundle.noises[0].as<QuiltingNoise>().grain = Grain::x;
  check("x");
}

TEST_CASE("inspect shows support, impacts, cost and exemplar size of textons") {
  const Workplace workplace;
  const std::string bundle = written(workplace, example::textonMix());
  const nlohmann::json report = inspected(bundle);
  const nlohmann::json& noise = report.at("noises")[1];
  CHECK(noise.at("method") == "texton");
  CHECK(noise.at("texton").at("coefficients") == std::vector<int>{9, 17});
  CHECK(noise.at("texton").at("support") == std::vector<int>{12, 20}); // support of a cubic spline
  CHECK(noise.at("texton").at("order") == 3);
  CHECK(noise.at("texton").at("steps") == 3);
  CHECK(noise.at("materials")[0].at("impacts") == 12.5);
  CHECK(noise.at("materials")[0].at("pointProcess") == "poisson");
  REQUIRE(noise.at("maps").size() == 3);
  for (std::size_t m = 0; m < 3; ++m) {
    const nlohmann::json& map = noise["maps"][m];
    CHECK(map.at("texton") == 2 + m);
    CHECK_FALSE(map.contains("gaussian"));
    CHECK(map.at("width") == 100);
    CHECK(map.at("height") == 50);
    CHECK(map.at("fetchesPerPixel") == 4 * 21); // (sqrt(12.5) + 1)^2 is 20.57
  }
  CHECK(noise.at("fetchesPerPixel") == 3 * 4 * 21);
  CHECK_FALSE(report["noises"][0].contains("texton"));
  // 12 x 20 texels of 8 bytes in three steps, and a mip level of a quarter of that.
  CHECK(report.at("tables")[2].at("bytes") == 12 * 20 * 3 * 8 * 5 / 4);
  CHECK_THAT(pageOf(bundle), Catch::Contains("    texton:\n      coefficients: 9, 17\n"));
}

TEST_CASE("inspect ignores buffers without tables, valid or not") {
  const Workplace workplace;
  bake(workplace, workplace.write("moss.png", smoothGrey(8)), "moss.gltf", {"--preview", "none"});
  nlohmann::json gltf = nlohmann::json::parse(workplace.read("moss.gltf"));
  for (const char* buffer :
       {"3", "{}", R"({"uri": 4, "byteLength": 5})", R"({"uri": "gone.bin", "byteLength": -1})"})
    gltf["buffers"].push_back(nlohmann::json::parse(buffer));
  const std::string odd = workplace.write("odd.gltf", gltf.dump());
  CHECK(inspected(odd).at("noises").size() == 1);
}
