// SPDX-License-Identifier: MIT
// An asset and its changes -> .glb or .gltf; see gltf_scene.h.
#include "gltf_output.h"
#include "gltf_scene_state.h"
#include "object_reader.h"

#include <lichen/files.h>
#include <lichen/gltf_files.h>

#include <algorithm>
#include <limits>

namespace lichen {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

bool namesFile(const json& object) {
  const std::string* uri = stringMember(object, "uri");
  return uri != nullptr && !uri->starts_with("data:");
}

/// The media type of an image file from its first bytes, or nothing if glTF does not support it.
std::optional<std::string> mediaTypeOf(std::span<const std::byte> image) {
  const std::string_view text(reinterpret_cast<const char*>(image.data()), image.size());
  if (text.starts_with("\x89PNG\r\n\x1a\n"))
    return "image/png";
  if (text.starts_with("\xff\xd8\xff"))
    return "image/jpeg";
  if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP"))
    return "image/webp"; // EXT_texture_webp
  if (text.starts_with("\xabKTX 20\xbb\r\n\x1a\n"))
    return "image/ktx2"; // KHR_texture_basisu
  return std::nullopt;
}

Error fileError(const std::filesystem::path& path, const std::string& what,
                ErrorKind kind = ErrorKind::badInput) {
  return {kind, path.string() + ": " + what};
}

/// How a JSON text is indented.
struct Indentation {
  int width = -1; ///< characters a level; -1 if the text has no lines
  char character = ' ';
};

Indentation indentationOf(std::string_view text) {
  constexpr std::size_t kWidest = 8; // limits the output of a small file
  const std::size_t begin = text.find('{') + 1;
  const std::string_view gap = text.substr(begin, text.find_first_not_of(" \t\r\n", begin) - begin);
  const std::size_t line = gap.rfind('\n');
  if (line == std::string_view::npos)
    return {};
  return {int(std::min(gap.size() - line - 1, kWidest)), gap.back() == '\t' ? '\t' : ' '};
}

} // namespace

/// Assembles the output. Modifies the state's own document, because an asset is written only once.
/// A friend of GltfScene, so outside the anonymous namespace.
class SceneWriter {
public:
  SceneWriter(GltfScene::State& state, const std::filesystem::path& path, bool isGlb)
      : state_(state), path_(path), isGlb_(isGlb) {}

  Result<void> run() {
    const bool wasGlb = state_.file->container().isGlb;
    if (isGlb_ && !wasGlb)
      if (Result<void> taken = takeImages(); !taken)
        return taken;
    if (Result<void> taken = chooseBuffer(); !taken)
      return taken;
    if (Result<void> stays = checkOtherFiles(); !stays)
      return stays;
    describeAdditions();
    return isGlb_ ? writeGlb() : writeGltf();
  }

private:
  /// Converts images in files and data URIs to buffer views.
  Result<void> takeImages() {
    for (std::size_t i = 0; i < state_.countOf("images"); ++i) {
      const json& image = state_.document()["images"][i];
      if (stringMember(image, "uri") == nullptr)
        continue;
      const Result<std::vector<std::byte>> bytes =
          readUri(state_.path, *stringMember(image, "uri"));
      if (!bytes)
        return fileError(state_.path,
                         "/images/" + std::to_string(i) + "/uri: " + bytes.error().message,
                         bytes.error().kind);
      const auto mediaType = mediaTypeOf(bytes.value());
      if (!mediaType)
        return fileError(state_.path, "/images/" + std::to_string(i) +
                                          "/uri: " + quoted(*stringMember(image, "uri")) +
                                          " is not a PNG, JPEG, WebP or KTX2; choose a .gltf as "
                                          "output");
      Json& taken = state_.edited["images"][i];
      taken.erase("uri");
      taken["bufferView"] = state_.added.addView(bytes.value(), sizeof(std::uint32_t));
      if (stringMember(image, "mimeType") == nullptr)
        taken["mimeType"] = *mediaType;
    }
    return {};
  }

  /// Selects the buffer that receives the additions, and its existing bytes. A .glb uses its first
  /// buffer. A .gltf uses a new one, or the first one if the asset was a .glb.
  Result<void> chooseBuffer() {
    const auto& chunk = state_.file->container().binaryChunk;
    const bool hasBuffer = state_.countOf("buffers") > 0;
    const bool firstIsChunk =
        chunk && hasBuffer && !state_.document()["buffers"][0].contains("uri");
    if (isGlb_ ? !hasBuffer : !firstIsChunk)
      return {};
    if (firstIsChunk) {
      before_ = *chunk;
    } else {
      FindingList findings;
      const auto bytes = state_.file->wholeBuffer(0, findings);
      if (!bytes)
        return asError(*findings.firstError(), state_.path.string());
      before_ = *bytes;
      state_.edited["buffers"][0].erase("uri");
    }
    takesFirst_ = true;
    return {};
  }

  /// Whether a .glb, unlike this .gltf, could embed all external files.
  [[nodiscard]] bool takesAllAsGlb() const {
    return !isGlb_ && !state_.file->container().isGlb && state_.countOf("buffers") < 2;
  }

  /// Checks that the output can still reach the asset's external files.
  Result<void> checkOtherFiles() {
    std::error_code ignored;
    if (std::filesystem::equivalent(folderOf(path_), folderOf(state_.path), ignored))
      return {};
    const bool tookImages = isGlb_ && !state_.file->container().isGlb;
    for (const char* array : {"buffers", "images"})
      for (std::size_t i = 0; i < state_.countOf(array); ++i) {
        const json& element = state_.document()[array][i];
        const bool isInside =
            array == std::string_view("images") ? tookImages : takesFirst_ && i == 0;
        if (namesFile(element) && !isInside)
          return fileError(path_,
                           state_.path.string() + " refers to files beside it, such as " +
                               quoted(*stringMember(element, "uri")) +
                               (takesAllAsGlb() ? "; choose a .glb, or an output in the same "
                                                  "folder"
                                                : "; choose an output in the same folder"),
                           ErrorKind::usage);
      }
    return {};
  }

  [[nodiscard]] std::size_t firstAdded() const {
    constexpr std::size_t kAlignment = 16; // a multiple of each view's alignment
    return (before_.size() + kAlignment - 1) / kAlignment * kAlignment;
  }

  void describeAdditions() {
    for (Json& view : state_.added.bufferViews) {
      view["buffer"] = takesFirst_ || isGlb_ ? 0 : state_.countOf("buffers");
      view["byteOffset"] = firstAdded() + view["byteOffset"].get<std::size_t>();
      state_.edited["bufferViews"].push_back(std::move(view));
    }
    for (Json& accessor : state_.added.accessors)
      state_.edited["accessors"].push_back(std::move(accessor));
  }

  /// Returns the bytes of the buffer, and updates its description in the document.
  std::vector<std::byte> finishBuffer() {
    std::vector<std::byte> binary(before_.begin(), before_.end());
    const std::vector<std::byte>& added = state_.added.binary;
    if (!added.empty()) {
      binary.resize(firstAdded());
      binary.insert(binary.end(), added.begin(), added.end());
    }
    if (binary.empty())
      return binary;
    Json& buffers = state_.edited["buffers"];
    if (!takesFirst_)
      buffers.push_back(Json::object());
    Json& buffer = takesFirst_ ? buffers[0] : buffers.back();
    // A buffer without additions keeps its length, which may be less than the chunk's.
    if (!added.empty())
      buffer["byteLength"] = binary.size();
    if (!isGlb_)
      buffer["uri"] = binaryUri(path_, binary);
    return binary;
  }

  /// The document's text, indented as the file's.
  [[nodiscard]] std::string editedText() const {
    const std::span<const std::byte> bytes = state_.file->container().text;
    const std::string_view before(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto [width, character] = indentationOf(before);
    return state_.edited.dump(width, character, false, Json::error_handler_t::replace) +
           (before.ends_with('\n') ? "\n" : "");
  }

  Result<void> writeGlb() {
    const std::vector<std::byte> binary = finishBuffer();
    const std::string text = editedText();
    constexpr std::size_t kFraming = 64; // headers and padding
    const std::span<const std::byte> others = state_.file->container().otherChunks;
    if (text.size() + binary.size() + others.size() >
        std::numeric_limits<std::uint32_t>::max() - kFraming)
      return fileError(path_, std::to_string(binary.size()) +
                                  " bytes, and a .glb holds less than 4 GiB; choose a .gltf");
    return replaceFile(path_, frameGlb(text, binary, others));
  }

  Result<void> writeGltf() {
    const std::vector<std::byte> binary = finishBuffer();
    return writeGltfPair(path_, editedText(), binary);
  }

  GltfScene::State& state_;
  const std::filesystem::path& path_;
  bool isGlb_;
  std::span<const std::byte> before_; ///< existing bytes of the buffer that receives the additions
  bool takesFirst_ = false;           ///< whether that is the document's first buffer
};

Result<void> GltfScene::write(const std::filesystem::path& path) {
  return withinMemory([&] { return path.string() + ": not enough memory to write it"; },
                      [&]() -> Result<void> {
                        const Result<bool> isGlb = isGlbPath(path);
                        return isGlb ? SceneWriter(*state_, path, isGlb.value()).run()
                                     : isGlb.error();
                      });
}

} // namespace lichen
