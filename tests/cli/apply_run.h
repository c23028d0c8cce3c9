// SPDX-License-Identifier: MIT
// Runs `lichen apply` on scenes and noises that it writes.
#pragma once

#include "command_run.h"

#include <string>
#include <tiny_scene.h>

namespace lichen::cli_test {

inline constexpr const char* kExtension = "LICHEN_materials_exemplar_noise";

/// The bundle of a noise by tiling, 'moss', with a base colour only. It is made once.
[[nodiscard]] const std::string& moss();
/// The bundle of a texton noise, 'wool', with a height only.
[[nodiscard]] const std::string& wool();

/// A scene in a folder of its own, which `lichen apply` reads.
struct Apply {
  Workplace workplace;
  example::TinyScene scene = example::tableScene();
  bool isText = false; ///< a .gltf with its buffer beside it, else a .glb

  [[nodiscard]] auto& material(std::size_t index = 0) { return scene.json["materials"][index]; }
  [[nodiscard]] auto& primitive(std::size_t index = 0) {
    return scene.json["meshes"][0]["primitives"][index];
  }

  /// Writes the scene, and returns its path.
  [[nodiscard]] std::string written() const;
  [[nodiscard]] Arguments arguments(const std::string& noise, const std::string& material,
                                    const Arguments& more = {},
                                    const std::string& output = "out.glb") const;
  [[nodiscard]] Ended run(const std::string& noise, const std::string& material,
                          const Arguments& more = {}) const;
  /// Requires success, and returns the notes.
  [[nodiscard]] std::string notes(const std::string& noise, const std::string& material,
                                  const Arguments& more = {}) const;
  /// Requires that `lichen check` accepts the result, and returns its document.
  [[nodiscard]] nlohmann::json document(const std::string& noise, const std::string& material,
                                        const Arguments& more = {}) const;
  /// The document of the last run.
  [[nodiscard]] nlohmann::json output() const;
  /// As checkRefusal(). There must be no output then.
  void refuses(const std::string& noise, const std::string& material, const Arguments& more,
               const std::vector<std::string>& words, int code = kUsage) const;
};

} // namespace lichen::cli_test
