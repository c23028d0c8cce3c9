// SPDX-License-Identifier: MIT
// Reads the buffers of a glTF asset; see gltf_file.h. Input is hostile: every offset and length is
// checked before use.
// Source: glTF 2.0 specification, section 3.6.
#include "gltf_file.h"

#include "data_uri.h"

#include <lichen/counted.h>

#include <algorithm>
#include <charconv>

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxBuffers = 4096;
/// Maximum total size of buffers from files and data URIs, equal to the maximum of a GLB chunk.
/// Without it, a small .gltf could name one big file in every buffer.
constexpr std::size_t kMaxStoredBytes = std::size_t(4) << 30;

/// [glTF 2.0, section 5.11.4]
constexpr std::uint64_t kMaxStride = 252, kStrideStep = 4;

/// A non-negative integer member, `fallback` if absent, or nothing for another type.
std::optional<std::uint64_t> countMember(const json& object, const char* key,
                                         std::optional<std::uint64_t> fallback) {
  const auto member = object.find(key);
  if (member == object.end())
    return fallback;
  if (!member->is_number_unsigned())
    return std::nullopt;
  return member->get<std::uint64_t>();
}

/// Element `index` of a root array of objects, or null.
const json* element(const json& root, const char* array, std::size_t index) {
  const auto found = root.find(array);
  if (found == root.end() || !found->is_array() || index >= found->size())
    return nullptr;
  const json& value = (*found)[index];
  return value.is_object() ? &value : nullptr;
}

} // namespace

std::string quoted(const std::string& text) {
  constexpr std::size_t kMostCharacters = 60;
  const std::string shown =
      text.size() > kMostCharacters ? text.substr(0, kMostCharacters) + "..." : text;
  return json(shown).dump(-1, ' ', true, json::error_handler_t::replace);
}

std::optional<std::string> pathOfUri(const std::string& uri) {
  if (uri.find(':') != std::string::npos)
    return std::nullopt;
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    char c = uri[i];
    if (c == '%') {
      unsigned char code = 0;
      const char* const digits = uri.data() + i + 1;
      if (i + 2 >= uri.size() || std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2)
        return std::nullopt;
      c = char(code);
      i += 2;
    }
    if (c == '\0')
      return std::nullopt;
    path.push_back(c);
  }
  return path;
}

Error unresolvedUri(const std::string& uri) {
  return {ErrorKind::badInput,
          "URI " + quoted(uri) +
              (pathOfUri(uri) ? " points outside the file's folder"
                              : "; expected a relative path or a base64 data URI")};
}

std::optional<GltfFile> GltfFile::open(std::span<const std::byte> file, ExternalFile externalFile,
                                       FindingList& findings) {
  std::variant<GltfContainer, Finding> opened = openGltf(file);
  if (const auto* fault = std::get_if<Finding>(&opened)) {
    findings.error(fault->code, fault->pointer, fault->message);
    return std::nullopt;
  }
  GltfFile gltf;
  gltf.externalFile_ = std::move(externalFile);
  gltf.container_ = std::get<GltfContainer>(std::move(opened));
  const json& document = gltf.document();
  if (const auto list = document.find("buffers"); list != document.end() && list->is_array()) {
    if (list->size() > kMaxBuffers) {
      findings.error("count", "",
                     std::to_string(list->size()) + " buffers; expected at most " +
                         std::to_string(kMaxBuffers));
      return std::nullopt;
    }
    gltf.buffers_.resize(list->size());
  }
  if (const auto list = document.find("extensionsRequired"); list != document.end())
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
      if (std::find(list->begin(), list->end(), name) != list->end())
        gltf.compressions_.emplace_back(name);
  return gltf;
}

Result<std::vector<std::byte>> GltfFile::readUri(const std::string& uri, std::size_t length) const {
  if (isDataUri(uri))
    return readDataUri(uri);
  if (!externalFile_ || !pathOfUri(uri))
    return unresolvedUri(uri);
  return externalFile_(uri, length);
}

std::optional<Finding> GltfFile::loadBuffer(std::size_t index, Buffer& target) {
  const std::string pointer = "/buffers/" + std::to_string(index);
  const auto fault = [&](const char* code, const char* member, std::string message) {
    return Finding{Finding::Severity::error, code, pointer + member, std::move(message)};
  };
  const json* description = element(document(), "buffers", index);
  if (description == nullptr)
    return fault("buffer", "", "absent or not an object");
  const auto length = countMember(*description, "byteLength", std::nullopt);
  if (!length || *length == 0)
    return fault("buffer", "/byteLength", "absent or not a positive integer");
  const auto uri = description->find("uri");
  if (uri == description->end()) {
    if (index != 0 || !container_.binaryChunk)
      return fault("buffer", "", "has no uri, and the file has no GLB chunk for it");
    target.bytes = *container_.binaryChunk;
  } else {
    if (!uri->is_string())
      return fault("buffer-uri", "/uri", "not a string");
    if (*length > kMaxStoredBytes - storedBytes_)
      return fault("buffer", "/byteLength",
                   std::to_string(*length) + " bytes; expected at most " +
                       std::to_string(kMaxStoredBytes) + " in all buffers");
    Result<std::vector<std::byte>> read =
        readUri(uri->get_ref<const std::string&>(), std::size_t(*length));
    if (!read)
      return fault(read.error().kind == ErrorKind::resources ? "memory" : "buffer-uri", "/uri",
                   read.error().message);
    target.storage = std::move(read).value();
    storedBytes_ += std::size_t(*length);
    target.bytes = target.storage;
  }
  if (*length > target.bytes.size())
    return fault("buffer", "/byteLength",
                 counted(*length, "byte") + "; available: " + std::to_string(target.bytes.size()));
  target.bytes = target.bytes.first(std::size_t(*length));
  return std::nullopt;
}

std::optional<std::span<const std::byte>> GltfFile::bufferView(std::size_t index,
                                                               FindingList& findings) {
  if (const json* view = element(document(), "bufferViews", index);
      view != nullptr && view->contains("byteStride")) {
    findings.error("buffer-view", "/bufferViews/" + std::to_string(index) + "/byteStride",
                   "is set for a table's bytes; expected none");
    return std::nullopt;
  }
  const std::optional<StridedView> view = stridedView(index, findings);
  return view ? std::optional(view->bytes) : std::nullopt;
}

std::optional<GltfFile::StridedView> GltfFile::stridedView(std::size_t index,
                                                           FindingList& findings) {
  const std::string pointer = "/bufferViews/" + std::to_string(index);
  const json* view = element(document(), "bufferViews", index);
  if (view == nullptr) {
    findings.error("buffer-view", pointer, "absent or not an object");
    return std::nullopt;
  }
  const auto bufferIndex = countMember(*view, "buffer", std::nullopt);
  const auto offset = countMember(*view, "byteOffset", 0);
  const auto length = countMember(*view, "byteLength", std::nullopt);
  const auto stride = countMember(*view, "byteStride", 0);
  if (!bufferIndex || *bufferIndex >= buffers_.size()) {
    findings.error("buffer-view", pointer + "/buffer", "not the index of a buffer");
    return std::nullopt;
  }
  if (!offset || !length || *length == 0) {
    findings.error("buffer-view", pointer,
                   "byteOffset and byteLength must be integers, and the length positive");
    return std::nullopt;
  }
  if (!stride || *stride > kMaxStride || *stride % kStrideStep != 0) {
    findings.error("buffer-view", pointer + "/byteStride",
                   (stride ? std::to_string(*stride) : "not an integer") +
                       "; expected a multiple of 4, at most " + std::to_string(kMaxStride));
    return std::nullopt;
  }
  const std::optional<std::span<const std::byte>> source =
      wholeBuffer(std::size_t(*bufferIndex), findings);
  if (!source)
    return std::nullopt;
  if (*offset > source->size() || *length > source->size() - *offset) {
    findings.error("buffer-view", pointer,
                   counted(*length, "byte") + " from " + std::to_string(*offset) +
                       " on; the buffer has " + std::to_string(source->size()));
    return std::nullopt;
  }
  return StridedView{source->subspan(std::size_t(*offset), std::size_t(*length)),
                     std::size_t(*stride)};
}

std::optional<std::span<const std::byte>> GltfFile::wholeBuffer(std::size_t index,
                                                                FindingList& findings) {
  Buffer& source = buffers_[index];
  if (!source.loaded) {
    source.fault = loadBuffer(index, source); // may throw
    source.loaded = true;
  }
  if (source.fault) {
    findings.repeat(*source.fault);
    return std::nullopt;
  }
  return source.bytes;
}

std::optional<std::string> GltfFile::compressionOf(std::size_t view) const {
  for (const std::string& name : compressions_)
    if (document().contains(
            json::json_pointer("/bufferViews/" + std::to_string(view) + "/extensions/" + name)))
      return name;
  return std::nullopt;
}

std::size_t GltfFile::loadedBytes() const {
  std::size_t total = 0;
  for (const Buffer& buffer : buffers_)
    total += buffer.bytes.size();
  return total;
}

} // namespace lichen
