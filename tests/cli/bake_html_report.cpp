// SPDX-License-Identifier: MIT
// The text of the page that `lichen bake --report` and `lichen mix --report` write;
// tests/cli/report_page renders it.
#include "checkout_paths.h"
#include "command_run.h"

#include <lichen/base64.h>
#include <lichen/bundle.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <regex>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr const char* kDataStart = "<script type=\"application/json\" id=\"data\">";

/// Returns the data embedded in the page.
nlohmann::json dataOf(const std::string& page) {
  const std::size_t start = page.find(kDataStart);
  REQUIRE(start != std::string::npos);
  const std::size_t begin = start + std::string(kDataStart).size();
  const std::string data = page.substr(begin, page.find("</script>", begin) - begin);
  CHECK(data.find('<') == std::string::npos);
  return nlohmann::json::parse(data);
}

std::string reportOf(const Workplace& workplace, const std::string& input,
                     const Arguments& more = {}) {
  Arguments arguments{"--report", workplace.path("report.html")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  bake(workplace, input, "noise.glb", arguments);
  return workplace.read("report.html");
}

/// Returns the width and height of a picture: bytes 16 to 23 of the PNG in the base64 data URI.
std::array<unsigned, 2> extentsOf(const nlohmann::json& picture) {
  const std::string uri = picture.at("png");
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t begin = uri.find(',') + 1;
  const auto byteAt = [&](std::size_t place) {
    unsigned bits = 0;
    for (std::size_t c = 0; c < 4; ++c)
      bits = bits << 6u | unsigned(digits.find(uri[begin + place / 3 * 4 + c]));
    return bits >> (16u - 8u * unsigned(place % 3)) & 255u;
  };
  std::array<unsigned, 2> extents{};
  for (std::size_t place = 16; place < 24; ++place)
    extents[place / 20] = extents[place / 20] << 8u | byteAt(place);
  return extents;
}

SrgbImage pictureOf(const nlohmann::json& picture) {
  const std::string uri = picture.at("png");
  const auto file = decodeBase64(std::string_view(uri).substr(uri.find(',') + 1)).value();
  return std::get<SrgbImage>(decodeImage(file, "picture").value().pixels);
}

} // namespace

TEST_CASE("a report has the measures of compare and loads nothing from elsewhere") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smooth(64));
  const std::string page = reportOf(workplace, input, {"--seed", "3"});
  const nlohmann::json data = dataOf(page);
  CHECK(data.at("name") == "moss");
  REQUIRE(data.at("maps").size() == 1);
  const nlohmann::json& map = data["maps"][0];
  CHECK(map.at("target") == "baseColor");
  CHECK(map.at("histograms").size() == 3);
  CHECK(map.at("risks").size() > 0);
  CHECK(map.at("table").at("levels").size() == 5);
  CHECK(map["table"]["levels"][0].at("slices") == 32);
  const nlohmann::json compared = nlohmann::json::parse(
      runLichen({"compare", input, workplace.path("noise.glb"), "--json"}).output);
  REQUIRE(map.at("measures").size() == compared.at("measures").size());
  for (std::size_t m = 0; m < compared["measures"].size(); ++m) {
    CHECK(map["measures"][m].at("name") == compared["measures"][m].at("name"));
    CHECK(map["measures"][m].at("value") == compared["measures"][m].at("value"));
  }
  static const std::regex address("[a-z]+://[^\"' ]+");
  for (std::sregex_iterator at(page.begin(), page.end(), address), end; at != end; ++at)
    CHECK(at->str() == "http://www.w3.org/2000/svg"); // the name of a namespace, not a link
}

TEST_CASE("a report of textons shows the Gaussian version") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smooth(64));
  const nlohmann::json data =
      dataOf(reportOf(workplace, input, {"--method", "texton", "--support", "16"}));
  const nlohmann::json& map = data.at("maps").at(0);
  CHECK(extentsOf(map.at("gaussian")) == std::array{128u, 128u});
  CHECK(map["gaussian"] != map.at("result"));
  CHECK(map.at("table").is_null());
  const nlohmann::json tiling = dataOf(reportOf(workplace, input))["maps"][0];
  CHECK(tiling.at("gaussian").is_null());
}

TEST_CASE("a report of quilting marks its offsets, and shows what tiles at them agree on") {
  const Workplace workplace;
  const std::string input = workplace.write("bricks.png", brickwork(128));
  const Arguments quilting{"--method", "quilting"};
  const nlohmann::json data = dataOf(reportOf(workplace, input, quilting));
  const nlohmann::json& images = data.at("maps").at(0).at("furtherImages");
  REQUIRE(images.size() == 2);
  const SrgbImage marked = pictureOf(images[0]), mean = pictureOf(images[1]);
  const Bundle bundle = readBundle(workplace.path("noise.glb")).value();
  const auto& offsets = bundle.noises[0].as<QuiltingNoise>().offsets;
  REQUIRE(offsets.size() > 3);
  for (const std::array<double, 2>& offset : offsets) {
    const float* const mark = marked.pixel(int(std::lround(offset[0] * 128)) % 128,
                                           int(std::lround(offset[1] * 128)) % 128);
    CHECK(std::ranges::count(mark, mark + marked.channels, 1.0f) == marked.channels);
  }
  // Joints are 0.9 in every tile, and bricks differ from 0.2 to 0.5: in the mean they differ less.
  const SrgbImage exemplar = pictureOf(data["maps"][0].at("exemplar"));
  const auto [darkest, brightest] = std::ranges::minmax(mean.values);
  CHECK(brightest > 0.85f);
  CHECK(darkest > std::ranges::min(exemplar.values) + 0.03f);
  CHECK_THAT(images[0].at("text").get<std::string>(),
             Catch::Contains(std::to_string(offsets.size()) + " offsets"));

  const nlohmann::json anywhere =
      dataOf(reportOf(workplace, input, {"--method", "quilting", "--guide", "0"}));
  CHECK(anywhere.at("maps").at(0).at("furtherImages").empty());
  CHECK_THAT(anywhere.at("facts").dump(), Catch::Contains("[\"Tiles\",\"from anywhere\"]"));
}

TEST_CASE("a report of cosines shows the Gaussian version of the exemplar") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", speckled(64, 64, 3));
  const nlohmann::json data =
      dataOf(reportOf(workplace, input, {"--method", "local-random-phase", "--structure", "0"}));
  CHECK(!data.at("maps").at(0).at("gaussian").is_null());
}

TEST_CASE("compare makes the exemplar again as the bake made it, unless an option says otherwise") {
  const Workplace workplace;
  // Light from one side, which flattening removes, and a normal map whose green channel points
  // down.
  SrgbImage lit = speckled(80, 64, 4);
  for (int y = 0; y < lit.height; ++y)
    for (int x = 0; x < lit.width; ++x)
      for (int c = 0; c < 4; ++c)
        lit.pixel(x, y)[c] *= 0.3f + 0.7f * float(x) / float(lit.width);
  std::filesystem::create_directory(workplace.path("rock"));
  workplace.write("rock/rock_color.png", lit);
  workplace.write("rock/rock_normal.png", speckled(80, 64, 3));
  const Arguments options{"--crop", "8,0,64,64", "--size", "48x40",   "--flatten",
                          "16",     "--normal",  "dx",     "--alpha", "opacity"};
  const nlohmann::json data = dataOf(reportOf(workplace, workplace.path("rock"), options));
  std::vector<nlohmann::json> reported;
  for (const nlohmann::json& map : data.at("maps"))
    for (const nlohmann::json& measure : map.at("measures"))
      reported.push_back(measure.at("value"));
  CHECK(reported.size() == 15); // base colour, normal and opacity

  const std::string bundle = workplace.path("noise.glb");
  const auto run = [&](const Arguments& more) {
    Arguments compare{"compare", workplace.path("rock"), bundle, "--json"};
    compare.insert(compare.end(), more.begin(), more.end());
    const Ended ended = runLichen(compare);
    INFO(ended.errors);
    REQUIRE(!ended.output.empty());
    return nlohmann::json::parse(ended.output);
  };
  const auto measuresWith = [&](const Arguments& more) {
    std::vector<nlohmann::json> values;
    const nlohmann::json report = run(more);
    for (const nlohmann::json& measure : report.at("measures"))
      values.push_back(measure.at("value"));
    return values;
  };
  CHECK(measuresWith({}) == reported);
  CHECK(measuresWith(options) == reported);
  CHECK(run({}).at("notes").at(0) ==
        "as the bundle was baked: --crop 8,0,64,64 --size 48x40 --normal dx --alpha opacity "
        "--periodic no --flatten 16");
  // Each option by itself has an effect.
  CHECK(measuresWith({"--alpha", "ignore"}).size() == 10);
  for (const Arguments& other : {Arguments{"--crop", "0,0,64,64"},
                                 {"--size", "40x40"},
                                 {"--flatten", "none"},
                                 {"--normal", "gl"}}) {
    INFO(other[0]);
    CHECK(measuresWith(other) != reported);
    CHECK_THAT(run(other).at("notes").dump(),
               !Catch::Contains(other[0] + " " + "16") && !Catch::Contains(other[0] + " 8,0") &&
                   !Catch::Contains(other[0] + " dx") && !Catch::Contains(other[0] + " 48"));
  }
  workplace.write("rock/rock_color.png", speckled(40, 40, 4));
  workplace.write("rock/rock_normal.png", speckled(40, 40, 3));
  checkRefusal({"compare", workplace.path("rock"), bundle}, int(ErrorKind::usage),
               {"--crop 8,0,64,64", "noise.glb was baked with", "give the photograph"});
}

TEST_CASE("a report of a mix measures each input as compare does, and shows the steps between") {
  const Workplace workplace;
  const std::string moss = workplace.write("moss.png", smooth(40));
  const std::string sand = workplace.write("sand.png", speckled(32, 32, 3));
  const std::string rust = workplace.write("rust.png", speckled(40, 40, 3));
  const std::string bundle = workplace.path("mix.glb");
  const Ended ended = runLichen({"mix", moss, sand, rust, "-o", bundle, "--support", "8", "--steps",
                                 "8", "--report", workplace.path("mix.html"), "--json"});
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  const nlohmann::json data = dataOf(workplace.read("mix.html"));
  CHECK(data.at("kind") == "mix");
  REQUIRE(data.at("maps").size() == 3);
  int risks = 0;
  for (std::size_t input = 0; input < 3; ++input) {
    const nlohmann::json& map = data["maps"][input];
    CHECK(map.at("input") == std::array{"moss", "sand", "rust"}[input]);
    const nlohmann::json compared =
        nlohmann::json::parse(runLichen({"compare", std::array{moss, sand, rust}[input], bundle,
                                         "--mix", std::array{"0", "0.5", "1"}[input], "--json"})
                                  .output);
    REQUIRE(map.at("measures").size() == compared.at("measures").size());
    for (std::size_t m = 0; m < map["measures"].size(); ++m)
      CHECK(map["measures"][m].at("value") == compared["measures"][m].at("value"));
    for (const nlohmann::json& risk : map.at("risks")) // mix has no --method
      if (risk.at("level") != "none") {
        ++risks;
        CHECK_THAT(risk.at("remedy").get<std::string>(),
                   Catch::Contains("lichen bake --method tiling"));
      }
  }
  CHECK(risks > 0);
  const nlohmann::json paths = data.at("mixes").at(0).at("paths");
  const nlohmann::json errors = nlohmann::json::parse(ended.output).at("modelErrors");
  REQUIRE(errors.size() == 15); // 7 steps from each input to the next
  REQUIRE(paths.size() == 2);
  CHECK(paths[0].at("panes")[0].at("name") == "moss");
  CHECK(paths[0]["panes"][6].at("name") == "sand");
  CHECK(paths[1].at("panes")[0].at("name") == "sand");
  for (std::size_t path = 0; path < 2; ++path) {
    const nlohmann::json& panes = paths[path]["panes"];
    REQUIRE(panes.size() == 7);
    CHECK(paths[path].at("spectrum").at("curves").size() == 7);
    for (std::size_t k = 0; k < 5; ++k) {
      const std::size_t step = 7 * path + std::array<std::size_t, 5>{0, 2, 4, 5, 7}[k];
      CHECK(panes[k + 1].at("step") == step + 1);
      CHECK(panes[k + 1].at("weight").get<double>() == Approx(double(step) / 14.0));
      CHECK(panes[k + 1].at("modelError") == errors[step]);
      CHECK(panes[k + 1].at("kernel") != panes[k + 2 < 6 ? k + 2 : 1].at("kernel"));
    }
    CHECK(panes[1].at("kernel") == data["maps"][path].at("image"));
    CHECK(panes[5].at("kernel") == data["maps"][path + 1].at("image"));
  }
  CHECK(data["maps"][0].at("result") != data["maps"][2].at("result"));
}

TEST_CASE(
    "a report of one texture between inputs shows it and their shares, and measures nothing") {
  const Workplace workplace;
  const std::string moss = workplace.write("moss.png", smooth(24));
  const std::string sand = workplace.write("sand.png", speckled(24, 24, 3));
  const auto panesOf = [&](const std::string& weights) {
    const Ended ended =
        runLichen({"mix", moss, sand, "-o", workplace.path("mix.glb"), "--support", "8",
                   "--weights", weights, "--report", workplace.path("mix.html")});
    INFO(ended.errors);
    REQUIRE(ended.code == 0);
    const nlohmann::json data = dataOf(workplace.read("mix.html"));
    CHECK(data.at("maps").empty());
    nlohmann::json panes = data.at("mixes").at(0).at("paths").at(0).at("panes");
    REQUIRE(panes.size() == 3);
    CHECK(panes[0].at("name") == "moss");
    CHECK(panes[1].at("name") == "sand");
    CHECK(panes[2].at("step") == 1);
    return panes;
  };
  const nlohmann::json mostlyMoss = panesOf("3,1"), mostlySand = panesOf("1,3"),
                       onlySand = panesOf("0,5");
  CHECK(mostlyMoss[0].at("share") == 0.75);
  CHECK(mostlyMoss[1].at("share") == 0.25);
  CHECK(mostlySand[0].at("share") == 0.25);
  CHECK(mostlySand[1].at("share") == 0.75);
  CHECK(onlySand[1].at("share") == 1.0);
  CHECK(mostlyMoss[2].at("png") != mostlySand[2].at("png"));
  CHECK(mostlySand[2].at("png") != onlySand[2].at("png"));
}

TEST_CASE("a report says what was done to an exemplar, and shows it as it was before flattening") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("leaf"));
  workplace.write("leaf/leaf_color.png", smooth(64));
  workplace.write("leaf/leaf_opacity.png", smoothGrey(32));
  const std::string leaf = workplace.path("leaf");
  const nlohmann::json plain = dataOf(reportOf(workplace, leaf));
  for (const nlohmann::json& map : plain.at("maps")) {
    CHECK(map.at("steps").empty());
    CHECK(map.at("original").is_null());
  }
  const nlohmann::json maps =
      dataOf(reportOf(workplace, leaf, {"--crop", "0,0,48,40", "--flatten", "16"})).at("maps");
  CHECK(maps[0].at("steps") ==
        nlohmann::json{"cropped", "without variation slower than 16 pixels"});
  CHECK(extentsOf(maps[0].at("original")) == std::array{48u, 40u});
  CHECK(maps[0]["original"] != maps[0]["exemplar"]);
  CHECK(maps[1].at("target") == "opacity"); // flattening does not change opacity
  CHECK(maps[1].at("steps") == nlohmann::json{"cropped"});
  CHECK(maps[1].at("original").is_null());
}

TEST_CASE("the time that a bake prints includes its report") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smoothGrey(64));
  const Ended ended = runLichen({"bake", input, "-o", workplace.path("noise.glb"), "--report",
                                 workplace.path("report.html"), "--json"});
  const double printed = nlohmann::json::parse(ended.output).at("seconds");
  const nlohmann::json timings = dataOf(workplace.read("report.html")).at("timings");
  double sum = 0.0;
  for (const nlohmann::json& step : timings)
    if (step.at("name") != "In all")
      sum += step.at("seconds").get<double>();
  CHECK(timings.back().at("name") == "In all");
  CHECK(timings.back().at("seconds").get<double>() == Approx(sum));
  CHECK(printed >= sum); // includes the time to write the page
}

TEST_CASE("bake prints the file of the report and each target that the noise misses") {
  const Workplace workplace;
  // A grid of dots, whose order no noise has.
  SrgbImage dots(64, 64, 1);
  for (int y = 0; y < dots.height; ++y)
    for (int x = 0; x < dots.width; ++x)
      *dots.pixel(x, y) = x % 8 < 4 && y % 8 < 4 ? 0.9f : 0.1f;
  const std::string report = workplace.path("report.html");
  const auto baked = [&](const std::string& input) {
    return runLichen({"bake", input, "-o", workplace.path("noise.glb"), "--report", report}).output;
  };
  const std::string output = baked(workplace.write("dots.png", dots));
  const nlohmann::json data = dataOf(workplace.read("report.html"));
  std::size_t missed = 0, targets = 0;
  for (const nlohmann::json& measure : data.at("maps").at(0).at("measures")) {
    targets += measure.at("met").is_null() ? 0U : 1U;
    if (measure.at("met") != false)
      continue;
    ++missed;
    CHECK_THAT(output,
               Catch::Contains("\n  baseColor: " + measure.at("name").get<std::string>() + " "));
  }
  REQUIRE(missed > 0);
  CHECK(std::size_t(std::count(output.begin(), output.end(), '\n')) == 3 + missed);
  CHECK_THAT(output, Catch::Contains("\n" + report + ": report; the noise misses " +
                                     std::to_string(missed) + " of " + std::to_string(targets) +
                                     " targets\n"));
  CHECK_THAT(baked(workplace.write("grey.png", SrgbImage(64, 64, 1))),
             Catch::EndsWith(report + ": report; the noise meets all targets\n"));
}

TEST_CASE("each histogram of a report counts every pixel once") {
  const Workplace workplace;
  const nlohmann::json data = dataOf(reportOf(workplace, workplace.write("a.png", smooth(32))));
  for (const nlohmann::json& histogram : data["maps"][0]["histograms"])
    for (const char* side : {"exemplar", "result"}) {
      double sum = 0.0;
      for (const nlohmann::json& share : histogram.at(side))
        sum += share.get<double>();
      CHECK(sum == Approx(1.0));
    }
}

TEST_CASE("a report's command works in a shell for any file name") {
  const Workplace workplace;
  const std::string name = "it's </script><b> $HOME \\ \"x\"\n";
  const nlohmann::json data =
      dataOf(reportOf(workplace, workplace.write("moss.png", smoothGrey(16)), {"--name", name}));
  CHECK(data.at("name") == name);
  const std::string command = data.at("command");
  std::filesystem::remove(workplace.path("noise.glb"));
  const std::string line = "lichen() { " + programPath("lichen") + " \"$@\"; }; ";
  const Ended ended = run("/bin/sh", {"-c", line + command});
  INFO(ended.errors);
  CHECK(ended.code == 0);
  CHECK(dataOf(workplace.read("report.html")).at("name") == name);
}

TEST_CASE("two reports of the same bake differ only in their times") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", speckled(40, 24, 3));
  const auto withoutTimes = [&](const char* threads) {
    nlohmann::json data = dataOf(reportOf(workplace, input, {"--threads", threads}));
    data.erase("timings");
    data.erase("command"); // contains the number of threads
    return data;
  };
  CHECK((withoutTimes("1") == withoutTimes("2")));
}

TEST_CASE("every kind of image gets a report") {
  const Workplace workplace;
  LinearImage light(40, 20, 3);
  for (std::size_t i = 0; i < light.values.size(); ++i)
    light.values[i] = float((i * 37) % 101) / 25.0f;
  for (const std::string& input :
       {workplace.write("one.png", SrgbImage(1, 1, 3)),
        workplace.write("flat.png", SrgbImage(64, 64, 3)),
        workplace.write("thin.png", speckled(300, 2, 1)), workplace.write("lamp.exr", light)}) {
    INFO(input);
    const nlohmann::json data = dataOf(reportOf(workplace, input));
    CHECK(data["maps"][0]["measures"].size() == 5);
  }
}

TEST_CASE("a report shows a narrow exemplar unchanged, beside a result that is not narrow") {
  struct Shape {
    int width, height;
    std::array<unsigned, 2> result;
  };
  // The result is two exemplars along its longer side, and half as wide.
  for (const auto& [width, height, result] :
       {Shape{300, 2, {600, 300}}, Shape{3, 200, {200, 400}}}) {
    const Workplace workplace;
    const std::string input = workplace.write("a.png", speckled(width, height, 3));
    const nlohmann::json map = dataOf(reportOf(workplace, input))["maps"][0];
    CHECK(extentsOf(map.at("exemplar")) == std::array{unsigned(width), unsigned(height)});
    CHECK(extentsOf(map.at("result")) == result);
    CHECK(extentsOf(map.at("image")) == std::array{unsigned(width), unsigned(height)});
  }
}

TEST_CASE("a report shows every map of a set") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("rock"));
  workplace.write("rock/rock_color.png", smooth(16));
  workplace.write("rock/rock_normal.png", smooth(16));
  workplace.write("rock/rock_rough.png", smoothGrey(16));
  const nlohmann::json data = dataOf(reportOf(workplace, workplace.path("rock")));
  std::vector<std::string> targets;
  for (const nlohmann::json& map : data.at("maps"))
    targets.push_back(map.at("target"));
  CHECK(targets == std::vector<std::string>{"baseColor", "normal", "occlusionRoughnessMetallic"});
  CHECK(data["maps"][1]["histograms"][2]["channel"] == "normal z");
  CHECK(data["maps"][2]["histograms"].size() == 1);
  CHECK(data["maps"][2]["histograms"][0]["channel"] == "roughness");
}

TEST_CASE("an invalid report file is an error before the work starts") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smoothGrey(8));
  const std::string bundle = workplace.path("noise.glb");
  checkRefusal({"bake", input, "-o", bundle, "--report", workplace.path("r.txt")},
               int(ErrorKind::usage), {"r.txt", ".html"});
  checkRefusal({"bake", input, "-o", bundle, "--report", workplace.path("absent/r.html")},
               int(ErrorKind::environment), {"absent", "does not exist"});
  checkRefusal({"mix", input, input, "-o", bundle, "--report", workplace.path("r.txt")},
               int(ErrorKind::usage), {"r.txt", ".html"});
  CHECK(workplace.names() == std::vector<std::string>{"moss.png"});
}
