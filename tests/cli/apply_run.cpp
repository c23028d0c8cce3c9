// SPDX-License-Identifier: MIT
#include "apply_run.h"

#include <lichen/bundle_writer.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>

namespace lichen::cli_test {

Ended apply(const Workplace& workplace, const std::string& scene, const std::string& noise,
            const std::string& material, const Arguments& more, const std::string& output) {
  Arguments arguments{"apply",      scene,    "--noise", noise,
                      "--material", material, "-o",      workplace.path(output)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runLichen(arguments);
}

nlohmann::json applied(const Workplace& workplace, const std::string& scene,
                       const std::string& noise, const std::string& material, const Arguments& more,
                       const std::string& output) {
  const Ended ended = apply(workplace, scene, noise, material, more, output);
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  const Ended checked = runLichen({"check", workplace.path(output), "--json"});
  CHECK(checked.code == 0);
  CHECK(nlohmann::json::parse(checked.output).at("warnings") == 0);
  return GltfScene::open(workplace.path(output)).value().document();
}

std::string writeScene(const Workplace& workplace, const example::TinyScene& scene) {
  return workplace.write("scene.glb", scene.glb());
}

std::string writeTexton(const Workplace& workplace) {
  REQUIRE(writeBundle(workplace.path("wool.glb"), example::smallTexton()).ok());
  return workplace.path("wool.glb");
}

} // namespace lichen::cli_test
