// SPDX-License-Identifier: MIT
// Reads the tables of a glTF file.
#include "gltf_tables.h"

namespace lichen {

std::optional<Table> GltfTables::read(ObjectReader reader, FindingList& findings) {
  constexpr std::size_t kMaxBufferViews = 1u << 24u;
  const std::string name = reader.has("name") ? reader.text("name").value_or("") : "";
  const auto mimeType = reader.text("mimeType");
  if (mimeType && *mimeType != "image/ktx2")
    reader.error("table-mime-type", "mimeType", quoted(*mimeType) + "; expected image/ktx2");
  const auto view = reader.integer("bufferView", kMaxBufferViews, "buffer-view");
  reader.warnOfUnknown();
  if (!view)
    return std::nullopt;
  const auto bytes = file_.bufferView(std::size_t(*view), findings);
  if (!bytes)
    return std::nullopt;
  // Rejects tables that share bytes: a small file could otherwise claim any amount of memory.
  bytesRead_ += bytes->size();
  if (bytesRead_ > file_.loadedBytes()) {
    reader.error("table-overlap", "bufferView", "shares bytes with another table");
    return std::nullopt;
  }
  Result<Table> table = decodeKtx2(*bytes, name);
  if (!table && table.error().kind == ErrorKind::resources) {
    findings.error("memory", reader.pointer(), "not enough memory for its texels");
    return std::nullopt;
  }
  if (!table) {
    // Removes the name from the message, since the pointer identifies the table.
    findings.error("table-ktx2", reader.pointer(), table.error().message.substr(name.size() + 2));
    return std::nullopt;
  }
  return std::move(table).value();
}

} // namespace lichen
