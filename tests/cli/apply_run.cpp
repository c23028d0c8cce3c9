// SPDX-License-Identifier: MIT
#include "apply_run.h"

#include <lichen/bundle_writer.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>

namespace lichen::cli_test {
namespace {

struct Noises {
  Workplace workplace;
  std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  std::string wool = workplace.path("wool.glb");
};

const Noises& noises() {
  static const Noises noises;
  static const bool isWritten = writeBundle(noises.wool, example::smallTexton()).ok();
  REQUIRE(isWritten);
  return noises;
}

} // namespace

const std::string& moss() { return noises().moss; }

const std::string& wool() { return noises().wool; }

std::string Apply::written() const {
  if (!isText)
    return workplace.write("scene.glb", scene.glb());
  workplace.write("scene.bin", scene.binary);
  return workplace.write("scene.gltf", scene.gltf("scene.bin"));
}

Arguments Apply::arguments(const std::string& noise, const std::string& material,
                           const Arguments& more, const std::string& output) const {
  return Arguments{"apply",      written(), "--noise", noise,
                   "--material", material,  "-o",      workplace.path(output)} +
         more;
}

Ended Apply::run(const std::string& noise, const std::string& material,
                 const Arguments& more) const {
  return runLichen(arguments(noise, material, more));
}

std::string Apply::notes(const std::string& noise, const std::string& material,
                         const Arguments& more) const {
  return succeed(arguments(noise, material, more)).errors;
}

nlohmann::json Apply::document(const std::string& noise, const std::string& material,
                               const Arguments& more) const {
  succeed(arguments(noise, material, more));
  CHECK(jsonOf({"check", workplace.path("out.glb")}).at("warnings") == 0);
  return output();
}

nlohmann::json Apply::output() const {
  return GltfScene::open(workplace.path("out.glb")).value().document();
}

void Apply::refuses(const std::string& noise, const std::string& material, const Arguments& more,
                    const std::vector<std::string>& words, int code) const {
  checkRefusal(arguments(noise, material, more, "refused.glb"), code, words);
  CHECK(!std::filesystem::exists(workplace.path("refused.glb")));
}

} // namespace lichen::cli_test
