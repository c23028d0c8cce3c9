// SPDX-License-Identifier: MIT
// lichen-view as a user operates it: in a window on the test's own X server, without a window
// manager, through the events of a keyboard, a mouse and a closing window. Its screenshots are
// compared with images that lichen-render makes from the same file.
#include "checkout_paths.h"
#include "command_run.h"
#include "device_needed.h"
#include "x_server.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr const char* kFrames = "2";

SrgbImage picture(const std::string& path) {
  Result<ImageFile> file = readImage(path);
  REQUIRE(file.ok());
  return std::get<SrgbImage>(std::move(file).value().pixels);
}

SrgbImage rendered(const Workplace& workplace, const std::string& scene, const std::string& size,
                   const Arguments& more = {}) {
  const Ended ended =
      run(programPath("lichen-render"), Arguments{scene, "-o", workplace.path("reference.png"),
                                                  "--size", size, "--frames", kFrames, "--quiet"} +
                                            more);
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  return picture(workplace.path("reference.png"));
}

/// The viewer in its window, and the screenshots that the test requested.
class View {
public:
  View(const Workplace& workplace, XServer& server, const std::string& scene,
       const Arguments& more = {})
      : workplace_(workplace), server_(server),
        program_(programPath("lichen-view"),
                 Arguments{scene, "--size", "96x64", "--frames", kFrames, "--output",
                           workplace.path("."), "--validate"} +
                     more,
                 server.name(), workplace.path("view.out"), workplace.path("view.err")) {
    server.awaitWindow("scene.glb");
  }

  void press(char letter, bool shift = false) { server_.pressKey(letter, shift); }

  /// Takes the next screenshot.
  SrgbImage shot() {
    const std::string number = std::to_string(++shots_);
    const std::string name =
        workplace_.path("scene_" + std::string(3 - number.size(), '0') + number + ".png");
    press('w');
    REQUIRE(
        eventually([&] { return output().find(name.substr(name.rfind('/'))) != output().npos; }));
    return last_ = picture(name);
  }

  /// Returns whether the window comes to show the pixels of the last screenshot. Each has its own
  /// dither.
  bool showsLastShot() {
    constexpr int kDither = 2; // in codes
    return eventually([&] {
      const std::vector<unsigned char> codes =
          server_.pixels(unsigned(last_.width), unsigned(last_.height));
      for (std::size_t i = 0; i < codes.size(); ++i)
        if (std::abs(int(codes[i]) - int(std::lround(255.0f * last_.values[i]))) > kDither)
          return false;
      return codes.size() == last_.values.size();
    });
  }

  [[nodiscard]] std::string output() const { return workplace_.read("view.out"); }
  [[nodiscard]] std::string errors() const { return workplace_.read("view.err"); }
  int wait() { return program_.wait(); }

private:
  const Workplace& workplace_;
  XServer& server_;
  RunningProgram program_;
  int shots_ = 0;
  SrgbImage last_;
};

bool same(const SrgbImage& a, const SrgbImage& b) {
  return a.width == b.width && a.height == b.height && a.values == b.values;
}

void replace(const Workplace& workplace, const std::string& with) {
  std::filesystem::copy_file(with, workplace.path("scene.glb"),
                             std::filesystem::copy_options::overwrite_existing);
}

} // namespace

TEST_CASE(
    "the viewer reacts to keys, mouse, resizing and file changes, and closes without messages") {
  if (!hasDevice())
    return;
  const Workplace workplace;
  const std::string grain = workplace.write("grain.png", smoothGrey(32));
  const std::string other =
      bake(workplace, grain, "other.glb", {"--seed", "7", "--preview", "plane"});
  const std::string scene = bake(workplace, grain, "scene.glb", {"--preview", "plane"});
  const SrgbImage reference = rendered(workplace, scene, "96x64");

  XServer server;
  View view(workplace, server, scene);
  const SrgbImage first = view.shot();
  CHECK(same(first, reference));

  view.press('n'); // another seed
  CHECK_FALSE(same(view.shot(), first));
  view.press('r');
  CHECK(same(view.shot(), first));
  view.press('s'); // another scale
  CHECK_FALSE(same(view.shot(), first));
  view.press('s', true);
  view.press('m'); // uv, from the file
  view.press('m'); // triplanar
  CHECK_FALSE(same(view.shot(), first));
  CHECK(view.showsLastShot());
  view.press('r');
  CHECK(same(view.shot(), first));
  CHECK(view.showsLastShot());

  view.press('d'); // normals
  CHECK(same(view.shot(), rendered(workplace, scene, "96x64", {"--debug-view", "normals"})));
  view.press('d', true);

  server.drag(20, 10);
  CHECK_FALSE(same(view.shot(), first));
  view.press('f');
  server.resizeWindow(72, 48);
  const SrgbImage smaller = view.shot();
  CHECK(same(smaller, rendered(workplace, scene, "72x48")));
  CHECK(view.showsLastShot());

  workplace.write("scene.glb", std::string("half a file"));
  REQUIRE(
      eventually([&] { return view.errors().find("the last good scene") != std::string::npos; }));
  CHECK(same(view.shot(), smaller));
  replace(workplace, other);
  const SrgbImage reloaded = rendered(workplace, other, "72x48");
  REQUIRE_FALSE(same(reloaded, smaller));
  CHECK(eventually([&] { return same(view.shot(), reloaded); }));
  CHECK(view.showsLastShot());

  std::filesystem::remove(scene);
  CHECK(eventually(
      [&] { return view.errors().find("is gone; the last good") != std::string::npos; }));

  view.press('h');
  CHECK(eventually([&] { return view.output().find("Keys") != std::string::npos; }));
  server.closeWindow();
  CHECK(view.wait() == 0);
  const std::string errors = view.errors();
  INFO(errors);
  CHECK(std::count(errors.begin(), errors.end(), '\n') == 2); // broken file, missing file
}

TEST_CASE(
    "if its camera disappears from the file the viewer stays in place, and F frames the scene") {
  if (!hasDevice())
    return;
  const Workplace workplace;
  replace(workplace, sourcePath("tests/scenes/blender/interior.glb"));
  XServer server;
  View view(workplace, server, workplace.path("scene.glb"), {"--camera", "room"});
  const SrgbImage before = view.shot();
  const std::string plane = bake(workplace, workplace.write("grain.png", smoothGrey(32)),
                                 "plane.glb", {"--preview", "plane"});
  replace(workplace, plane);
  CHECK(eventually([&] { return !same(view.shot(), before); }));
  view.press('f');
  const SrgbImage framed = rendered(workplace, plane, "96x64", {"--camera", "auto"});
  CHECK(eventually([&] { return same(view.shot(), framed); }));
  server.closeWindow();
  CHECK(view.wait() == 0);
  CHECK(view.errors().empty());
}

TEST_CASE("the viewer reports what it cannot show in one line") {
  const Workplace workplace;
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  const auto refuses = [&](const Arguments& arguments, int code, const std::string& word) {
    const Ended ended = run(programPath("lichen-view"), arguments);
    INFO(ended.errors);
    CHECK(ended.code == code);
    CHECK(ended.output.empty());
    CHECK(std::count(ended.errors.begin(), ended.errors.end(), '\n') == 1);
    CHECK_THAT(ended.errors, Catch::Contains(word));
  };
  refuses({}, 2, "the scene is missing");
  refuses({"scene.glb", "--frames", "0"}, 2, "--frames 0");
  refuses({"scene.glb", "--output", workplace.path("nowhere")}, 4, "nowhere");
  refuses({workplace.path("absent.glb")}, 3, "absent.glb");
  const std::string scene =
      bake(workplace, workplace.write("grain.png", smoothGrey(16)), "scene.glb");
  refuses({scene}, 4, "no display");
  refuses({scene}, 4, "lichen-render renders to a file without a display");
}
