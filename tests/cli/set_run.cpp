// SPDX-License-Identifier: MIT
#include "set_run.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace lichen::cli_test {

SrgbImage flat(const Pixel& value, int width, int height) {
  SrgbImage image(width, height, int(value.size()));
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = value[i % value.size()];
  return image;
}

void makeFolder(const Workplace& workplace, const std::string& name) {
  std::filesystem::create_directory(workplace.path(name));
}

nlohmann::json baked(const Workplace& workplace, Arguments inputs, const Arguments& more) {
  inputs.insert(inputs.begin(), "bake");
  inputs.insert(inputs.end(), {"-o", workplace.path("set.glb"), "--json"});
  inputs.insert(inputs.end(), more.begin(), more.end());
  const Ended ended = runLichen(inputs);
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  CHECK(runLichen({"check", workplace.path("set.glb")}).code == 0);
  return nlohmann::json::parse(ended.output);
}

} // namespace lichen::cli_test
