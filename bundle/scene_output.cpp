// SPDX-License-Identifier: MIT
// An asset and its changes -> .glb or .gltf; see gltf_scene.h.
#include "gltf_output.h"
#include "gltf_scene_state.h"

#include <lichen/files.h>

#include <algorithm>
#include <limits>

namespace lichen {
namespace {

using nlohmann::json;

/// A member that is a string, or null.
const std::string* stringMember(const json& object, const char* key) {
  const auto member = object.find(key);
  return member == object.end() ? nullptr : member->get_ptr<const std::string*>();
}

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

} // namespace

/// Assembles the output. Modifies the state's own changes, because an asset is written only once.
class SceneWriter {
public:
  SceneWriter(GltfScene::State& state, const std::filesystem::path& path)
      : state_(state), path_(path), isGlb_(path.extension() == ".glb") {}

  Result<void> run() {
    const bool wasGlb = state_.file->container().isGlb;
    if (isGlb_ && !wasGlb)
      if (Result<void> taken = takeImages(); !taken)
        return taken;
    if (Result<void> taken = chooseBuffer(); !taken)
      return taken;
    if (Result<void> stays = checkOtherFiles(); !stays)
      return stays;
    describeViews();
    return isGlb_ ? writeGlb() : writeGltf();
  }

private:
  [[nodiscard]] const json& buffers() const {
    static const json kNone = json::array();
    const auto list = state_.document().find("buffers");
    return list == state_.document().end() ? kNone : *list;
  }

  /// Converts images in files and data URIs to buffer views.
  Result<void> takeImages() {
    for (std::size_t i = 0; i < state_.countOf("images"); ++i) {
      const json& image = state_.document()["images"][i];
      if (stringMember(image, "uri") == nullptr || state_.imagesLeft.contains(i))
        continue;
      const Result<std::vector<std::byte>> bytes =
          state_.file->readWholeUri(*stringMember(image, "uri"));
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
      JsonChange& change = state_.changes.member("images").element(i);
      change.member("uri").remove();
      change.member("bufferView").set(state_.addView(bytes.value(), sizeof(std::uint32_t), false));
      if (stringMember(image, "mimeType") == nullptr)
        change.member("mimeType").set(*mediaType);
    }
    return {};
  }

  /// Selects the buffer that receives the additions, and its existing bytes. A .glb uses its first
  /// buffer. A .gltf uses a new one, or the first one if the asset was a .glb.
  Result<void> chooseBuffer() {
    const auto& chunk = state_.file->container().binaryChunk;
    const bool firstIsChunk = chunk && !buffers().empty() && !buffers()[0].contains("uri");
    if (isGlb_ ? buffers().empty() : !firstIsChunk)
      return {};
    if (firstIsChunk) {
      before_ = *chunk;
    } else {
      FindingList findings;
      const auto bytes = state_.file->wholeBuffer(0, findings);
      if (!bytes) {
        const Finding& fault = findings.all().front();
        return fileError(state_.path, fault.pointer + ": " + fault.message,
                         fault.code == "memory" ? ErrorKind::resources : ErrorKind::badInput);
      }
      before_ = *bytes;
      state_.changes.member("buffers").element(0).member("uri").remove();
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

  void describeViews() {
    constexpr int kArrayBuffer = 34962;
    const std::size_t buffer = takesFirst_ || isGlb_ ? 0 : buffers().size();
    for (const AddedView& added : state_.addedViews) {
      JsonTree view = {{"buffer", buffer},
                       {"byteOffset", firstAdded() + added.offset},
                       {"byteLength", added.length}};
      if (added.isVertices)
        view["target"] = kArrayBuffer;
      state_.changes.member("bufferViews").append(std::move(view));
    }
  }

  /// Returns the bytes of the buffer, and updates its description in the document.
  std::vector<std::byte> finishBuffer() {
    std::vector<std::byte> binary(before_.begin(), before_.end());
    if (!state_.added.empty()) {
      binary.resize(firstAdded());
      binary.insert(binary.end(), state_.added.begin(), state_.added.end());
    }
    if (binary.empty())
      return binary;
    JsonTree description = {{"byteLength", binary.size()}};
    if (!isGlb_)
      description["uri"] = binaryUri(path_, binary);
    JsonChange& change = state_.changes.member("buffers");
    if (!takesFirst_) {
      change.append(description);
      return binary;
    }
    // A buffer without additions keeps its length, which may be less than the chunk's.
    if (!state_.added.empty())
      change.element(0).member("byteLength").set(binary.size());
    if (!isGlb_)
      change.element(0).member("uri").set(binaryUri(path_, binary));
    return binary;
  }

  Result<std::string> changedText() {
    const std::span<const std::byte> text = state_.file->container().text;
    Result<std::string> changed = changedJson(
        std::string_view(reinterpret_cast<const char*>(text.data()), text.size()), state_.changes);
    if (!changed)
      return fileError(state_.path, changed.error().message);
    return changed;
  }

  Result<void> writeGlb() {
    const std::vector<std::byte> binary = finishBuffer();
    const Result<std::string> text = changedText();
    if (!text)
      return text.error();
    constexpr std::size_t kFraming = 64; // headers and padding
    const std::span<const std::byte> others = state_.file->container().otherChunks;
    if (text.value().size() + binary.size() + others.size() >
        std::numeric_limits<std::uint32_t>::max() - kFraming)
      return fileError(path_, std::to_string(binary.size()) +
                                  " bytes, and a .glb holds less than 4 GiB; choose a .gltf");
    return replaceFile(path_, frameGlb(text.value(), binary, others));
  }

  Result<void> writeGltf() {
    const std::vector<std::byte> binary = finishBuffer();
    const Result<std::string> text = changedText();
    return text ? writeGltfPair(path_, text.value(), binary) : text.error();
  }

  GltfScene::State& state_;
  const std::filesystem::path& path_;
  bool isGlb_;
  std::span<const std::byte> before_; ///< existing bytes of the buffer that receives the additions
  bool takesFirst_ = false;           ///< whether that is the document's first buffer
};

std::vector<std::size_t> GltfScene::absentImages() const {
  std::vector<std::size_t> absent;
  for (std::size_t i = 0; i < state_->countOf("images"); ++i) {
    const json& image = document()["images"][i];
    if (!namesFile(image))
      continue;
    const Result<std::filesystem::path> file = state_->file->pathOf(*stringMember(image, "uri"));
    std::error_code ignored;
    if (file && !std::filesystem::exists(file.value(), ignored))
      absent.push_back(i);
  }
  return absent;
}

void GltfScene::leaveImage(std::size_t image) { state_->imagesLeft.insert(image); }

Result<void> GltfScene::write(const std::filesystem::path& path) {
  const std::filesystem::path extension = path.extension();
  if (extension != ".glb" && extension != ".gltf")
    return Error{ErrorKind::usage, path.string() + ": extension " + quoted(extension.string()) +
                                       "; expected .glb or .gltf"};
  return withinMemory([&] { return path.string() + ": not enough memory to write it"; },
                      [&] { return SceneWriter(*state_, path).run(); });
}

} // namespace lichen
