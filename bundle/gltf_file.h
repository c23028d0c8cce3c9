// SPDX-License-Identifier: MIT
// The JSON document of a glTF asset and the bytes of its buffers, wherever they are kept.
#pragma once

#include "findings.h"

#include <lichen/gltf_container.h>

namespace lichen {

/// An asset whose JSON is syntactically sound and an object. Buffers are loaded when first asked
/// for, so that only those which hold tables are read.
class GltfFile {
public:
  /// `folder` is where files that buffers name are looked up; empty when there is none. Borrows
  /// `file`. Faults that leave nothing to read are recorded, and nothing is returned.
  [[nodiscard]] static std::optional<GltfFile>
  open(std::span<const std::byte> file, std::filesystem::path folder, FindingList& findings);

  [[nodiscard]] const nlohmann::json& document() const { return container_.document; }
  [[nodiscard]] const GltfContainer& container() const { return container_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// The bytes of a buffer view of a table, in bounds. Faults are recorded at each call, those of a
  /// buffer once in each list.
  [[nodiscard]] std::optional<std::span<const std::byte>> bufferView(std::size_t index,
                                                                     FindingList& findings);
  /// As above of a view with vertices, whose elements may lie apart.
  struct StridedView {
    std::span<const std::byte> bytes;
    std::size_t stride = 0; ///< from element to element; 0 where they follow one another
  };
  [[nodiscard]] std::optional<StridedView> stridedView(std::size_t index, FindingList& findings);
  /// The bytes of a buffer.
  [[nodiscard]] std::optional<std::span<const std::byte>> wholeBuffer(std::size_t index,
                                                                      FindingList& findings);
  /// The file that a relative URI names inside the folder, or what is wrong.
  [[nodiscard]] Result<std::filesystem::path> pathOf(const std::string& uri) const;
  /// The whole of what a URI names: a file inside the folder, or data.
  [[nodiscard]] Result<std::vector<std::byte>> readWholeUri(const std::string& uri) const;
  /// Bytes of the buffers loaded so far.
  [[nodiscard]] std::size_t loadedBytes() const;

private:
  struct Buffer {
    bool loaded = false;
    std::optional<Finding> fault;   ///< for which it cannot be used
    std::vector<std::byte> storage; ///< empty for the GLB chunk, which is borrowed
    std::span<const std::byte> bytes;
  };

  /// Fills `target`; returns the fault for which it cannot.
  [[nodiscard]] std::optional<Finding> loadBuffer(std::size_t index, Buffer& target);
  /// The first `length` bytes of what a URI names, or what is wrong. A file must have them, a data
  /// URI may be shorter.
  [[nodiscard]] Result<std::vector<std::byte>> readUri(const std::string& uri,
                                                       std::size_t length) const;

  std::filesystem::path folder_;
  GltfContainer container_;
  std::vector<Buffer> buffers_;
  std::size_t storedBytes_ = 0; ///< of all buffers together
};

} // namespace lichen
