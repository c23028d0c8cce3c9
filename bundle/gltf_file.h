// SPDX-License-Identifier: MIT
// The JSON document of a glTF asset, and the bytes of its buffers from the GLB chunk, data URIs or
// a function that supplies external files.
#pragma once

#include "findings.h"
#include "gltf_container.h"

namespace lichen {

/// The error of a URI that names no file in the asset's folder.
[[nodiscard]] Error unresolvedUri(const std::string& uri);

/// An asset whose JSON is well-formed and an object. Buffers load on first use, so that unused ones
/// are not read.
class GltfFile {
public:
  /// Borrows `file`. `externalFile` may be empty. If the container is invalid, records the fault
  /// and returns nothing.
  [[nodiscard]] static std::optional<GltfFile>
  open(std::span<const std::byte> file, ExternalFile externalFile, FindingList& findings);

  [[nodiscard]] const nlohmann::json& document() const { return container_.document; }
  [[nodiscard]] const GltfContainer& container() const { return container_; }

  /// The bytes of a table's buffer view, within the buffer. Records faults at each call, but a
  /// fault of the buffer only once per list.
  [[nodiscard]] std::optional<std::span<const std::byte>> bufferView(std::size_t index,
                                                                     FindingList& findings);
  /// As bufferView(), for a view of vertices, which may have a stride.
  struct StridedView {
    std::span<const std::byte> bytes;
    std::size_t stride = 0; ///< bytes between element starts; 0 if tightly packed
  };
  [[nodiscard]] std::optional<StridedView> stridedView(std::size_t index, FindingList& findings);
  /// The required extension that compresses a buffer view, or nothing. If a file does not require
  /// the extension, the view's bytes are not compressed [EXT_meshopt_compression, fallback
  /// buffers].
  [[nodiscard]] std::optional<std::string> compressionOf(std::size_t view) const;
  /// The bytes of a buffer. Records faults as bufferView() does.
  [[nodiscard]] std::optional<std::span<const std::byte>> wholeBuffer(std::size_t index,
                                                                      FindingList& findings);
  /// Total bytes of the buffers loaded so far.
  [[nodiscard]] std::size_t loadedBytes() const;

private:
  struct Buffer {
    bool loaded = false;
    std::optional<Finding> fault;   ///< the reason why it is unusable, if any
    std::vector<std::byte> storage; ///< empty for the GLB chunk, which is borrowed
    std::span<const std::byte> bytes;
  };

  /// Reads a data URI, or the first bytes of an external file.
  [[nodiscard]] Result<std::vector<std::byte>> readUri(const std::string& uri,
                                                       std::size_t length) const;
  /// Fills `target`, or returns the fault.
  [[nodiscard]] std::optional<Finding> loadBuffer(std::size_t index, Buffer& target);

  ExternalFile externalFile_;
  GltfContainer container_;
  std::vector<Buffer> buffers_;
  std::vector<std::string> compressions_; ///< of buffer views, required
  std::size_t storedBytes_ = 0;           ///< bytes of all buffers from files and data URIs
};

} // namespace lichen
