// SPDX-License-Identifier: MIT
// A bundle and its preview -> GLB, or .gltf and .bin. Source: glTF 2.0 specification, section 4.
#include "extension_writer.h"
#include "findings.h"
#include "preview_material.h"
#include "preview_scene.h"

#include <lichen/bundle_writer.h>
#include <lichen/files.h>
#include <lichen/gltf_container.h>

#include <limits>

namespace lichen {
namespace {

Error refusal(const std::string& what) { return Error{ErrorKind::usage, "bundle: " + what}; }

/// Whether the parts of `file` fit one another; what is inside the bundle is checked after
/// encoding.
Result<void> checkParts(const BundleFile& file) {
  const std::size_t noises = file.bundle.noises.size();
  if (noises == 0)
    return refusal("no noises; at least one is accepted");
  if (file.bundle.materials.size() != noises || file.previews.size() != noises)
    return refusal(std::to_string(file.bundle.materials.size()) + " materials and " +
                   std::to_string(file.previews.size()) + " previews for " +
                   std::to_string(noises) + " noises; one of each a noise is accepted");
  if (file.shape == PreviewShape::plane && noises > std::size_t(kGroundSectors))
    return refusal(std::to_string(noises) + " noises; a preview plane shows at most " +
                   std::to_string(kGroundSectors) + ", a sphere or none any number");
  for (std::size_t i = 0; i < noises; ++i) {
    const std::optional<MaterialNoise>& use = file.bundle.materials[i];
    if (!use || use->noise != i)
      return refusal("material " + std::to_string(i) + " does not use noise " + std::to_string(i));
    if (use->texCoord != 0 && file.shape != PreviewShape::none)
      return refusal("texCoord " + std::to_string(use->texCoord) +
                     "; the preview scene has only texture coordinates 0");
    if (file.previews[i].tilesPerImage < 1)
      return refusal(std::to_string(file.previews[i].tilesPerImage) +
                     " exemplars in a preview image; at least 1 is accepted");
  }
  return {};
}

/// Width over height of the first noise's exemplar. 1 where the bundle has none, or is at fault,
/// which is found when the finished file is checked.
double exemplarAspect(const Bundle& bundle) {
  if (bundle.noises.empty() || bundle.noises.front().maps.empty())
    return 1.0;
  const Noise& noise = bundle.noises.front();
  if (noise.maps.front().image >= bundle.tables.size())
    return 1.0;
  const auto [width, height] = exemplarSize(bundle, noise, noise.maps.front());
  return double(std::max(width, 1u)) / double(std::max(height, 1u));
}

/// The whole document but its buffer.
JsonTree describe(const BundleFile& file, GltfBuilder& builder) {
  const Bundle& bundle = file.bundle;
  JsonTree root;
  root["asset"] = {{"version", "2.0"}};
  if (!file.generator.empty())
    root["asset"]["generator"] = file.generator;
  root["extensionsUsed"].push_back(kExtensionName);
  root["extensions"][std::string(kExtensionName)] = describeBundle(bundle, builder);
  std::vector<bool> needsTangents;
  for (std::size_t i = 0; i < bundle.noises.size(); ++i) {
    const bool named = i < bundle.materialNames.size() && !bundle.materialNames[i].empty();
    addMaterial(root, builder, named ? bundle.materialNames[i] : bundle.noises[i].name,
                bundle.noises[i], *bundle.materials[i], file.previews[i]);
    needsTangents.push_back(!file.previews[i].normal.empty());
  }
  addPreviewScene(root, builder, file.shape, needsTangents, exemplarAspect(bundle));
  if (!builder.accessors.empty())
    root["accessors"] = std::move(builder.accessors);
  root["bufferViews"] = std::move(builder.bufferViews);
  return root;
}

/// A document that lacks only its buffer, and that buffer.
struct Encoded {
  JsonTree root;
  std::vector<std::byte> binary;
};

Result<Encoded> encode(const BundleFile& file) {
  if (Result<void> parts = checkParts(file); !parts)
    return parts.error();
  GltfBuilder builder;
  JsonTree root = describe(file, builder);
  return Encoded{std::move(root), std::move(builder.binary)};
}

/// As a GLB, which can be read: the checker sees it first.
Result<std::vector<std::byte>> framed(const Encoded& encoded) {
  JsonTree root = encoded.root;
  root["buffers"].push_back({{"byteLength", encoded.binary.size()}});
  const std::string text = root.compact();
  constexpr std::size_t kFraming = 64; // headers and padding
  if (text.size() + encoded.binary.size() > std::numeric_limits<std::uint32_t>::max() - kFraming)
    return refusal(std::to_string(encoded.binary.size()) + " bytes; a GLB holds below 4 GiB");
  std::vector<std::byte> glb = frameGlb(text, encoded.binary);
  if (const Result<Bundle> written = parseBundle(glb, "bundle"); !written)
    return Error{written.error().kind == ErrorKind::resources ? ErrorKind::resources
                                                              : ErrorKind::usage,
                 written.error().message};
  return glb;
}

/// A file name as a relative URI: everything but unreserved characters (RFC 3986) as %XX.
std::string uriOf(const std::string& fileName) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri;
  for (const char c : fileName) {
    const bool unreserved = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                            (c >= '0' && c <= '9') ||
                            std::string_view("-._~").find(c) != std::string_view::npos;
    if (unreserved) {
      uri += c;
    } else {
      const auto code = static_cast<unsigned char>(c);
      uri += {'%', kHex[code >> 4u], kHex[code & 15u]};
    }
  }
  return uri;
}

/// Runs `operation`, which returns a Result, with its exceptions turned into errors.
template <class Operation>
auto guarded(const Operation& operation) -> decltype(operation()) {
  return withinMemory([] { return "bundle: not enough memory to encode"; },
                      [&]() -> decltype(operation()) {
                        try {
                          return operation();
                        } catch (const nlohmann::json::exception&) {
                          return refusal("a name is not UTF-8");
                        }
                      });
}

constexpr std::size_t kHashDigits = 8;

/// FNV-1a of 32 bits in hexadecimal (Fowler, Noll, Vo; draft-eastlake-fnv): enough to tell apart
/// the few binaries that one stem ever has.
std::string hashOf(std::span<const std::byte> bytes) {
  std::uint32_t hash = 0x811c9dc5u;
  for (const std::byte b : bytes)
    hash = (hash ^ std::to_integer<std::uint32_t>(b)) * 0x01000193u;
  std::string digits(kHashDigits, '0');
  for (std::size_t i = kHashDigits; i-- > 0; hash >>= 4u)
    digits[i] = "0123456789abcdef"[hash & 15u];
  return digits;
}

/// STEM.HASH.bin beside `path`.
std::filesystem::path binaryBeside(const std::filesystem::path& path, const std::string& hash) {
  return std::filesystem::path(path).replace_extension("." + hash + ".bin");
}

/// The binary that the .gltf at `path`, if there is one, names, if this writer named it.
std::optional<std::filesystem::path> writtenBinary(const std::filesystem::path& path) {
  const Result<std::vector<std::byte>> file = readFile(path);
  if (!file)
    return std::nullopt;
  const std::variant<GltfContainer, Finding> opened = openGltf(file.value());
  const auto* container = std::get_if<GltfContainer>(&opened);
  if (container == nullptr)
    return std::nullopt;
  static const nlohmann::json::json_pointer uriPlace("/buffers/0/uri");
  const nlohmann::json& document = container->document;
  if (!document.contains(uriPlace) || !document[uriPlace].is_string())
    return std::nullopt;
  const auto& uri = document[uriPlace].get_ref<const std::string&>();
  const std::string before = uriOf(path.stem().string()) + ".";
  if (uri.size() < before.size() + kHashDigits)
    return std::nullopt;
  const std::string hash = uri.substr(before.size(), kHashDigits);
  if (uri != before + hash + ".bin" ||
      hash.find_first_not_of("0123456789abcdef") != std::string::npos)
    return std::nullopt;
  return binaryBeside(path, hash);
}

/// The binary is named by its content and comes first: at every moment the .gltf, old or new, names
/// a whole binary of its own.
Result<void> writeGltf(const std::filesystem::path& path, Encoded encoded) {
  const std::vector<std::byte>& binary = encoded.binary;
  const std::filesystem::path binaryPath = binaryBeside(path, hashOf(binary));
  encoded.root["buffers"].push_back(
      {{"byteLength", binary.size()}, {"uri", uriOf(binaryPath.filename().string())}});
  const std::string pretty = encoded.root.indented() + "\n";
  const std::optional<std::filesystem::path> superseded = writtenBinary(path);

  std::error_code ignored; // what cannot be removed is an unused file, no fault of the bundle
  const bool existed = std::filesystem::exists(binaryPath, ignored);
  if (Result<void> written = replaceFile(binaryPath, binary); !written)
    return written;
  Result<void> written = replaceFile(path, std::as_bytes(std::span(pretty)));
  if (!written && !existed)
    std::filesystem::remove(binaryPath, ignored);
  if (written && superseded && *superseded != binaryPath)
    std::filesystem::remove(*superseded, ignored);
  return written;
}

} // namespace

Result<std::vector<std::byte>> encodeGlb(const BundleFile& file) {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    const Result<Encoded> encoded = encode(file);
    return encoded ? framed(encoded.value()) : encoded.error();
  });
}

Result<void> writeBundle(const std::filesystem::path& path, const BundleFile& file) {
  return guarded([&]() -> Result<void> {
    const std::filesystem::path extension = path.extension();
    if (extension != ".glb" && extension != ".gltf")
      return Error{ErrorKind::usage, path.string() + ": extension " + quoted(extension.string()) +
                                         "; .glb or .gltf is accepted"};
    Result<Encoded> encoded = encode(file);
    if (!encoded)
      return encoded.error();
    {
      const Result<std::vector<std::byte>> glb = framed(encoded.value()); // checked for both forms
      if (!glb)
        return glb.error();
      if (extension == ".glb")
        return replaceFile(path, glb.value());
    } // as large as the bundle itself, which is still to be written
    return writeGltf(path, std::move(encoded).value());
  });
}

} // namespace lichen
