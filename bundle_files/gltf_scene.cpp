// SPDX-License-Identifier: MIT
// Reads what noises need from an asset, and adds vertices and noises; see gltf_scene.h.
#include "extension_reader.h"
#include "extension_writer.h"
#include "gltf_scene_state.h"
#include "json_builder.h"

#include <lichen/bundle_merge.h>
#include <lichen/bundle_writer.h>
#include <lichen/files.h>
#include <lichen/gltf_files.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace lichen {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

/// Records violations of glTF in a document's structure. Later code relies on these checks.
class SkeletonCheck {
public:
  SkeletonCheck(const json& root, FindingList& findings) : root_(root), findings_(findings) {}

  void run() {
    for (const char* array :
         {"accessors", "bufferViews", "buffers", "images", "samplers", "textures"})
      objects(root_, array, "");
    member(root_, "extensions", json::value_t::object, "");
    member(root_, "extensionsUsed", json::value_t::array, "");
    const json* materials = objects(root_, "materials", "");
    for (std::size_t m = 0; materials != nullptr && m < materials->size(); ++m)
      material((*materials)[m], "/materials/" + std::to_string(m));
    const json* meshes = objects(root_, "meshes", "");
    for (std::size_t m = 0; meshes != nullptr && m < meshes->size(); ++m) {
      const std::string mesh = "/meshes/" + std::to_string(m);
      const json* primitives = objects((*meshes)[m], "primitives", mesh);
      for (std::size_t p = 0; primitives != nullptr && p < primitives->size(); ++p)
        primitive((*primitives)[p], mesh + "/primitives/" + std::to_string(p));
    }
  }

private:
  /// An optional array of objects; null if absent or invalid.
  const json* objects(const json& parent, const char* key, const std::string& pointer) {
    const auto list = parent.find(key);
    if (list == parent.end())
      return nullptr;
    if (list->is_array() &&
        std::all_of(list->begin(), list->end(), [](const json& each) { return each.is_object(); }))
      return &*list;
    findings_.error("type", pointer + "/" + key, "not an array of objects");
    return nullptr;
  }

  /// An optional member of one type; null if absent or invalid.
  const json* member(const json& parent, const char* key, json::value_t type,
                     const std::string& pointer) {
    const json* value = memberOf(&parent, key);
    if (value == nullptr || value->type() == type)
      return value;
    findings_.error("type", pointer + "/" + key, "not an " + std::string(json(type).type_name()));
    return nullptr;
  }

  /// Checks the textures that the noise replaces, and the factors that multiply them.
  void material(const json& value, const std::string& pointer) {
    member(value, "extensions", json::value_t::object, pointer);
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
      texture(value, key, pointer);
    const json* core = member(value, "pbrMetallicRoughness", json::value_t::object, pointer);
    for (const char* key : {"baseColorTexture", "metallicRoughnessTexture"})
      if (core != nullptr)
        texture(*core, key, pointer + "/pbrMetallicRoughness");
  }

  void texture(const json& parent, const char* key, const std::string& pointer) {
    const auto value = parent.find(key);
    if (value == parent.end())
      return;
    const std::string place = pointer + "/" + key;
    if (!value->is_object() || !value->contains("index") || !(*value)["index"].is_number_unsigned())
      findings_.error("type", place, "not an object with an index of a texture");
    else if (const auto extensions = value->find("extensions"); extensions != value->end())
      if (!extensions->is_object() ||
          !std::all_of(extensions->begin(), extensions->end(),
                       [](const json& each) { return each.is_object(); }))
        findings_.error("type", place + "/extensions", "not an object of objects");
  }

  void primitive(const json& value, const std::string& pointer) {
    const auto attributes = value.find("attributes");
    if (attributes == value.end() || !attributes->is_object()) {
      findings_.error("type", pointer + "/attributes", "absent or not an object");
      return;
    }
    for (const auto& [name, accessor] : attributes->items())
      index(accessor, "accessors", pointer + "/attributes/" + name);
    if (const auto indices = value.find("indices"); indices != value.end())
      index(*indices, "accessors", pointer + "/indices");
    if (const auto material = value.find("material"); material != value.end())
      index(*material, "materials", pointer + "/material");
    if (const auto mode = value.find("mode"); mode != value.end() && !mode->is_number_unsigned())
      findings_.error("type", pointer + "/mode", "not a whole number");
  }

  void index(const json& value, const char* array, const std::string& pointer) {
    const auto list = root_.find(array);
    const std::size_t count = list != root_.end() && list->is_array() ? list->size() : 0;
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count)
      findings_.error("index", pointer,
                      value.dump(-1, ' ', true, json::error_handler_t::replace).substr(0, 20) +
                          "; expected an index below " + std::to_string(count));
  }

  const json& root_;
  FindingList& findings_;
};

/// The element's name; empty if it has none.
std::string nameOf(const json& element) {
  const std::string* name = stringMember(element, "name");
  return name != nullptr ? *name : "";
}

NameCounts countNames(const json& document, const char* array) {
  NameCounts counts;
  if (const auto elements = document.find(array); elements != document.end())
    for (const json& element : *elements)
      ++counts[nameOf(element)];
  return counts;
}

/// Names an element by name or index, or by both if another has the same name.
std::string titleOf(const char* kind, const json& elements, std::size_t index,
                    const NameCounts& names) {
  const std::string name = nameOf(elements[index]);
  std::string title = kind;
  if (name.empty() || names.at(name) > 1)
    title += " " + std::to_string(index);
  return name.empty() ? title : title + " '" + name + "'";
}

/// A member of a material, or of its object `parent` if that is not empty; created if absent.
Json& editedMember(Json& material, std::string_view parent, std::string_view key) {
  Json& object = parent.empty() ? material : material[std::string(parent)];
  return object[std::string(key)];
}

/// Whether any object of a document has the extension.
bool hasExtension(const Json& value, const std::string& extension) {
  if (!value.is_structured())
    return false;
  if (value.is_object())
    if (const auto own = value.find("extensions");
        own != value.end() && own->is_object() && own->contains(extension))
      return true;
  return std::any_of(value.begin(), value.end(),
                     [&](const Json& each) { return hasExtension(each, extension); });
}

} // namespace

std::size_t GltfScene::State::countOf(const char* array) const {
  const auto list = document().find(array);
  return list == document().end() ? 0 : list->size();
}

const json& GltfScene::State::primitive(PrimitivePlace place) const {
  return document()["meshes"][place.mesh]["primitives"][place.primitive];
}

GltfScene::GltfScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
GltfScene::GltfScene(GltfScene&&) noexcept = default;
GltfScene& GltfScene::operator=(GltfScene&&) noexcept = default;
GltfScene::~GltfScene() = default;

Result<GltfScene> GltfScene::open(const std::filesystem::path& path) {
  const auto read = [&]() -> Result<GltfScene> {
    auto state = std::make_unique<State>();
    state->path = path;
    Result<std::vector<std::byte>> bytes = readFile(path);
    if (!bytes)
      return bytes.error();
    state->bytes = std::move(bytes).value();
    FindingList findings;
    state->file = GltfFile::open(state->bytes, filesBeside(path), findings);
    if (state->file) {
      SkeletonCheck(state->document(), findings).run();
      constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
      if (const auto fault =
              buildJson(state->file->container().text, kNoLimit, kNoLimit, state->edited))
        findings.error("json-name", "",
                       "JSON object with two members " + quoted(fault->name) + "; expected one");
    }
    if (findings.errorCount() == 0) {
      GltfTables tables(*state->file);
      state->bundle = readExtension(state->document(), tables, findings);
    }
    if (const Finding* fault = findings.firstError())
      return asError(*fault, path.string());
    state->added.firstView = state->countOf("bufferViews");
    state->added.firstAccessor = state->countOf("accessors");
    state->readNoises();
    state->sortPrimitives();
    state->materialNames = countNames(state->document(), "materials");
    state->meshNames = countNames(state->document(), "meshes");
    return GltfScene(std::move(state));
  };
  return withinMemory([&] { return path.string() + ": not enough memory to read it"; }, read);
}

/// Collects the names of the noises. If the file has ignored noises, shares nothing with existing
/// noises and tables, because the content of the ignored ones is unknown; additions go behind all
/// of them.
void GltfScene::State::readNoises() {
  const json::json_pointer place("/extensions/" + std::string(kExtensionName));
  if (!document().contains(place))
    return;
  const json& extension = document()[place];
  for (const json& noise : extension["noises"])
    noiseNames.insert(nameOf(noise));
  if (bundle.ignoredNoises.empty())
    return;
  ignoredTables = extension["tables"].size();
  ignoredNoises = extension["noises"].size();
  bundle.tables.clear();
  bundle.noises.clear();
}

void GltfScene::State::sortPrimitives() {
  primitivesOf.resize(countOf("materials"));
  for (std::size_t m = 0; m < countOf("meshes"); ++m) {
    const json& mesh = document()["meshes"][m];
    for (std::size_t p = 0; mesh.contains("primitives") && p < mesh["primitives"].size(); ++p)
      if (const json& primitive = mesh["primitives"][p]; primitive.contains("material"))
        primitivesOf[primitive["material"].get<std::size_t>()].push_back({m, p});
  }
}

const std::filesystem::path& GltfScene::path() const { return state_->path; }
const json& GltfScene::document() const { return state_->document(); }
std::size_t GltfScene::materialCount() const { return state_->countOf("materials"); }

std::string GltfScene::materialTitle(std::size_t material) const {
  return titleOf("material", document()["materials"], material, state_->materialNames);
}

std::string GltfScene::meshTitle(std::size_t mesh) const {
  return titleOf("mesh", document()["meshes"], mesh, state_->meshNames);
}

std::string GltfScene::primitiveTitle(PrimitivePlace place) const {
  return "primitive " + std::to_string(place.primitive) + " of " + meshTitle(place.mesh);
}

const std::vector<PrimitivePlace>& GltfScene::primitivesOf(std::size_t material) const {
  return state_->primitivesOf[material];
}

std::optional<std::size_t> GltfScene::attribute(PrimitivePlace place,
                                                const std::string& name) const {
  const Json& attributes = state_->attributes(place);
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::nullopt : std::optional(found->get<std::size_t>());
}

std::size_t GltfScene::addVertices(std::span<const std::array<float, 3>> values) {
  return state_->added.addVertices(values);
}

std::size_t GltfScene::addVertices(std::span<const std::array<float, 4>> values) {
  return state_->added.addVertices(values);
}

void GltfScene::setAttribute(PrimitivePlace place, const std::string& name, std::size_t accessor) {
  state_->attributes(place)[name] = accessor;
}

void GltfScene::setFactor(std::size_t material, std::string_view parent, std::string_view key,
                          const std::vector<double>& value) {
  editedMember(state_->edited["materials"][material], parent, key) =
      value.size() == 1 ? Json(value.front()) : Json(value);
}

void GltfScene::removeExtension(std::span<const std::size_t> materials,
                                const std::string& extension) {
  for (const std::size_t m : materials) {
    Json& material = state_->edited["materials"][m];
    const auto extensions = material.find("extensions");
    if (extensions == material.end() || extensions->erase(extension) == 0 || !extensions->empty())
      continue;
    material.erase("extensions");
  }
  if (hasExtension(state_->edited, extension))
    return;
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    const auto list = state_->edited.find(key);
    if (list == state_->edited.end() || !list->is_array())
      continue;
    list->erase(std::remove(list->begin(), list->end(), extension), list->end());
    if (list->empty()) // glTF allows no empty list
      state_->edited.erase(key);
  }
}

std::size_t GltfScene::addTexture(std::span<const std::byte> file, std::string_view mediaType) {
  constexpr int kClampToEdge = 33071;
  Json& root = state_->edited;
  root["images"].push_back({{"mimeType", mediaType},
                            {"bufferView", state_->added.addView(file, sizeof(std::uint32_t))}});
  root["samplers"].push_back({{"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}});
  root["textures"].push_back(
      {{"sampler", root["samplers"].size() - 1}, {"source", root["images"].size() - 1}});
  return root["textures"].size() - 1;
}

std::size_t GltfScene::textureCount() const {
  const auto textures = state_->edited.find("textures");
  return textures == state_->edited.end() ? 0 : textures->size();
}

Result<AppliedNoise> GltfScene::applyNoise(const Bundle& bundle, std::size_t noise,
                                           const MaterialNoise& use,
                                           std::span<const std::size_t> materials) {
  const auto apply = [&]() -> Result<AppliedNoise> {
    Bundle& own = state_->bundle;
    const std::size_t tablesBefore = own.tables.size(), noisesBefore = own.noises.size();
    const std::size_t place = placeNoise(own, bundle, noise, state_->noiseNames);
    const std::string extension(kExtensionName);
    Json& root = state_->edited["extensions"][extension];
    for (std::size_t t = tablesBefore; t < own.tables.size(); ++t)
      root["tables"].push_back(describeTable(
          own.tables[t], state_->added.addView(encodeKtx2(own.tables[t]), kTableAlignment)));
    for (std::size_t n = noisesBefore; n < own.noises.size(); ++n) {
      Noise added = own.noises[n];
      for (NoiseMap& map : added.maps)
        visitTables(map, [&](std::size_t& table) { table += state_->ignoredTables; });
      visitLayerNoises(added, [&](std::size_t& other) { other += state_->ignoredNoises; });
      root["noises"].push_back(describeNoise(added, state_->ignoredNoises + n));
      state_->noiseNames.insert(added.name);
    }
    Json& used = state_->edited["extensionsUsed"];
    if (std::find(used.begin(), used.end(), kExtensionName) == used.end())
      used.push_back(kExtensionName);
    MaterialNoise described = use;
    described.noise = state_->ignoredNoises + place;
    for (const std::size_t material : materials)
      state_->edited["materials"][material]["extensions"][extension] =
          describeMaterialNoise(described);
    return AppliedNoise{own.noises[place].name, own.noises.size() > noisesBefore,
                        own.tables.size() - tablesBefore};
  };
  return withinMemory([&] { return state_->path.string() + ": not enough memory to add a noise"; },
                      apply);
}

} // namespace lichen
