// SPDX-License-Identifier: MIT
// `lichen bake --method auto` and `lichen compare --methods`.
#include "command_run.h"

#include <lichen/bundle.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kUsage = 2;

struct Chosen {
  std::string method, notes;
};

/// What `--method auto` makes of an image.
Chosen chosenFor(const SrgbImage& image, const Arguments& more = {}) {
  const Workplace workplace;
  const std::string photograph = workplace.write("photograph.png", image);
  const std::string bundle = workplace.path("noise.glb");
  Arguments arguments{"bake", photograph, "-o", bundle, "--method", "auto", "--preview", "none"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Ended ended = runLichen(arguments);
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  return {std::string(nameOf(readBundle(bundle).value().noises.front().method())), ended.errors};
}

} // namespace

TEST_CASE("auto takes tiling unless the budget allows more, and says what would") {
  const Chosen chosen = chosenFor(smoothGrey(64));
  CHECK(chosen.method == "tiling");
  CHECK_THAT(chosen.notes, Catch::Contains("the only method within 4.1 plain fetches") &&
                               Catch::Contains("--budget 80 tries all"));
}

TEST_CASE("auto tries tiling and quilting where the exemplar has a structure") {
  const Chosen chosen = chosenFor(brickwork(128));
  CHECK(chosen.method == "quilting");
  CHECK_THAT(chosen.notes, Catch::Contains("(tiling 0.") && !Catch::Contains("texton") &&
                               Catch::Contains("--budget 80 tries all"));
}

TEST_CASE("auto takes the only method that a small budget allows") {
  const Chosen chosen = chosenFor(brickwork(128), {"--budget", "4.2"});
  CHECK(chosen.method == "tiling");
  CHECK_THAT(chosen.notes, Catch::Contains("the only method within 4.2 plain fetches"));
}

TEST_CASE("auto says that its choice does not depend on the verdict, if that is unsuitable") {
  const auto remark = Catch::Contains("the verdict on the choice of --method auto is unsuitable");
  CHECK_THAT(chosenFor(brickwork(128), {"--budget", "4.2"}).notes, remark); // tiling alone
  CHECK_THAT(chosenFor(speckled(128, 128, 3)).notes, !remark);
}

TEST_CASE("auto keeps the method that looks nearest for its cost") {
  // Rows of bricks come out whole by quilting, and in pieces by tiling.
  CHECK(chosenFor(brickwork(128), {"--budget", "100"}).method == "quilting");
  const Chosen speckles = chosenFor(speckled(128, 128, 3), {"--budget", "100"});
  CHECK(speckles.method == "tiling");
  CHECK_THAT(speckles.notes, Catch::Contains("look_distance") && Catch::Contains("texton 0."));
}

TEST_CASE("a budget needs --method auto, a method that is cheap enough, and no given spectrum") {
  const Workplace workplace;
  const std::string image = workplace.write("stone.png", smoothGrey(64));
  const std::string bundle = workplace.path("noise.glb");
  checkRefusal({"bake", image, "-o", bundle, "--budget", "50"}, kUsage,
               {"--budget: belongs to --method auto"});
  checkRefusal({"bake", image, "-o", bundle, "--method", "auto", "--budget", "2"}, kUsage,
               {"--budget 2: no method is that cheap; expected at least 4.1"});
  checkRefusal({"bake", image, "-o", bundle, "--method", "auto", "--spectrum", "ring:4:5"}, kUsage,
               {"--spectrum", "expected a --method"});
}

TEST_CASE("the budget that tries all methods does so") {
  const Arguments impacts{"--kernel-impacts", "60.1"};
  CHECK_THAT(chosenFor(smoothGrey(64), impacts).notes, Catch::Contains("--budget 104 tries all"));
  CHECK_THAT(chosenFor(smoothGrey(64), {"--kernel-impacts", "60.1", "--budget", "104"}).notes,
             Catch::Contains("multiple-kernels"));
}

TEST_CASE("compare --methods has a line for each method, and a page with pictures") {
  const Workplace workplace;
  const std::string image = workplace.write("<b>\"bricks.png", brickwork(128));
  const std::string page = workplace.path("methods.html");
  const Ended ended = runLichen({"compare", image, "--methods", "--report", page, "--json"});
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  const nlohmann::json report = nlohmann::json::parse(ended.output);
  REQUIRE(report.at("methods").size() == allMethods().size());
  for (std::size_t m = 0; m < allMethods().size(); ++m) {
    const nlohmann::json& row = report["methods"][m];
    CHECK(row.at("method") == nameOf(allMethods()[m]));
    CHECK(row.at("lookDistance").get<double>() > 0.0);
    CHECK(row.at("gpuBytes").get<double>() > 1024.0);
    CHECK(row.at("bakeSeconds").get<double>() > 0.0);
    CHECK(row.at("measures").size() == 4);
  }
  const std::string html = workplace.read("methods.html");
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = html.find("<img", at)) != std::string::npos; ++at)
    ++pictures;
  CHECK(pictures == 1 + allMethods().size());
  CHECK_THAT(html, Catch::Contains("&lt;b&gt;&quot;bricks.png") && !Catch::Contains("<b>"));
  const std::string text = runLichen({"compare", image, "--methods"}).output;
  CHECK_THAT(text, Catch::Contains("look_distance") && Catch::Contains("multiple-kernels"));
}

TEST_CASE("an exemplar that is too small to compare methods gets the cheapest, or a message") {
  const Chosen chosen = chosenFor(smoothGrey(16), {"--budget", "100"});
  CHECK(chosen.method == "tiling");
  CHECK_THAT(chosen.notes, Catch::Contains("an exemplar of 16 x 16 pixels is too small"));
  const Workplace workplace;
  const std::string image = workplace.write("tiny.png", smoothGrey(16));
  constexpr int kBadInput = 3;
  checkRefusal({"compare", image, "--methods"}, kBadInput,
               {"tiny.png: 16 x 16 pixels are too few", "at least 32 x 32"});
}

TEST_CASE("compare needs a result or --methods, and not both") {
  const Workplace workplace;
  const std::string image = workplace.write("stone.png", smoothGrey(64));
  checkRefusal({"compare", image}, kUsage, {"RESULT|BUNDLE is required without --methods"});
  checkRefusal({"compare", image, image, "--methods"}, kUsage, {"--methods", "expected no result"});
  checkRefusal({"compare", image, image, "--report", workplace.path("x.html")}, kUsage,
               {"--report: belongs to --methods"});
  checkRefusal({"compare", image, "--methods", "--report", workplace.path("x.txt")}, kUsage,
               {"x.txt", ".html"});
}
