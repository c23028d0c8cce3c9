// SPDX-License-Identifier: MIT
#include "set_run.h"

#include <lichen/image_io.h>

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

std::string writeSet(const Workplace& workplace, const std::vector<FlatFile>& files) {
  const std::string folder = "set" + std::to_string(workplace.names().size());
  makeFolder(workplace, folder);
  for (const auto& [name, value] : files)
    workplace.write(folder + "/" + name, encodePng(flat(value), 8).value());
  return workplace.path(folder);
}

nlohmann::json baked(const Workplace& workplace, const Arguments& inputs, const Arguments& more) {
  const nlohmann::json report =
      jsonOf(Arguments{"bake"} + inputs + Arguments{"-o", workplace.path("set.glb")} + more);
  succeed({"check", workplace.path("set.glb")});
  return report;
}

} // namespace lichen::cli_test
