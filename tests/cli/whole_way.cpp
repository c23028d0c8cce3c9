// SPDX-License-Identifier: MIT
// The whole way by the commands: a generated photograph, its bake, its picture, with each mapping.
// bake_to_picture.cpp draws every method.
#include "../gpu/golden_picture.h"
#include "command_run.h"
#include "device_needed.h"

#include <string>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

using Check = void (*)(const std::string& name, const std::filesystem::path& drawn);

/// Bakes with these options, gives the preview's materials this mapping, and renders.
void checkWholeWay(const std::string& name, const Arguments& options, const std::string& mapping,
                   Check check = test::checkGoldenPicture) {
  INFO(name);
  const Workplace workplace;
  const std::string noise = workplace.path("noise.glb"), picture = workplace.path("picture.png");
  REQUIRE(
      run(programPath("lichen-exemplars"), {workplace.path(""), "lichen_on_stone", "--size", "128"})
          .code == 0);
  bake(workplace, workplace.path("lichen_on_stone.png"), "noise.glb", options);
  succeed(
      {"apply", noise, "--noise", noise, "--material", "all", "--mapping", mapping, "-o", noise});
  const Ended drawn = run(programPath("lichen-render"),
                          {noise, "-o", picture, "--size", "256x144", "--frames", "4"});
  INFO(drawn.errors);
  REQUIRE(drawn.code == 0);
  check("whole_way_" + name, picture);
}

} // namespace

TEST_CASE("a generated photograph, baked and rendered, matches its golden image") {
  if (!hasDevice())
    return;
  checkWholeWay("tiling", {"--method", "tiling"}, "uv");
  checkWholeWay("layers", {"--layers", "2"}, "uv");
  // How FFTs round depends on the processor, and what is fitted with them differs visibly.
  checkWholeWay("structure", {"--method", "local-random-phase", "--structure", "0.5"}, "triplanar",
                test::checkGoldenLook);
  checkWholeWay("solid", {"--method", "local-random-phase", "--structure", "0"}, "solid",
                test::checkGoldenLook);
  checkWholeWay("kernels_surface", {"--method", "multiple-kernels"}, "surface",
                test::checkGoldenLook);
}
