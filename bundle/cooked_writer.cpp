// SPDX-License-Identifier: MIT
// Writes a cooked bundle; see cooked.h.
#include "cooked.h"
#include "extension_writer.h"

#include <lichen/bundle_writer.h>

#include <algorithm>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

std::size_t alignedUp(std::size_t size) {
  return (size + kCookedAlignment - 1) / kCookedAlignment * kCookedAlignment;
}

Json describeMaterial(const Bundle& bundle, std::size_t material) {
  Json json = Json::object();
  if (material < bundle.materialNames.size() && !bundle.materialNames[material].empty())
    json["name"] = bundle.materialNames[material];
  if (const auto& use = bundle.materials[material])
    json["extensions"][kExtensionName] = describeMaterialNoise(*use);
  return json;
}

/// Textures are not cooked; masks refer to textures of the glTF file by index, below this count.
std::size_t textureCount(const Bundle& bundle) {
  std::size_t count = 0;
  for (const auto& use : bundle.materials)
    if (use && use->mix.source == MixSource::texture)
      count = std::max(count, use->mix.texture + 1);
  return count;
}

/// The document, with the texels of the first table at `firstByte`.
Json describe(const Bundle& bundle, std::size_t firstByte) {
  Json extension = {{"tables", Json::array()}, {"noises", Json::array()}};
  std::size_t offset = firstByte;
  for (const Table& table : bundle.tables) {
    extension["tables"].push_back({{"name", table.name},
                                   {"vkFormat", vkFormatOf(table.format)},
                                   {"width", table.width},
                                   {"height", table.height},
                                   {"depth", table.depth},
                                   {"mipLevels", table.mipLevels},
                                   {"offset", offset}});
    offset = alignedUp(offset + table.bytes().size());
  }
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    extension["noises"].push_back(describeNoise(bundle.noises[n], n));
  Json document = Json::object();
  if (!bundle.noises.empty()) {
    document["extensionsUsed"] = {kExtensionName};
    document["extensions"][kExtensionName] = std::move(extension);
  }
  if (const std::size_t textures = textureCount(bundle); textures > 0)
    document["textures"] = Json(textures, Json::object());
  document["materials"] = Json::array();
  for (std::size_t material = 0; material < bundle.materials.size(); ++material)
    document["materials"].push_back(describeMaterial(bundle, material));
  return document;
}

void append(std::vector<std::byte>& file, std::uint32_t value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  file.insert(file.end(), bytes.begin(), bytes.end());
}

} // namespace

std::vector<std::byte> cookBundle(const Bundle& bundle) {
  // The description's size depends on the offsets' number of digits, so it may take several tries.
  std::vector<std::uint8_t> description;
  std::size_t firstByte = kCookedHeaderBytes;
  do {
    firstByte = std::max(firstByte, alignedUp(kCookedHeaderBytes + description.size()));
    description = Json::to_cbor(describe(bundle, firstByte));
  } while (kCookedHeaderBytes + description.size() > firstByte);
  std::vector<std::byte> file;
  const auto magic = std::as_bytes(std::span(kCookedMagic));
  file.insert(file.end(), magic.begin(), magic.end());
  append(file, kCookedVersion);
  append(file, std::uint32_t(description.size()));
  const auto described = std::as_bytes(std::span(description));
  file.insert(file.end(), described.begin(), described.end());
  file.resize(firstByte);
  for (const Table& table : bundle.tables) {
    file.resize(alignedUp(file.size()));
    file.insert(file.end(), table.bytes().begin(), table.bytes().end());
  }
  return file;
}

} // namespace lichen
