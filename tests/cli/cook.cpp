// SPDX-License-Identifier: MIT
// `lichen cook`: the file it makes of a bundle.
#include "bundle_example.h"
#include "command_run.h"

#include <lichen/bundle.h>
#include <lichen/files.h>

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::cli_test;

TEST_CASE("cook writes the noise without the scene, and the other verbs read it") {
  const Workplace workplace;
  const std::string moss =
      bake(workplace, workplace.write("moss.png", smooth(24)), "moss.glb", {"--seed", "5"});
  const std::string cooked = workplace.path("moss.lichen");
  const nlohmann::json report = jsonOf({"cook", moss, "-o", cooked});
  CHECK(report["output"] == cooked);
  CHECK(report["noises"] == nlohmann::json{"moss"});
  CHECK(report["materials"] == 1);
  CHECK(report["tables"] == 2);
  CHECK(report["bytes"] == std::filesystem::file_size(cooked));
  CHECK(std::filesystem::file_size(cooked) < std::filesystem::file_size(moss));

  CHECK(runLichen({"check", cooked}).output == cooked + ": 0 errors, 0 warnings\n");
  for (const std::string& bundle : {moss, cooked}) // the same picture
    succeed({"synth", bundle, "-o", bundle + ".png", "--size", "32"});
  CHECK(readFile(moss + ".png").value() == readFile(cooked + ".png").value());
  const std::string photograph = workplace.path("moss.png");
  CHECK(runLichen({"compare", photograph, cooked}).output ==
        runLichen({"compare", photograph, moss}).output);
  CHECK(readBundle(cooked).value().materialNames == std::vector<std::string>{"moss"});
}

TEST_CASE("cook refuses what it cannot cook") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(24)), "moss.glb");
  const std::string output = workplace.path("out.lichen");
  checkRefusal({"cook", moss, "-o", workplace.path("out.glb")}, kUsage,
               {"out.glb: expected the extension .lichen\n"});
  checkRefusal({"cook", workplace.path("moss.png"), "-o", output}, kBadInput,
               {"is a PNG image; expected a .glb or .gltf"});
  CHECK(!std::filesystem::exists(output));
  succeed({"cook", moss, "-o", output});
  checkRefusal(
      {"apply", output, "--noise", moss, "--material", "0", "-o", workplace.path("scene.glb")},
      kBadInput, {"is a cooked bundle; expected a .glb or .gltf"});
}
