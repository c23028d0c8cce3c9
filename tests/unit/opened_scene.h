// SPDX-License-Identifier: MIT
// A temporary folder of scenes, and a scene opened from a file.
#pragma once

#include "temporary_folder.h"

#include <lichen/files.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace lichen {

class Folder {
public:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return folder_.path() / name;
  }
  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            std::span<const std::byte> bytes) const {
    REQUIRE(replaceFile(path(name), bytes).ok());
    return path(name);
  }
  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& text) const {
    return write(name, std::as_bytes(std::span(text)));
  }

private:
  TemporaryFolder folder_;
};

inline GltfScene openScene(const std::filesystem::path& path) {
  Result<GltfScene> scene = GltfScene::open(path);
  INFO((scene ? "" : scene.error().message));
  REQUIRE(scene.ok());
  return std::move(scene).value();
}

} // namespace lichen
