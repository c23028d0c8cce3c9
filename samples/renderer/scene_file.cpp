// SPDX-License-Identifier: MIT
// Faults of the glTF reader -> Faults; see scene_file.h.
#include "scene_file.h"

#include "printable.h"
#include "scene.h"

#include <lichen/gltf_files.h>

namespace lichen::renderer {
namespace {

constexpr std::uint64_t kMaxBytes = std::numeric_limits<std::uint32_t>::max();

[[noreturn]] void fail(const Finding& finding, const std::string& place) {
  const Error error = asError(finding, place);
  throw Fault{place.empty() ? error.message.substr(2) : error.message, error.kind};
}

} // namespace

SceneFile::SceneFile(std::vector<std::byte> bytes, std::filesystem::path path)
    : path_(std::move(path)), bytes_(std::move(bytes)) {
  FindingList findings;
  gltf_ = GltfFile::open(bytes_, filesBeside(path_), findings);
  if (!gltf_)
    fail(*findings.firstError(), "");
}

void SceneFile::checkBuffers() {
  std::uint64_t total = 0;
  root().each("buffers", [&](const Place& buffer, std::size_t) {
    total += buffer.integer("byteLength", 1, kMaxBytes);
    if (total > kMaxBufferBytes)
      throw Fault{"/buffers: more than " + std::to_string(kMaxBufferBytes) +
                      " bytes in total; use a smaller scene",
                  ErrorKind::resources};
  });
  root().each("buffers", [&](const Place& buffer, std::size_t i) { loadBuffer(buffer, i); });
  root().each("bufferViews", [&](const Place& view, std::size_t i) { checkView(view, i); });
}

void SceneFile::loadBuffer(const Place& buffer, std::size_t index) {
  const std::optional<std::string> uri = buffer.string("uri");
  if (uri && !uri->starts_with("data:")) {
    const Result<std::filesystem::path> path = fileOfUri(path_, *uri);
    std::error_code ignored;
    if (!path || !std::filesystem::is_regular_file(path.value(), ignored))
      buffer.fail("its file \"" + printable(pathOfUri(*uri).value_or(*uri)) +
                  "\" is not in the scene's folder; copy it there, or export a .glb");
  }
  FindingList findings;
  if (!gltf_->wholeBuffer(index, findings))
    fail(*findings.firstError(), "");
}

void SceneFile::checkView(const Place& view, std::size_t index) {
  FindingList findings;
  (void)view.member("buffer");
  const std::size_t buffer = *view.index("buffer", root().countOf("buffers"));
  const std::size_t available = gltf_->wholeBuffer(buffer, findings)->size();
  const std::uint64_t offset = view.integer("byteOffset", 0, kMaxBytes, 0);
  const std::uint64_t end = offset + view.integer("byteLength", 1, kMaxBytes);
  if (end > available)
    view.fail("bytes " + std::to_string(offset) + " to " + std::to_string(end) +
              " exceed their buffer of " + std::to_string(available) + " bytes");
  if (!gltf_->stridedView(index, findings))
    fail(*findings.firstError(), "");
}

Place SceneFile::element(const char* array, std::size_t index) const {
  return root().member(array).at(index);
}

std::optional<std::size_t> SceneFile::index(const Place& from, const char* key,
                                            const char* array) const {
  return from.index(key, root().countOf(array));
}

std::optional<Place> SceneFile::follow(const Place& from, const char* key,
                                       const char* array) const {
  const std::optional<std::size_t> found = index(from, key, array);
  return found ? std::optional(element(array, *found)) : std::nullopt;
}

std::size_t SceneFile::accessorOf(const Place& place) const {
  return place.asIndex(root().countOf("accessors"));
}

std::size_t SceneFile::countOf(const Place& place) const {
  return std::size_t(element("accessors", accessorOf(place)).integer("count", 1, kMostElements));
}

std::string SceneFile::typeOf(const Place& place) const {
  return element("accessors", accessorOf(place)).string("type").value_or("");
}

std::vector<std::uint32_t> SceneFile::indices(const Place& place, std::size_t limit) {
  FindingList findings;
  const std::size_t accessor = accessorOf(place);
  auto values = readIndices(*gltf_, accessor, std::numeric_limits<std::size_t>::max(), findings);
  check(place, findings);
  for (const std::uint32_t value : *values)
    if (value >= limit)
      element("accessors", accessor)
          .fail("index " + std::to_string(value) + " is out of range; expected 0 to " +
                std::to_string(limit - 1));
  return std::move(*values);
}

std::span<const std::byte> SceneFile::view(const Place& place) {
  FindingList findings;
  const auto bytes = gltf_->stridedView(place.asIndex(root().countOf("bufferViews")), findings);
  check(place, findings);
  return bytes->bytes;
}

void SceneFile::check(const Place& place, const FindingList& findings) {
  if (const Finding* fault = findings.firstError())
    fail(*fault, fault->code == kAccessorType ? place.pointer() : "");
}

} // namespace lichen::renderer
