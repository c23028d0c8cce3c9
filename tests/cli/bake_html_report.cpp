// SPDX-License-Identifier: MIT
// The page that `lichen bake --report` writes, read as XML.
#include "checkout_paths.h"
#include "command_run.h"
#include "parsed_page.h"

#include <lichen/bundle_files.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <regex>

using namespace lichen;
using namespace lichen::cli_test;
using test::PageElement;
using test::parsedPage;
using test::pictureOf;

namespace {

PageElement reportOf(const Workplace& workplace, const std::string& input,
                     const Arguments& more = {}) {
  Arguments arguments{"--report", workplace.path("report.html")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  bake(workplace, input, "noise.glb", arguments);
  return parsedPage(workplace.read("report.html"));
}

/// The sections of maps, without what lies between the inputs of a mix.
std::vector<PageElement> mapsOf(const PageElement& page) {
  std::vector<PageElement> maps;
  for (PageElement& article : page.all("article"))
    if (!article.all("table").empty())
      maps.push_back(std::move(article));
  return maps;
}

/// A number as the page shows it.
std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2e", value);
  return text;
}

std::string digits(const nlohmann::json& value) {
  return value.is_null() ? "" : digits(value.get<double>());
}

std::string digits(const PageElement& cell) {
  return cell.text.empty() ? "" : digits(std::stod(cell.text));
}

/// The name, value, target and verdict of each measure.
std::vector<std::array<std::string, 4>> measuresOf(const PageElement& map) {
  std::vector<std::array<std::string, 4>> measures;
  for (const PageElement& row : map.all("tr"))
    if (const std::vector<PageElement> cells = row.all("td"); cells.size() == 3)
      measures.push_back(
          {row.children[0].ownText, digits(cells[0]), digits(cells[1]), cells[2].text});
  return measures;
}

/// The same of `lichen compare --json`.
std::vector<std::array<std::string, 4>> measuresOf(const nlohmann::json& compared) {
  std::vector<std::array<std::string, 4>> measures;
  for (const nlohmann::json& measure : compared.at("measures"))
    measures.push_back({measure.at("name"), digits(measure.at("value")),
                        digits(measure.at("target")),
                        measure.at("value").is_null()    ? "not measured"
                        : measure.at("target").is_null() ? "no target"
                        : measure.at("met") == true      ? "\u2713 met"
                                                         : "\u2717 missed"});
  return measures;
}

/// The images with this title.
std::vector<PageElement> imagesOf(const PageElement& section, const std::string& title) {
  return section.all("img", "alt", title);
}

PageElement imageOf(const PageElement& section, const std::string& title) {
  const std::vector<PageElement> images = imagesOf(section, title);
  INFO(title);
  REQUIRE(images.size() == 1);
  return images.front();
}

std::array<int, 2> extentsOf(const PageElement& image) {
  const SrgbImage picture = pictureOf(image);
  return {picture.width, picture.height};
}

/// What stands below each pane.
std::vector<std::string> captionsOf(const PageElement& section) {
  std::vector<std::string> captions;
  for (const PageElement& caption : section.all("span", "class", "caption"))
    captions.push_back(caption.text);
  return captions;
}

/// The values of a list of names and values.
std::vector<std::string> valuesOf(const PageElement& page, const std::string& name) {
  std::vector<std::string> values;
  for (const PageElement& list : page.all("dl"))
    for (std::size_t i = 0; i + 1 < list.children.size(); i += 2)
      if (list.children[i].text == name)
        values.push_back(list.children[i + 1].text);
  return values;
}

bool isSame(const PageElement& a, const PageElement& b) {
  return a.attributes.at("src") == b.attributes.at("src");
}

} // namespace

TEST_CASE("a report has the measures of compare, every picture, and loads and runs nothing") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smooth(64));
  const std::string name = "</style><b>hostile</b> & <img src=\"x\" onerror='alert(1)'>";
  const PageElement page = reportOf(workplace, input, {"--seed", "3", "--name", name});
  CHECK(page.all("h1").at(0).text == name);
  CHECK(page.all("title").at(0).text == name + " - bake report");
  CHECK(page.all("p").at(0).text == "Lichen bake report");
  CHECK(valuesOf(page, "Seed") == std::vector<std::string>{"3"});
  const std::vector<PageElement> maps = mapsOf(page);
  REQUIRE(maps.size() == 1);
  CHECK(maps[0].all("h2").at(0).text == "baseColor");
  CHECK(maps[0].all("figure").size() == 3);
  CHECK(maps[0].all("svg").size() == 4); // histograms and a spectrum
  CHECK(maps[0].all("path", "class", "result").size() == 4);
  CHECK(maps[0].all("path", "class", "gaussian").empty());
  CHECK(maps[0].all("ul").at(0).all("li").size() > 0);
  // Exemplar and result; and the repetition.
  CHECK(maps[0].all("img").size() == 2);
  CHECK(captionsOf(maps[0]).back() == "Result of the noise");
  const std::vector<PageElement> pictures = test::picturesIn(page);
  CHECK(pictures.size() == 3);
  for (const PageElement& picture : pictures)
    CHECK(pictureOf(picture).pixelCount() > 0);
  const nlohmann::json compared = nlohmann::json::parse(
      runLichen({"compare", input, workplace.path("noise.glb"), "--json"}).output);
  CHECK(measuresOf(maps[0]) == measuresOf(compared));

  for (const char* active : {"script", "link", "object", "iframe", "form", "a"})
    CHECK(page.all(active).empty());
  for (const PageElement& element : page.all(""))
    for (const auto& [key, value] : element.attributes) {
      CHECK(key.substr(0, 2) != "on");
      CHECK((key != "src" || value.substr(0, 5) == "data:"));
    }
  CHECK(workplace.read("report.html").find("://") == std::string::npos);
}

TEST_CASE("a report of textons or cosines shows the Gaussian version") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smooth(64));
  const PageElement map =
      mapsOf(reportOf(workplace, input, {"--method", "texton", "--support", "16"})).at(0);
  CHECK(extentsOf(imageOf(map, "Gaussian version")) == std::array{64, 64});
  CHECK(!isSame(imageOf(map, "Gaussian version"), imageOf(map, "Result")));
  CHECK(map.all("path", "class", "gaussian").size() == 1);
  CHECK(imagesOf(reportOf(workplace, input), "Gaussian version").empty());
  const PageElement cosines =
      reportOf(workplace, input, {"--method", "local-random-phase", "--structure", "0"});
  CHECK(imagesOf(cosines, "Gaussian version").size() == 1);
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
  std::vector<std::string> reported;
  for (const PageElement& map : mapsOf(reportOf(workplace, workplace.path("rock"), options)))
    for (const auto& measure : measuresOf(map))
      reported.push_back(measure[1]);
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
    std::vector<std::string> values;
    for (const auto& measure : measuresOf(run(more)))
      values.push_back(measure[1]);
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

TEST_CASE("a report says what was done to an exemplar, and shows it as it was before flattening") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("leaf"));
  workplace.write("leaf/leaf_color.png", smooth(64));
  workplace.write("leaf/leaf_opacity.png", smoothGrey(32));
  const std::string leaf = workplace.path("leaf");
  for (const PageElement& map : mapsOf(reportOf(workplace, leaf))) {
    CHECK(captionsOf(map)[0] == "Exemplar");
    CHECK(imagesOf(map, "Original").empty());
  }
  const std::vector<PageElement> maps =
      mapsOf(reportOf(workplace, leaf, {"--crop", "0,0,48,40", "--flatten", "16"}));
  CHECK(captionsOf(maps[0])[1] == "Exemplar, cropped, without variation slower than 16 pixels");
  CHECK(extentsOf(imageOf(maps[0], "Original")) == std::array{48, 40});
  CHECK(!isSame(imageOf(maps[0], "Original"), imageOf(maps[0], "Exemplar")));
  CHECK(maps[1].all("h2").at(0).text == "opacity"); // flattening does not change opacity
  CHECK(captionsOf(maps[1])[0] == "Exemplar, cropped");
  CHECK(imagesOf(maps[1], "Original").empty());
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
  std::size_t missed = 0, targets = 0;
  for (const auto& [name, value, target, verdict] :
       measuresOf(mapsOf(parsedPage(workplace.read("report.html"))).at(0))) {
    targets += value.empty() || target.empty() ? 0U : 1U;
    if (verdict != "\u2717 missed")
      continue;
    ++missed;
    CHECK_THAT(output, Catch::Contains("\n  baseColor: " + name + " "));
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
  const PageElement page = reportOf(workplace, workplace.write("a.png", smooth(32)));
  for (const PageElement& chart : page.all("figure")) {
    std::array<double, 2> areas{};
    for (const std::size_t curve : {0u, 1u}) {
      const std::string path = chart.all("path").at(curve).attributes.at("d");
      static const std::regex point("[ML]([0-9.]+) ([0-9.]+)");
      std::vector<std::array<double, 2>> points;
      for (std::sregex_iterator at(path.begin(), path.end(), point), end; at != end; ++at)
        points.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
      REQUIRE(points.size() == 2 * 64 + 2);
      for (std::size_t i = 1; i < points.size(); ++i)
        areas[curve] += (points[i][0] - points[i - 1][0]) * (points[0][1] - points[i][1]);
    }
    CHECK(areas[0] == Approx(areas[1]).epsilon(0.03)); // of heights rounded to 0.1
  }
}

TEST_CASE("a report's command works in a shell for any file name") {
  const Workplace workplace;
  const std::string name = "it's </script><b> $HOME \\ \"x\"\n";
  const PageElement page =
      reportOf(workplace, workplace.write("moss.png", smoothGrey(16)), {"--name", name});
  CHECK(page.all("h1").at(0).text == name);
  const std::string command = page.all("pre").at(0).text;
  std::filesystem::remove(workplace.path("noise.glb"));
  const std::string line = "lichen() { " + programPath("lichen") + " \"$@\"; }; ";
  const Ended ended = run("/bin/sh", {"-c", line + command});
  INFO(ended.errors);
  CHECK(ended.code == 0);
  CHECK(parsedPage(workplace.read("report.html")).all("h1").at(0).text == name);
}

TEST_CASE("every kind of image gets a report, which shows narrow ones beside a wider result") {
  LinearImage light(40, 20, 3);
  for (std::size_t i = 0; i < light.values.size(); ++i)
    light.values[i] = float((i * 37) % 101) / 25.0f;
  const Workplace workplace;
  const std::string lamp = workplace.write("lamp.exr", light);
  CHECK(measuresOf(reportOf(workplace, lamp)).size() == 5);
  // The result is two exemplars along its longer side, and at least half as wide.
  for (const auto& [image, result] : {std::pair{SrgbImage(1, 1, 3), std::array{2, 2}},
                                      {SrgbImage(64, 64, 3), {128, 128}},
                                      {speckled(300, 2, 3), {600, 300}},
                                      {speckled(3, 200, 3), {200, 400}}}) {
    const PageElement map = reportOf(workplace, workplace.write("a.png", image));
    CHECK(measuresOf(map).size() == 5);
    CHECK(extentsOf(imageOf(map, "Exemplar")) == std::array{image.width, image.height});
    CHECK(extentsOf(imageOf(map, "Result")) == result);
  }
}

TEST_CASE("a report shows every map of a set") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("rock"));
  workplace.write("rock/rock_color.png", smooth(16));
  workplace.write("rock/rock_normal.png", smooth(16));
  workplace.write("rock/rock_rough.png", smoothGrey(16));
  const std::vector<PageElement> maps = mapsOf(reportOf(workplace, workplace.path("rock")));
  std::vector<std::string> targets;
  for (const PageElement& map : maps)
    targets.push_back(map.all("h2").at(0).text);
  CHECK(targets == std::vector<std::string>{"baseColor", "normal", "occlusionRoughnessMetallic"});
  CHECK(maps[1].all("figcaption").at(2).text == "normal z");
  CHECK(maps[2].all("figcaption").size() == 1);
  CHECK(maps[2].all("figcaption").at(0).text == "roughness");
}

TEST_CASE("an invalid report file is an error before the work starts") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smoothGrey(8));
  const std::string bundle = workplace.path("noise.glb");
  checkRefusal({"bake", input, "-o", bundle, "--report", workplace.path("r.txt")},
               int(ErrorKind::usage), {"r.txt", ".html"});
  checkRefusal({"bake", input, "-o", bundle, "--report", workplace.path("absent/r.html")},
               int(ErrorKind::environment), {"absent", "does not exist"});
  CHECK(workplace.names() == std::vector<std::string>{"moss.png"});
}
