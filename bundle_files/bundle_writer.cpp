// SPDX-License-Identifier: MIT
// A bundle and its preview -> GLB, or .gltf and .bin. Source: glTF 2.0 specification, section 4.
#include "extension_writer.h"
#include "findings.h"
#include "gltf_output.h"
#include "preview_material.h"
#include "preview_scene.h"

#include <lichen/bundle_writer.h>
#include <lichen/counted.h>
#include <lichen/files.h>
#include <lichen/gltf_files.h>

#include <limits>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

Error refusal(const std::string& what) { return Error{ErrorKind::usage, "bundle: " + what}; }

/// Checks that the parts of `file` are consistent. The bundle's content is checked after encoding.
Result<void> checkParts(const BundleFile& file) {
  const std::size_t noises = file.bundle.noises.size();
  if (noises == 0)
    return refusal("no noises; expected at least one");
  const std::size_t materials = file.bundle.materials.size();
  if (materials == 0 || file.previews.size() != materials)
    return refusal(counted(materials, "material") + " and " +
                   counted(file.previews.size(), "preview") + "; expected one of each or more");
  if (file.shape == PreviewShape::plane && materials > std::size_t(kGroundSectors))
    return refusal(std::to_string(materials) + " materials; a preview plane shows at most " +
                   std::to_string(kGroundSectors) + ", a sphere or none any number");
  for (std::size_t i = 0; i < materials; ++i) {
    const std::optional<MaterialNoise>& use = file.bundle.materials[i];
    if (!use || use->noise >= noises)
      return refusal("material " + std::to_string(i) + " uses no noise of the bundle");
    if (use->texCoord != 0 && file.shape != PreviewShape::none)
      return refusal("texCoord " + std::to_string(use->texCoord) +
                     "; the preview scene has only texture coordinates 0");
    if (file.previews[i].tilesPerImage < 1)
      return refusal(std::to_string(file.previews[i].tilesPerImage) +
                     " exemplars in a preview image; expected at least 1");
  }
  return {};
}

/// Width over height of the first noise's exemplar. 1 if the noise is invalid; the check of the
/// finished file reports that fault.
double exemplarAspect(const Bundle& bundle) {
  if (bundle.noises.front().maps.empty())
    return 1.0;
  const Noise& noise = bundle.noises.front();
  bool hasTables = true;
  visitTables(noise.maps.front(),
              [&](std::size_t table) { hasTables = hasTables && table < bundle.tables.size(); });
  if (!hasTables)
    return 1.0;
  const auto [width, height] = exemplarSize(bundle, noise, noise.maps.front());
  return double(std::max(width, 1u)) / double(std::max(height, 1u));
}

/// The whole document except for its buffer.
Json describe(const BundleFile& file, GltfBuilder& builder) {
  const Bundle& bundle = file.bundle;
  Json root;
  root["asset"] = {{"version", "2.0"}};
  if (!file.generator.empty())
    root["asset"]["generator"] = file.generator;
  root["extensionsUsed"].push_back(kExtensionName);
  root["extensions"][std::string(kExtensionName)] = describeBundle(bundle, builder);
  std::vector<bool> needsTangents;
  for (std::size_t i = 0; i < bundle.materials.size(); ++i) {
    const MaterialNoise& use = *bundle.materials[i];
    const Noise& noise = bundle.noises[use.noise];
    const bool named = i < bundle.materialNames.size() && !bundle.materialNames[i].empty();
    addMaterial(root, builder, named ? bundle.materialNames[i] : noise.name, noise, use,
                file.previews[i]);
    needsTangents.push_back(!file.previews[i].normal.empty());
  }
  addPreviewScene(root, builder, file.shape, needsTangents, exemplarAspect(bundle));
  if (!builder.accessors.empty())
    root["accessors"] = std::move(builder.accessors);
  root["bufferViews"] = std::move(builder.bufferViews);
  return root;
}

/// A document and the bytes of its buffer.
struct Encoded {
  Json root;
  std::vector<std::byte> binary;
};

Result<Encoded> encode(const BundleFile& file) {
  if (Result<void> parts = checkParts(file); !parts)
    return parts.error();
  GltfBuilder builder;
  Json root = describe(file, builder);
  root["buffers"].push_back({{"byteLength", builder.binary.size()}});
  return Encoded{std::move(root), std::move(builder.binary)};
}

/// Frames the document as a GLB, and checks that parseBundle() accepts it.
Result<std::vector<std::byte>> framed(const Encoded& encoded) {
  const std::string text = encoded.root.dump();
  constexpr std::size_t kFraming = 64; // headers and padding
  if (text.size() + encoded.binary.size() > std::numeric_limits<std::uint32_t>::max() - kFraming)
    return refusal(std::to_string(encoded.binary.size()) +
                   " bytes; expected less than 4 GiB in a GLB");
  std::vector<std::byte> glb = frameGlb(text, encoded.binary);
  if (const Result<Bundle> written = parseBundle(glb, "bundle"); !written)
    return Error{written.error().kind == ErrorKind::resources ? ErrorKind::resources
                                                              : ErrorKind::usage,
                 written.error().message};
  return glb;
}

/// Runs `operation`, which returns a Result, and converts its exceptions to errors.
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

Result<void> writeGltf(const std::filesystem::path& path, Encoded encoded) {
  encoded.root["buffers"][0]["uri"] = binaryUri(path, encoded.binary);
  return writeGltfPair(path, encoded.root.dump(2) + "\n", encoded.binary);
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
    const Result<bool> isGlb = isGlbPath(path);
    if (!isGlb)
      return isGlb.error();
    Result<Encoded> encoded = encode(file);
    if (!encoded)
      return encoded.error();
    {
      const Result<std::vector<std::byte>> glb = framed(encoded.value()); // also checks a .gltf
      if (!glb)
        return glb.error();
      if (isGlb.value())
        return replaceFile(path, glb.value());
    } // frees the GLB, which is as large as the bundle, before writing the .gltf
    return writeGltf(path, std::move(encoded).value());
  });
}

} // namespace lichen
