// SPDX-License-Identifier: MIT
// What lichen-view decides without a window: its camera, its keys, its file, its pictures' names.
#include "checkout_paths.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <controls.h>
#include <debug_views.h>
#include <file_watch.h>
#include <fstream>
#include <numbers>
#include <orbit_camera.h>
#include <screenshot.h>
#include <set>
#include <sstream>

using namespace lichen;
using namespace lichen::renderer;

namespace {

constexpr float kTolerance = 1e-5f; // a few roundings of numbers around 1 to 10
constexpr Sphere kSubject{{1.0, 2.0, 3.0}, 2.0f};

/// On the +z side of the subject, level, at a distance of 8.
Camera levelCamera() {
  Camera camera;
  camera.verticalFieldOfView = 2.0f * std::atan(0.5f); // at 8, half the window is 4 high
  camera.worldFromCamera[3] = glm::dvec4(1.0, 2.0, 11.0, 1.0);
  return camera;
}

void checkClose(glm::dvec3 a, glm::dvec3 b) {
  INFO(a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z);
  CHECK(glm::distance(a, b) < 10.0 * double(kTolerance));
}

Look lookAfter(Controls& controls, const std::string& letters, bool shift = false) {
  for (const char letter : letters)
    CHECK(controls.press({letter, shift}) == Request::none);
  return controls.look();
}

/// The letters that change a look which is not the start, or ask for something.
std::set<char> handledKeys() {
  std::set<char> keys;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    Controls controls(Look{});
    const Look before = lookAfter(controls, "N"); // so that R has something to take back
    if (controls.press({letter}) != Request::none || controls.look() != before)
      keys.insert(letter);
  }
  return keys;
}

/// The letters that lines of the help begin with.
std::set<char> keysOfHelp() {
  std::set<char> keys;
  std::istringstream lines{std::string(Controls::help())};
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 3 && line.starts_with("  ") && line[3] == ' ')
      keys.insert(line[2]);
  return keys;
}

/// The letters in the first column of the manual's table of keys.
std::set<char> keysOfManual() {
  std::set<char> keys;
  std::ifstream manual(sourcePath("docs/cli.md"));
  std::string line;
  while (std::getline(manual, line) && !line.starts_with("| key |"))
    continue;
  std::getline(manual, line); // the rule below the head
  while (std::getline(manual, line) && line.starts_with("| ")) {
    std::istringstream names(line.substr(2, line.find(" |") - 2));
    for (std::string name; names >> name;)
      if (name.size() == 1 || (name.size() == 2 && name[1] == ','))
        keys.insert(name[0]);
  }
  return keys;
}

} // namespace

TEST_CASE("an orbit camera that is not moved equals the camera that it started from") {
  Camera start = levelCamera();
  start.worldFromCamera[0] = glm::dvec4(0.0, 1.0, 0.0, 0.0); // rolled by a quarter
  start.worldFromCamera[1] = glm::dvec4(-1.0, 0.0, 0.0, 0.0);
  CHECK(OrbitCamera(start, kSubject).camera().worldFromCamera == start.worldFromCamera);
}

TEST_CASE("half an orbit keeps the distance and shows the subject from the other side") {
  OrbitCamera orbit(levelCamera(), kSubject);
  orbit.turn({1.0f, 0.0f}); // half a circle
  checkClose(eyeOf(orbit.camera()), {1.0f, 2.0f, -5.0f});
  orbit.turn({-0.5f, 0.0f}); // a quarter back: from -x, for a scene that follows the mouse
  checkClose(eyeOf(orbit.camera()), {-7.0f, 2.0f, 3.0f});
  const glm::dmat3 axes(orbit.camera().worldFromCamera);
  checkClose(axes[2], {-1.0f, 0.0f, 0.0f});
  checkClose(axes[1], {0.0f, 1.0f, 0.0f});
  CHECK(glm::determinant(axes) == Approx(1.0));
}

TEST_CASE("orbiting up never passes the pole, and the camera stays upright") {
  OrbitCamera orbit(levelCamera(), kSubject);
  for (int k = 0; k < 50; ++k)
    orbit.turn({0.1f, 0.3f});
  const Camera camera = orbit.camera();
  CHECK(camera.worldFromCamera[1].y > 0.0);
  CHECK(camera.worldFromCamera[2].y < 1.0);
  CHECK(camera.worldFromCamera[2].y > 0.99);
  CHECK(glm::distance(eyeOf(camera), kSubject.center) == Approx(8.0f));
}

TEST_CASE("panning by a window's height moves the subject by a window's height") {
  OrbitCamera orbit(levelCamera(), kSubject);
  orbit.pan({0.0f, 1.0f}); // downwards: the camera goes up
  checkClose(eyeOf(orbit.camera()), {1.0f, 10.0f, 11.0f});
  orbit.pan({0.5f, 0.0f}); // to the right: the camera goes left
  checkClose(eyeOf(orbit.camera()), {-3.0f, 10.0f, 11.0f});
}

TEST_CASE("zooming multiplies the distance, can be undone and never passes the subject") {
  OrbitCamera orbit(levelCamera(), kSubject);
  orbit.zoom(1.0f);
  CHECK(eyeOf(orbit.camera()).z - 3.0 == Approx(8.0f / 1.1f));
  orbit.zoom(-1.0f);
  checkClose(eyeOf(orbit.camera()), {1.0f, 2.0f, 11.0f});
  orbit.zoom(1000.0f);
  CHECK(eyeOf(orbit.camera()).z > 3.0);
  CHECK(double(orbit.camera().near) < eyeOf(orbit.camera()).z - 3.0);
  orbit.zoom(-1e6f);
  CHECK(std::isfinite(eyeOf(orbit.camera()).z));
}

TEST_CASE("the camera moves far from the world's origin as it does at the origin") {
  const glm::dvec3 way{1e7 + 0.1, -2e7 + 0.3, 3e7 - 0.7};
  Camera start = levelCamera();
  start.worldFromCamera[3] += glm::dvec4(way, 0.0);
  Sphere subject = kSubject;
  subject.center += way;
  OrbitCamera home(levelCamera(), kSubject), away(start, subject);
  for (OrbitCamera* orbit : {&home, &away}) {
    orbit->turn({0.3f, 0.1f});
    orbit->pan({0.01f, 0.02f});
    orbit->zoom(3.0f);
  }
  CHECK(glm::distance(eyeOf(away.camera()) - way, eyeOf(home.camera())) < 1e-5);
}

TEST_CASE("an orthographic camera zooms by changing the size of its view") {
  Camera start = levelCamera();
  start.perspective = false;
  start.halfHeight = 3.0f;
  start.far = 20.0f;
  OrbitCamera orbit(start, kSubject);
  orbit.zoom(2.0f);
  CHECK(orbit.camera().halfHeight == Approx(3.0f / 1.21f));
  checkClose(eyeOf(orbit.camera()), {1.0f, 2.0f, 11.0f});
}

TEST_CASE("each key changes its own quantity, and Shift and R undo it") {
  Look start;
  start.exposureEv = 1.0f;
  std::set<std::string> summaries;
  for (const char letter : keysOfManual()) {
    INFO(letter);
    Controls controls(start);
    if (letter == 'R' || controls.press({letter}) != Request::none)
      continue;
    const Look changed = controls.look();
    CHECK_FALSE(changed == start);
    CHECK(summaries.insert(controls.summary()).second);
    CHECK(lookAfter(controls, {letter}, true) == start);
    lookAfter(controls, {letter});
    CHECK(lookAfter(controls, "R") == start);
  }
}

TEST_CASE("four presses double a factor, and no number of them leaves its range") {
  Controls controls(Look{});
  CHECK(lookAfter(controls, "SSSS").noise.scaleFactor == 2.0);
  CHECK(lookAfter(controls, std::string(100, 'S')).noise.scaleFactor == 64.0);
  CHECK(lookAfter(controls, std::string(200, 'S'), true).noise.scaleFactor == 1.0 / 64.0);
  CHECK(lookAfter(controls, std::string(200, 'E')).exposureEv == 20.0f);
}

TEST_CASE("choices cycle: the file's own, then each, then the file's own") {
  Controls controls(Look{});
  CHECK(lookAfter(controls, "M").noise.mapping == NoiseMapping::uv);
  CHECK(lookAfter(controls, "M").noise.mapping == NoiseMapping::triplanar);
  CHECK(lookAfter(controls, "M").noise.mapping == NoiseMapping::solid);
  CHECK(controls.summary() == "mapping solid (triplanar where unsupported)");
  CHECK_FALSE(lookAfter(controls, "M").noise.mapping.has_value());
  for (const std::string_view name : debugViewNames())
    CHECK(lookAfter(controls, "D").debugView == name);
  CHECK(lookAfter(controls, "D").debugView.empty());
}

TEST_CASE("keys with a request return it, other keys return nothing") {
  Controls controls(Look{});
  CHECK(controls.press({'F'}) == Request::fit);
  CHECK(controls.press({'W'}) == Request::screenshot);
  CHECK(controls.press({'H'}) == Request::help);
  CHECK(controls.press({'Q'}) == Request::close);
  CHECK(controls.press({kEscape}) == Request::close);
  CHECK(controls.press({'X'}) == Request::none);
  CHECK(controls.look() == Look{});
}

TEST_CASE("the help and the manual have every key, and no other") {
  CHECK(keysOfHelp() == handledKeys());
  CHECK(keysOfManual() == handledKeys());
}

TEST_CASE("a file counts as changed once, when two checks in a row agree") {
  const auto stamp = [](std::uintmax_t bytes) {
    return FileStamp{std::filesystem::file_time_type{}, bytes};
  };
  const FileWatch::Clock::time_point start{};
  FileWatch watch(stamp(10));
  CHECK(watch.isDue(start));
  using Change = FileWatch::Change;
  CHECK(watch.look(stamp(10), start) == Change::none);
  CHECK_FALSE(watch.isDue(start + FileWatch::kInterval / 2));
  CHECK(watch.isDue(start + FileWatch::kInterval));
  CHECK(watch.look(stamp(4), start) == Change::none); // being written
  CHECK(watch.look(stamp(8), start) == Change::none); // still
  CHECK(watch.look(stamp(8), start) == Change::written);
  CHECK(watch.look(stamp(8), start) == Change::none);
  CHECK(watch.look(std::nullopt, start) == Change::none); // being replaced
  CHECK(watch.look(stamp(12), start) == Change::none);
  CHECK(watch.look(stamp(12), start) == Change::written);
  CHECK(watch.look(std::nullopt, start) == Change::none);
  CHECK(watch.look(std::nullopt, start) == Change::gone);
  CHECK(watch.look(std::nullopt, start) == Change::none);
  CHECK(watch.look(stamp(12), start) == Change::none);
  CHECK(watch.look(stamp(12), start) == Change::written); // it is back
}

TEST_CASE("a screenshot gets the first free name") {
  const TemporaryFolder folder;
  const std::filesystem::path scene = "elsewhere/moss.glb";
  CHECK(screenshotPath(folder.path(), scene).value() == folder.path() / "moss_001.png");
  std::ofstream(folder.path() / "moss_001.png") << "taken";
  std::filesystem::create_symlink("nowhere", folder.path() / "moss_002.png");
  CHECK(screenshotPath(folder.path(), scene).value() == folder.path() / "moss_003.png");
}
