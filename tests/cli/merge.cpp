// SPDX-License-Identifier: MIT
// `lichen merge`: the bundle it makes from several.
#include "bundle_example.h"
#include "command_run.h"

#include <lichen/bundle_files.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

Arguments merging(const Workplace& workplace, const Arguments& bundles,
                  const Arguments& more = {}) {
  return Arguments{"merge", "-o", workplace.path("all.glb")} + bundles + more;
}

Bundle merged(const Workplace& workplace, const Arguments& bundles, const Arguments& more = {}) {
  succeed(merging(workplace, bundles, more));
  succeed({"check", workplace.path("all.glb")});
  return readBundle(workplace.path("all.glb")).value();
}

/// Returns whether two tables hold the same image; their names may differ.
bool isSameImage(const Table& a, const Table& b) {
  return a.format == b.format && a.width == b.width && a.height == b.height && a.depth == b.depth &&
         a.mipLevels == b.mipLevels && a.texels == b.texels;
}

} // namespace

TEST_CASE("merge preserves order, tables, parameters and pictures of the noises") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(24)), "moss.glb",
                                {"--seed", "5", "--tile", "3"});
  const std::string sand = bake(workplace, workplace.write("sand.png", speckled(16, 32, 3)),
                                "sand.gltf", {"--seed", "9"});
  const Bundle all = merged(workplace, {sand, moss});
  REQUIRE(all.noises.size() == 2);
  CHECK(all.noises[0].name == "sand");
  CHECK(all.noises[1].name == "moss");
  CHECK(all.noises[1].tileSizeMetres == 3.0);
  CHECK(all.materialNames == std::vector<std::string>{"sand", "moss"});
  CHECK(all.materials[0]->seed == 9);
  CHECK(all.materials[1]->noise == 1);
  CHECK(all.materials[1]->seed == 5);
  const Bundle alone = readBundle(moss).value();
  const NoiseMap& before = alone.noises[0].maps[0];
  const NoiseMap& after = all.noises[1].maps[0];
  CHECK(after.covariance == before.covariance);
  const auto& tilingBefore = before.as<TilingMap>();
  const auto& tiling = after.as<TilingMap>();
  CHECK(isSameImage(alone.tables[tilingBefore.gaussian], all.tables[tiling.gaussian]));
  CHECK(isSameImage(alone.tables[*tilingBefore.inverseTable], all.tables[*tiling.inverseTable]));
  CHECK(tiling.dimensions == tilingBefore.dimensions);

  const SrgbImage picture = synth(workplace, moss, {"--size", "40x30"});
  const SrgbImage same =
      synth(workplace, workplace.path("all.glb"), {"--size", "40x30", "--noise", "moss"});
  CHECK(same.values == picture.values);
}

TEST_CASE("merge puts noises of two methods into one bundle") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(16)), "moss.glb");
  const std::string dune = workplace.path("dune.glb");
  BundleFile file = example::smallestTexton();
  file.bundle.materials[0]->impacts = 100.0;
  REQUIRE(writeBundle(dune, file).ok());
  const Bundle all = merged(workplace, {moss, dune, dune});
  REQUIRE(all.noises.size() == 3);
  CHECK(all.noises[0].method() == Method::tiling);
  CHECK(all.noises[2].name == "dune-2");
  CHECK(all.tables.size() == 3); // both dune noises share a texton
  for (const std::size_t n : {1u, 2u}) {
    const Noise& noise = all.noises[n];
    REQUIRE(noise.method() == Method::texton);
    CHECK(noise.data == file.bundle.noises[0].data);
    const auto& texton = noise.maps[0].as<TextonMap>();
    CHECK(texton.scale == file.bundle.noises[0].maps[0].as<TextonMap>().scale);
    CHECK(isSameImage(all.tables[texton.image], file.bundle.tables[0]));
    CHECK(all.materials[n]->impacts == 100.0);
  }
}

TEST_CASE("merging a single bundle gives the bake itself, byte for byte") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(16)), "moss.glb");
  static_cast<void>(merged(workplace, {moss}));
  CHECK((workplace.read("all.glb") == workplace.read("moss.glb")));
}

TEST_CASE("merged bundles can be merged again, and names stay unique") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smoothGrey(16)), "m.glb");
  (void)merged(workplace, {moss, moss});
  std::filesystem::rename(workplace.path("all.glb"), workplace.path("two.glb"));
  const Bundle all = merged(workplace, {moss, workplace.path("two.glb")});
  REQUIRE(all.noises.size() == 3);
  CHECK(all.noises[1].name == "moss-2");
  CHECK(all.noises[2].name == "moss-2-2");
}

TEST_CASE("every preview shape shows merged noises, a plane only up to its limit") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smoothGrey(4)), "m.glb");
  for (const char* shape : {"sphere", "plane", "none"})
    CHECK(merged(workplace, {moss, moss}, {"--preview", shape}).noises.size() == 2);
  const Arguments many(49, moss);
  checkRefusal(merging(workplace, many, {"--preview", "plane"}), kUsage,
               {"49 materials; a preview plane shows at most 48"});
  CHECK(merged(workplace, Arguments(48, moss), {"--preview", "plane"}).noises.size() == 48);
}

TEST_CASE("the preview's camera sees every ball completely, separately and large enough") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smoothGrey(4)), "m.glb");
  struct Count {
    std::size_t balls;
    double leastShare; // height of a ball relative to the picture
  };
  // A single row of four balls would give 0.17, one of nine 0.07.
  for (const auto& [count, leastShare] : {Count{1, 0.6}, {2, 0.3}, {4, 0.28}, {9, 0.15}}) {
    succeed(Arguments{"merge", "-o", workplace.path("all.gltf")} + Arguments(count, moss));
    const nlohmann::json gltf = nlohmann::json::parse(workplace.read("all.gltf"));
    std::array<double, 3> eye{};
    double pitch = 0.0;
    std::vector<std::array<double, 3>> balls;
    for (const nlohmann::json& node : gltf.at("nodes"))
      if (node.contains("camera")) {
        eye = node.at("translation");
        pitch = 2.0 * std::asin(node.at("rotation")[0].get<double>());
      } else if (node.at("name").get<std::string>().rfind("ball", 0) == 0) {
        balls.push_back(node.at("translation"));
      }
    REQUIRE(balls.size() == count);
    // How the camera sees a ball of radius 1: its direction in the camera's frame, and half its
    // angle.
    const double halfHeight =
        std::tan(gltf["cameras"][0]["perspective"]["yfov"].get<double>() / 2.0);
    std::vector<std::array<double, 4>> sights;
    for (const std::array<double, 3>& ball : balls) {
      const double x = ball[0] - eye[0], y = ball[1] - eye[1], z = ball[2] - eye[2];
      const double up = std::cos(pitch) * y + std::sin(pitch) * z;
      const double ahead = std::sin(pitch) * y - std::cos(pitch) * z;
      const double distance = std::sqrt(x * x + y * y + z * z);
      sights.push_back({x / distance, up / distance, ahead / distance, std::asin(1.0 / distance)});
      // In a square picture; the outline extends a little beyond 1 / ahead.
      CHECK((std::abs(x) + 1.0) / ahead < halfHeight);
      CHECK((std::abs(up) + 1.0) / ahead < halfHeight);
      CHECK(1.0 / ahead / halfHeight > leastShare);
    }
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const auto& [ax, ay, az, aHalf] = sights[a];
        const auto& [bx, by, bz, bHalf] = sights[b];
        // From nearby, the rows behind are slightly lower.
        CHECK(std::acos(ax * bx + ay * by + az * bz) > 0.9 * (aHalf + bHalf));
      }
  }
}

TEST_CASE("merge --json gives one object with its notes") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smoothGrey(8)), "m.glb");
  const nlohmann::json report = jsonOf(merging(workplace, {moss, moss}));
  CHECK(report.at("noises") == nlohmann::json{"moss", "moss-2"});
  CHECK(report.at("tables") == 2);
  CHECK(report.at("notes").size() == 1);
}

TEST_CASE("merge reports what it cannot merge and leaves no file") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", smoothGrey(8));
  const std::string moss = bake(workplace, image, "moss.gltf", {"--preview", "none"});
  const nlohmann::json gltf = nlohmann::json::parse(workplace.read("moss.gltf"));
  const auto altered = [&](const char* name, const auto& alter) {
    nlohmann::json other = gltf;
    alter(other["extensions"]["LICHEN_materials_exemplar_noise"],
          other["materials"][0]["extensions"]["LICHEN_materials_exemplar_noise"]);
    return workplace.write(name, other.dump());
  };
  const std::string later =
      altered("later.gltf", [](auto& root, auto&) { root["noises"][0]["revision"] = 99; });
  const std::string second = altered("uv1.gltf", [](auto&, auto& use) { use["texCoord"] = 1; });
  const std::string whole = workplace.read("moss.gltf");
  const std::string half = workplace.write("half.gltf", whole.substr(0, whole.size() / 2));
  const std::string output = workplace.path("all.glb");
  checkRefusals({"merge", "-o", output},
                std::vector<Refused>{
                    {{moss, later}, {"later.gltf: noise 'moss'", "99"}, kBadInput},
                    {{moss, half}, {"half.gltf: "}, kBadInput},
                    {{moss, image}, {"moss.png: "}, kBadInput},
                    {{second}, {"material 'moss' uses texture coordinates 1", "--preview none"}},
                    {{}, {"BUNDLE is required"}}});
  checkRefusal({"merge", moss, "-o", workplace.path("all.png")}, kUsage, {".glb", ".gltf"});
  CHECK(!std::filesystem::exists(output));
  CHECK(merged(workplace, {moss, second}, {"--preview", "none"}).materials[1]->texCoord == 1);
}
