// SPDX-License-Identifier: MIT
// Reads the extension's root, tables, noises and materials, and checks them against one another.
#include "extension_reader.h"

#include "methods/method_reader.h"

#include <lichen/layered_noise.h>

#include <algorithm>
#include <limits>
#include <set>

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxTables = 4096;
constexpr std::size_t kMaxNoises = 1024;
constexpr std::size_t kMaxMaterials = 65536;

std::string elementPointer(const std::string& array, std::size_t index) {
  return array + "/" + std::to_string(index);
}

bool listsExtension(const json& root, const char* key) {
  const auto list = root.find(key);
  return list != root.end() && list->is_array() &&
         std::find(list->begin(), list->end(), std::string(kExtensionName)) != list->end();
}

/// The extension's object inside a glTF object, or null.
const json* extensionOf(const json& object) {
  return memberOf(memberOf(&object, "extensions"), kExtensionName);
}

std::string extensionPointer(const std::string& object) {
  return object + "/extensions/" + std::string(kExtensionName);
}

/// The noise's revision, or 0 if it states no valid one.
int statedRevision(const json& noise) {
  const json* revision = memberOf(&noise, "revision");
  if (revision == nullptr || !revision->is_number_unsigned())
    return 0;
  const auto value = revision->get<std::uint64_t>();
  return value <= std::uint64_t(std::numeric_limits<int>::max()) ? int(value) : 0;
}

/// Whether a noise has an unsupported method or a later revision. readNoise() reads all others and
/// reports their faults.
bool isUnknown(const json& noise) {
  const std::string* name = stringMember(noise, "method");
  if (name == nullptr)
    return false;
  const std::optional<Method> method = methodFrom(*name);
  return !method || statedRevision(noise) > revisionOf(*method);
}

/// Reads what this version understands of an unsupported noise.
IgnoredNoise ignoreNoise(const json& noise, std::size_t place, const std::string& pointer,
                         FindingList& findings) {
  IgnoredNoise ignored;
  ignored.place = place;
  ignored.method = noise["method"].get<std::string>();
  ignored.revision = statedRevision(noise);
  if (const std::string* name = stringMember(noise, "name"))
    ignored.name = *name;
  const bool isMethodKnown = methodFrom(ignored.method).has_value();
  findings.warn(isMethodKnown ? "noise-revision" : "noise-method",
                pointer + (isMethodKnown ? "/revision" : "/method"),
                ignored.reason() +
                    ": the noise is ignored, and its materials show their core textures");
  return ignored;
}

/// Reads a noise but for its layers, which name other noises.
Noise readNoise(ObjectReader reader, const Tables& tables, FindingList& findings) {
  Noise noise;
  static_cast<void>(reader.optional("layers"));
  noise.name = reader.text("name").value_or("");
  Method method{};
  if (const auto named = reader.text("method"))
    method = methodFrom(*named).value_or(method); // isUnknown() has ruled out other methods
  if (const auto revision = reader.integer("revision", std::numeric_limits<int>::max());
      revision && *revision != std::uint64_t(revisionOf(method)))
    reader.error("noise-revision", "revision",
                 std::to_string(*revision) + "; expected " + std::to_string(revisionOf(method)));
  noise.tileSizeMetres = reader.numberOr("tileSize", kTileSizeRange, noise.tileSizeMetres);
  noise.preparation = readPreparation(reader, findings);
  noise.data = readerOf(method).readNoise(reader, findings);
  const json* maps = reader.array("maps", kMaxMaps);
  std::set<MapTarget> targets;
  for (std::size_t i = 0; maps != nullptr && i < maps->size(); ++i) {
    ObjectReader mapReader((*maps)[i], elementPointer(reader.pointerTo("maps"), i), findings);
    const std::size_t errorsBefore = findings.errorCount();
    noise.maps.push_back(readMap(mapReader, noise, tables, findings));
    if (findings.errorCount() == errorsBefore && !targets.insert(noise.maps.back().target).second)
      mapReader.error("map-target-duplicate", "target",
                      "another map of this noise has the target " +
                          std::string(nameOf(noise.maps.back().target)));
  }
  reader.warnOfUnknown();
  return noise;
}

/// The index of a file's noise in Bundle::noises or Bundle::ignoredNoises.
struct NoisePlace {
  bool isIgnored = false;
  std::size_t index = 0;
};
using NoisePlaces = std::vector<NoisePlace>;

/// Reads the layers of all noises, and checks them once all noises are without faults.
void readAllLayers(const json& list, const std::string& pointer, const NoisePlaces& places,
                   Bundle& bundle, FindingList& findings) {
  std::vector<std::optional<std::size_t>> known;
  for (const NoisePlace& place : places)
    known.push_back(place.isIgnored ? std::nullopt : std::optional(place.index));
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!known[i] || !list[i].is_object() || !list[i].contains("layers"))
      continue;
    ObjectReader reader(list[i], elementPointer(pointer, i), findings);
    bundle.noises[*known[i]].layers = readLayers(reader, *known[i], known, findings);
  }
  if (findings.errorCount() > 0)
    return;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (known[i] && bundle.noises[*known[i]].layers)
      if (const std::string fault = layersFault(bundle, *known[i]); !fault.empty())
        findings.error("layer-fit", elementPointer(pointer, i) + "/layers", fault);
}

NoisePlaces readNoises(const json& list, const std::string& pointer, const Tables& tables,
                       Bundle& bundle, FindingList& findings) {
  NoisePlaces places;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = elementPointer(pointer, i);
    if (isUnknown(list[i])) {
      places.push_back({true, bundle.ignoredNoises.size()});
      bundle.ignoredNoises.push_back(ignoreNoise(list[i], i, place, findings));
      continue;
    }
    places.push_back({false, bundle.noises.size()});
    bundle.noises.push_back(readNoise(ObjectReader(list[i], place, findings), tables, findings));
    const std::string& name = bundle.noises.back().name;
    if (!name.empty() && !names.insert(name).second)
      findings.error("noise-name-duplicate", place + "/name",
                     quoted(name) + " is the name of another noise too");
  }
  return places;
}

/// The ignored noise of a material, or null. This version does not check the other members of such
/// a material.
IgnoredNoise* ignoredNoiseOf(const json& use, const NoisePlaces& places, Bundle& bundle) {
  const json* index = memberOf(&use, "noise");
  if (index == nullptr || !index->is_number_unsigned() ||
      index->get<std::uint64_t>() >= places.size())
    return nullptr;
  const NoisePlace& place = places[index->get<std::size_t>()];
  return place.isIgnored ? &bundle.ignoredNoises[place.index] : nullptr;
}

/// Reads a material's mapping and checks that the noise `index` supports it, if there is one.
Mapping readMapping(ObjectReader& reader, const Bundle& bundle, std::size_t index) {
  const Noise* noise = bundle.noises.empty() ? nullptr : &bundle.noises[index];
  const Method method = noise == nullptr ? Method{} : noise->method();
  const std::string name = reader.text("mapping").value_or("uv");
  const std::optional<Mapping> mapping = mappingFrom(name);
  if (!mapping || !mappingFits(method, *mapping)) {
    reader.error("material-mapping", "mapping",
                 quoted(name) + "; expected one of " + mappingsOf(method) + " for the method " +
                     std::string(nameOf(method)));
    return Mapping::uv;
  }
  if (noise == nullptr)
    return *mapping;
  if (const std::string obstacle = mappingObstacle(bundle, index, *mapping); !obstacle.empty())
    reader.error("material-mapping", "mapping", obstacle);
  return *mapping;
}

/// Reads the coordinate space of a mapping that evaluates 3-D positions.
NoiseSpace readSpace(ObjectReader& reader, Mapping mapping) {
  const std::string name = reader.text("space").value_or("world");
  const std::optional<NoiseSpace> space = noiseSpaceFrom(name);
  if (!space)
    reader.error("material-space", "space", quoted(name) + "; expected world or object");
  else if (!isInSpace(mapping))
    reader.error("material-space", "space",
                 quoted(name) + "; expected none for the mapping " + std::string(nameOf(mapping)) +
                     ", which is not in space");
  return space.value_or(NoiseSpace::world);
}

/// Reads how tiles are rotated. The noise is known if `findings` has no error.
std::uint32_t readTileRotation(ObjectReader& reader, const Bundle& bundle, std::size_t noise,
                               const FindingList& findings) {
  const json* member = reader.optional("tileRotation");
  if (member == nullptr)
    return 0;
  constexpr std::uint64_t kNone = 3; // no value that tiles take
  const std::uint64_t value = member->is_number_unsigned() ? member->get<std::uint64_t>() : kNone;
  if ((value <= 2 || value == 4) &&
      (findings.errorCount() > 0 || takesTileRotation(bundle, noise, std::uint32_t(value))))
    return std::uint32_t(value);
  reader.error("material-tile-rotation", "tileRotation",
               (member->is_number() ? member->dump() : std::string(member->type_name())) +
                   "; expected " + std::string(kTileRotations));
  return 0;
}

MaterialNoise readMaterial(ObjectReader reader, const NoisePlaces& places, const Bundle& bundle,
                           std::size_t textures, FindingList& findings) {
  MaterialNoise use;
  const auto noise = reader.integer("noise", places.empty() ? 0 : places.size() - 1, "noise-index");
  if (noise && places.empty())
    reader.error("noise-index", "noise", "there are no noises");
  else if (noise)
    use.noise = places[std::size_t(*noise)].index;
  if (reader.has("mapping"))
    use.mapping = readMapping(reader, bundle, use.noise);
  if (reader.has("space"))
    use.space = readSpace(reader, use.mapping);
  use.texCoord = reader.integerOr("texCoord", kMaxTexCoord, use.texCoord);
  use.seed = reader.integerOr("seed", std::numeric_limits<std::uint32_t>::max(), use.seed);
  use.scale = reader.numberOr("scale", kScaleRange, use.scale);
  use.offset = reader.pairOr("offset", kOffsetRange, use.offset);
  use.rotation = reader.numberOr("rotation", kRotationRange, use.rotation);
  use.blendSharpness = reader.numberOr("blendSharpness", kBlendSharpnessRange, use.blendSharpness);
  use.planeSharpness = reader.numberOr("planeSharpness", kPlaneSharpnessRange, use.planeSharpness);
  use.contrast = reader.numberOr("contrast", kContrastRange, use.contrast);
  use.tileRotation = readTileRotation(reader, bundle, use.noise, findings);
  use.impacts = reader.numberOr("impacts", kImpactsRange, use.impacts);
  if (reader.has("pointProcess")) {
    const std::string name = reader.text("pointProcess").value_or("stratified");
    const auto process = pointProcessFrom(name);
    if (!process)
      reader.error("material-point-process", "pointProcess",
                   quoted(name) + "; expected stratified or poisson");
    use.pointProcess = process.value_or(use.pointProcess);
  }
  use.mix = readMixWeight(reader, textures, findings);
  // A noise with errors may have no number of steps.
  if (reader.has("mix") && findings.errorCount() == 0 && !isMix(bundle.noises[use.noise]))
    findings.warn("mix-without-steps", reader.pointerTo("mix"),
                  "the noise is not a mix, so its weight has no effect");
  reader.warnOfUnknown();
  return use;
}

void readMaterials(const json& root, const NoisePlaces& places, Bundle& bundle,
                   FindingList& findings) {
  const auto list = root.find("materials");
  if (list == root.end())
    return;
  if (!list->is_array() || list->size() > kMaxMaterials) {
    findings.error("count", "/materials",
                   "not an array of at most " + std::to_string(kMaxMaterials));
    return;
  }
  const json* textureList = memberOf(&root, "textures");
  const std::size_t textures =
      textureList != nullptr && textureList->is_array() ? textureList->size() : 0;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const json& material = (*list)[i];
    const std::string pointer = elementPointer("/materials", i);
    const std::string* name = stringMember(material, "name");
    std::optional<MaterialNoise> use;
    const json* extension = extensionOf(material);
    IgnoredNoise* ignored =
        extension != nullptr ? ignoredNoiseOf(*extension, places, bundle) : nullptr;
    if (ignored != nullptr) {
      ignored->materials.push_back(i);
    } else if (extension != nullptr) {
      use = readMaterial(ObjectReader(*extension, extensionPointer(pointer), findings), places,
                         bundle, textures, findings);
      if (material["extensions"].contains("KHR_materials_unlit"))
        findings.warn("material-unlit", pointer + "/extensions/KHR_materials_unlit",
                      "an unlit material shows the preview, not the noise");
    }
    bundle.materialNames.push_back(name != nullptr ? *name : "");
    bundle.materials.push_back(use);
  }
}

void warnOfUnusedTables(const Bundle& bundle, const std::string& pointer, FindingList& findings) {
  std::set<std::size_t> used;
  for (const Noise& noise : bundle.noises)
    for (const NoiseMap& map : noise.maps)
      visitTables(map, [&](std::size_t table) { used.insert(table); });
  for (std::size_t i = 0; i < bundle.tables.size(); ++i)
    if (!used.contains(i))
      findings.warn("table-unused", elementPointer(pointer, i), "no map uses this table");
}

/// Selects the tables to read. If a noise is ignored, only those that supported noises use, because
/// this version cannot check the tables of an ignored noise.
std::vector<bool> readableTables(const json* noises, std::size_t count) {
  std::vector<bool> readable(count, true);
  if (noises == nullptr || std::none_of(noises->begin(), noises->end(), isUnknown))
    return readable;
  readable.assign(count, false);
  for (const json& noise : *noises) {
    const json* maps = memberOf(&noise, "maps");
    const std::string* method = stringMember(noise, "method");
    if (isUnknown(noise) || maps == nullptr || !maps->is_array() || method == nullptr)
      continue;
    const MethodReader& ofMethod = readerOf(*methodFrom(*method));
    for (const json& map : *maps)
      for (const std::string_view key : ofMethod.tableMembers)
        if (const json* table = memberOf(&map, key);
            table != nullptr && table->is_number_unsigned() && table->get<std::uint64_t>() < count)
          readable[table->get<std::size_t>()] = true;
  }
  return readable;
}

/// Moves the tables into the bundle and renumbers the maps' indices.
void keepTables(Tables tables, Bundle& bundle) {
  std::vector<std::size_t> places;
  for (std::optional<Table>& table : tables) {
    places.push_back(bundle.tables.size());
    if (table)
      bundle.tables.push_back(std::move(*table));
  }
  for (Noise& noise : bundle.noises)
    for (NoiseMap& map : noise.maps)
      visitTables(map, [&](std::size_t& table) { table = places[table]; });
}

/// Reads the root object. Tables come first, because maps are checked against them.
NoisePlaces readRoot(GltfTables& source, const json& extension, Bundle& bundle,
                     FindingList& findings) {
  ObjectReader reader(extension, extensionPointer(""), findings);
  const json* tableList = reader.array("tables", kMaxTables);
  const json* noiseList = reader.array("noises", kMaxNoises);
  reader.warnOfUnknown();
  Tables tables(tableList != nullptr ? tableList->size() : 0);
  const std::vector<bool> readable = readableTables(noiseList, tables.size());
  for (std::size_t i = 0; i < tables.size(); ++i)
    if (readable[i])
      tables[i] = source.read(
          ObjectReader((*tableList)[i], elementPointer(reader.pointerTo("tables"), i), findings),
          findings);
  NoisePlaces places;
  if (noiseList != nullptr)
    places = readNoises(*noiseList, reader.pointerTo("noises"), tables, bundle, findings);
  if (findings.errorCount() == 0) {
    keepTables(std::move(tables), bundle);
    if (bundle.ignoredNoises.empty())
      warnOfUnusedTables(bundle, reader.pointerTo("tables"), findings);
    if (noiseList != nullptr)
      readAllLayers(*noiseList, reader.pointerTo("noises"), places, bundle, findings);
  }
  return places;
}

} // namespace

Bundle readExtension(const json& root, GltfTables& source, FindingList& findings) {
  Bundle bundle;
  const json* extension = extensionOf(root);
  NoisePlaces places;
  if (extension != nullptr)
    places = readRoot(source, *extension, bundle, findings);
  readMaterials(root, places, bundle, findings);
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
    findings.warn("extension-absent", "",
                  "the file has no noise: it does not use " + std::string(kExtensionName));
  return bundle;
}

} // namespace lichen
