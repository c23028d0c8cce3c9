// SPDX-License-Identifier: MIT
// Where the elements of the extension's `tables` keep their texels: a glTF file, or a cooked
// bundle.
#pragma once

#include "gltf_file.h"
#include "object_reader.h"

namespace lichen {

class TableSource {
public:
  virtual ~TableSource() = default;
  /// Reads and checks one element. Returns nothing if it is invalid. Called in ascending order.
  [[nodiscard]] virtual std::optional<Table> read(ObjectReader reader, FindingList& findings) = 0;
};

/// KTX2 files in buffer views.
class GltfTables : public TableSource {
public:
  explicit GltfTables(GltfFile& file) : file_(file) {}
  [[nodiscard]] std::optional<Table> read(ObjectReader reader, FindingList& findings) override;

private:
  GltfFile& file_;
  std::size_t bytesRead_ = 0;
};

} // namespace lichen
