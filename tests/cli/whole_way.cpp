// SPDX-License-Identifier: MIT
// The whole way by the commands: a generated photograph, its bake, its picture.
#include "../gpu/golden_picture.h"
#include "command_run.h"
#include "device_needed.h"

#include <string>

using namespace lichen;
using namespace lichen::cli_test;

TEST_CASE("a generated photograph, baked and rendered, matches its golden image") {
  if (!hasDevice())
    return;
  for (const std::string method : {"tiling", "texton"}) {
    INFO(method);
    const Workplace workplace;
    REQUIRE(run(programPath("lichen-exemplars"),
                {workplace.path(""), "lichen_on_stone", "--size", "128"})
                .code == 0);
    const Ended baked = runLichen({"bake", workplace.path("lichen_on_stone.png"), "--method",
                                   method, "-o", workplace.path("noise.glb")});
    INFO(baked.errors);
    REQUIRE(baked.code == 0);
    const Ended drawn = run(programPath("lichen-render"),
                            {workplace.path("noise.glb"), "-o", workplace.path("picture.png"),
                             "--size", "256x144", "--frames", "4"});
    INFO(drawn.errors);
    REQUIRE(drawn.code == 0);
    test::checkGoldenPicture("whole_way_" + method, workplace.path("picture.png"));
  }
}
