// SPDX-License-Identifier: MIT
// The extension's root, tables, noises and material uses, read and checked against one another.
#include "extension_reader.h"

#include <algorithm>
#include <limits>
#include <set>

namespace lichen {
namespace {

using nlohmann::json;
using Tables = std::vector<std::optional<Table>>;

constexpr std::size_t kMaxTables = 4096;
constexpr std::size_t kMaxNoises = 1024;
constexpr std::size_t kMaxMaterials = 65536;
constexpr std::size_t kMaxMaps = 6; // as many as targets

std::string elementPointer(const std::string& array, std::size_t index) {
  return array + "/" + std::to_string(index);
}

bool listsExtension(const json& root, const char* key) {
  const auto list = root.find(key);
  return list != root.end() && list->is_array() &&
         std::find(list->begin(), list->end(), std::string(kExtensionName)) != list->end();
}

/// The extension's own object inside a glTF object, or null.
const json* extensionOf(const json& object) {
  if (!object.is_object())
    return nullptr;
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object())
    return nullptr;
  const auto extension = extensions->find(std::string(kExtensionName));
  return extension == extensions->end() ? nullptr : &*extension;
}

std::string extensionPointer(const std::string& object) {
  return object + "/extensions/" + std::string(kExtensionName);
}

/// One element of `tables`, or nothing when it cannot be used.
std::optional<Table> readTable(ObjectReader reader, GltfFile& file, std::size_t& bytesRead,
                               FindingList& findings) {
  constexpr std::size_t kMaxBufferViews = 1u << 24u;
  const std::string name = reader.has("name") ? reader.text("name").value_or("") : "";
  const auto mimeType = reader.text("mimeType");
  if (mimeType && *mimeType != "image/ktx2")
    reader.error("table-mime-type", "mimeType", quoted(*mimeType) + "; image/ktx2 is accepted");
  const auto view = reader.integer("bufferView", kMaxBufferViews, "buffer-view");
  reader.warnOfUnknown();
  if (!view)
    return std::nullopt;
  const auto bytes = file.bufferView(std::size_t(*view), findings);
  if (!bytes)
    return std::nullopt;
  // Tables that share bytes would let a small file claim any amount of memory.
  bytesRead += bytes->size();
  if (bytesRead > file.loadedBytes()) {
    reader.error("table-overlap", "bufferView", "shares bytes with another table");
    return std::nullopt;
  }
  Result<Table> table = decodeKtx2(*bytes, name);
  if (!table) {
    // The message begins with the name, which the pointer replaces.
    findings.error(table.error().kind == ErrorKind::resources ? "memory" : "table-ktx2",
                   reader.pointer(), table.error().message.substr(name.size() + 2));
    return std::nullopt;
  }
  return std::move(table).value();
}

Noise readNoise(ObjectReader reader, const Tables& tables, FindingList& findings) {
  Noise noise;
  noise.name = reader.text("name").value_or("");
  if (const auto method = reader.text("method")) {
    if (*method != noise.method)
      reader.error("noise-method", "method", quoted(*method) + "; tiling is accepted");
  }
  if (const auto revision = reader.integer("revision", std::numeric_limits<int>::max());
      revision && *revision != std::uint64_t(kTilingRevision))
    reader.error("noise-revision", "revision",
                 std::to_string(*revision) + "; " + std::to_string(kTilingRevision) +
                     " is accepted: a later version wrote this file");
  noise.tileSizeMetres = reader.numberOr("tileSize", kTileSizeRange, noise.tileSizeMetres);
  const json* maps = reader.array("maps", kMaxMaps);
  std::set<MapTarget> targets;
  for (std::size_t i = 0; maps != nullptr && i < maps->size(); ++i) {
    ObjectReader mapReader((*maps)[i], elementPointer(reader.pointerTo("maps"), i), findings);
    const std::size_t errorsBefore = findings.errorCount();
    noise.maps.push_back(readMap(mapReader, tables));
    if (findings.errorCount() == errorsBefore && !targets.insert(noise.maps.back().target).second)
      mapReader.error("map-target-duplicate", "target",
                      "another map of this noise has the target " +
                          std::string(nameOf(noise.maps.back().target)));
  }
  reader.warnOfUnknown();
  return noise;
}

std::array<double, 2> readOffset(ObjectReader& reader) {
  if (!reader.has("offset"))
    return {0.0, 0.0};
  const auto offset = reader.numbers("offset", kOffsetRange);
  if (offset && offset->size() == 2)
    return {(*offset)[0], (*offset)[1]};
  if (offset)
    reader.error("count", "offset", std::to_string(offset->size()) + " values; 2 are accepted");
  return {0.0, 0.0};
}

MaterialNoise readMaterial(ObjectReader reader, std::size_t noiseCount) {
  MaterialNoise use;
  const auto noise = reader.integer("noise", noiseCount == 0 ? 0 : noiseCount - 1, "noise-index");
  if (noise && noiseCount == 0)
    reader.error("noise-index", "noise", "there are no noises");
  use.noise = std::size_t(noise.value_or(0));
  if (reader.has("mapping")) {
    const std::string name = reader.text("mapping").value_or("uv");
    const auto mapping = mappingFrom(name);
    // Tiling has no parameterization-free and no solid form.
    if (!mapping || *mapping == Mapping::surface || *mapping == Mapping::solid)
      reader.error("material-mapping", "mapping",
                   quoted(name) + "; uv or triplanar is accepted for the method tiling");
    use.mapping = mapping.value_or(Mapping::uv);
  }
  if (reader.has("texCoord"))
    use.texCoord = int(reader.integer("texCoord", kMaxTexCoord).value_or(0));
  if (reader.has("seed"))
    use.seed = std::uint32_t(
        reader.integer("seed", std::numeric_limits<std::uint32_t>::max()).value_or(1));
  use.scale = reader.numberOr("scale", kScaleRange, use.scale);
  use.offset = readOffset(reader);
  use.rotation = reader.numberOr("rotation", kRotationRange, use.rotation);
  use.blendSharpness = reader.numberOr("blendSharpness", kBlendSharpnessRange, use.blendSharpness);
  use.contrast = reader.numberOr("contrast", kContrastRange, use.contrast);
  reader.warnOfUnknown();
  return use;
}

void readMaterials(const json& root, Bundle& bundle, FindingList& findings) {
  const auto list = root.find("materials");
  if (list == root.end())
    return;
  if (!list->is_array() || list->size() > kMaxMaterials) {
    findings.error("count", "/materials",
                   "not an array of at most " + std::to_string(kMaxMaterials));
    return;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const json& material = (*list)[i];
    const std::string pointer = elementPointer("/materials", i);
    std::string name;
    std::optional<MaterialNoise> use;
    if (material.is_object() && material.contains("name") && material["name"].is_string())
      name = material["name"].get<std::string>();
    if (const json* extension = extensionOf(material)) {
      use = readMaterial(ObjectReader(*extension, extensionPointer(pointer), findings),
                         bundle.noises.size());
      if (material["extensions"].contains("KHR_materials_unlit"))
        findings.warn("material-unlit", pointer + "/extensions/KHR_materials_unlit",
                      "an unlit material shows the preview, not the noise");
    }
    bundle.materialNames.push_back(std::move(name));
    bundle.materials.push_back(use);
  }
}

void warnOfUnusedTables(const Bundle& bundle, const std::string& pointer, FindingList& findings) {
  std::set<std::size_t> used;
  for (const Noise& noise : bundle.noises)
    for (const NoiseMap& map : noise.maps) {
      used.insert(map.gaussian);
      if (map.inverseTable)
        used.insert(*map.inverseTable);
    }
  for (std::size_t i = 0; i < bundle.tables.size(); ++i)
    if (!used.contains(i))
      findings.warn("table-unused", elementPointer(pointer, i), "no map uses this table");
}

void checkNoiseNames(const Bundle& bundle, const std::string& pointer, FindingList& findings) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < bundle.noises.size(); ++i) {
    const std::string& name = bundle.noises[i].name;
    if (!name.empty() && !names.insert(name).second)
      findings.error("noise-name-duplicate", elementPointer(pointer, i) + "/name",
                     quoted(name) + " is the name of another noise too");
  }
}

/// The root object: tables first, since maps are checked against them.
void readRoot(GltfFile& file, const json& extension, Bundle& bundle, FindingList& findings) {
  ObjectReader reader(extension, extensionPointer(""), findings);
  const json* tableList = reader.array("tables", kMaxTables);
  Tables tables;
  std::size_t bytesRead = 0;
  for (std::size_t i = 0; tableList != nullptr && i < tableList->size(); ++i)
    tables.push_back(readTable(
        ObjectReader((*tableList)[i], elementPointer(reader.pointerTo("tables"), i), findings),
        file, bytesRead, findings));
  const json* noiseList = reader.array("noises", kMaxNoises);
  for (std::size_t i = 0; noiseList != nullptr && i < noiseList->size(); ++i)
    bundle.noises.push_back(readNoise(
        ObjectReader((*noiseList)[i], elementPointer(reader.pointerTo("noises"), i), findings),
        tables, findings));
  reader.warnOfUnknown();
  checkNoiseNames(bundle, reader.pointerTo("noises"), findings);
  for (std::optional<Table>& table : tables)
    bundle.tables.push_back(table ? std::move(*table) : Table{});
  if (findings.errorCount() == 0)
    warnOfUnusedTables(bundle, reader.pointerTo("tables"), findings);
}

} // namespace

Bundle readExtension(GltfFile& file, FindingList& findings) {
  const json& root = file.document();
  Bundle bundle;
  const json* extension = extensionOf(root);
  if (extension != nullptr)
    readRoot(file, *extension, bundle, findings);
  readMaterials(root, bundle, findings);
  const bool used = extension != nullptr ||
                    std::any_of(bundle.materials.begin(), bundle.materials.end(),
                                [](const auto& material) { return material.has_value(); });
  if (used && !listsExtension(root, "extensionsUsed"))
    findings.error("extensions-used", "/extensionsUsed",
                   "does not list " + std::string(kExtensionName));
  if (listsExtension(root, "extensionsRequired"))
    findings.error("extensions-required", "/extensionsRequired",
                   "lists " + std::string(kExtensionName) + ", which a viewer may always ignore");
  if (!used)
    findings.warn("extension-absent", "", "the file does not use " + std::string(kExtensionName));
  return bundle;
}

} // namespace lichen
