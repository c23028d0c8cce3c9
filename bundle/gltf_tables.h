// SPDX-License-Identifier: MIT
// The elements of the extension's `tables`: KTX2 files in buffer views.
#pragma once

#include "gltf_file.h"
#include "object_reader.h"

namespace lichen {

class GltfTables {
public:
  explicit GltfTables(GltfFile& file) : file_(file) {}
  /// Reads and checks one element. Returns nothing if it is invalid.
  [[nodiscard]] std::optional<Table> read(ObjectReader reader, FindingList& findings);

private:
  GltfFile& file_;
  std::size_t bytesRead_ = 0;
};

} // namespace lichen
