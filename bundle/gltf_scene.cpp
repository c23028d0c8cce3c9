// SPDX-License-Identifier: MIT
// Reads what noises need from an asset, and adds vertices and noises; see gltf_scene.h.
#include "extension_reader.h"
#include "extension_writer.h"
#include "gltf_scene_state.h"

#include <lichen/bundle_merge.h>
#include <lichen/files.h>

#include <algorithm>
#include <utility>

namespace lichen {
namespace {

using nlohmann::json;

/// Records violations of glTF in a document's structure. Later code relies on these checks.
class SkeletonCheck {
public:
  SkeletonCheck(const json& root, FindingList& findings) : root_(root), findings_(findings) {}

  void run() {
    for (const char* array :
         {"accessors", "bufferViews", "buffers", "images", "samplers", "textures"})
      objects(root_, array, "");
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

  /// Checks the textures that the noise replaces, and the factors that multiply them.
  void material(const json& value, const std::string& pointer) {
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
      texture(value, key, pointer);
    const auto core = value.find("pbrMetallicRoughness");
    if (core == value.end())
      return;
    const std::string place = pointer + "/pbrMetallicRoughness";
    if (!core->is_object())
      findings_.error("type", place, "not an object");
    else
      for (const char* key : {"baseColorTexture", "metallicRoughnessTexture"})
        texture(*core, key, place);
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

/// The first error with its message for the user, or nothing.
std::optional<Error> firstError(const FindingList& findings, const std::filesystem::path& path) {
  for (const Finding& finding : findings.all())
    if (finding.severity == Finding::Severity::error)
      return Error{finding.code == "memory" ? ErrorKind::resources : ErrorKind::badInput,
                   path.string() + ": " + finding.pointer + (finding.pointer.empty() ? "" : ": ") +
                       finding.message};
  return std::nullopt;
}

/// The element's name; empty if it has none.
std::string nameOf(const json& element) {
  const auto name = element.find("name");
  return name != element.end() && name->is_string() ? name->get<std::string>() : std::string();
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

/// The accessor of a new view of floats.
JsonTree describeVertices(std::size_t view, std::size_t count, std::size_t components) {
  constexpr int kFloat = 5126;
  return {{"bufferView", view},
          {"componentType", kFloat},
          {"count", count},
          {"type", "VEC" + std::to_string(components)}};
}

} // namespace

std::size_t GltfScene::State::countOf(const char* array) const {
  const auto list = document().find(array);
  return list == document().end() ? 0 : list->size();
}

const json& GltfScene::State::primitive(PrimitivePlace place) const {
  return document()["meshes"][place.mesh]["primitives"][place.primitive];
}

std::size_t GltfScene::State::addView(std::span<const std::byte> view, std::size_t alignment,
                                      bool isVertices) {
  added.resize((added.size() + alignment - 1) / alignment * alignment);
  addedViews.push_back({added.size(), view.size(), isVertices});
  added.insert(added.end(), view.begin(), view.end());
  return countOf("bufferViews") + addedViews.size() - 1;
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
    state->file = GltfFile::open(state->bytes, folderOf(path), findings);
    if (state->file)
      SkeletonCheck(state->document(), findings).run();
    if (findings.errorCount() == 0)
      state->bundle = readExtension(*state->file, findings);
    if (std::optional<Error> error = firstError(findings, path))
      return std::move(*error);
    const auto used = state->document().find("extensionsUsed");
    state->listsExtension = used != state->document().end() && used->is_array() &&
                            std::find(used->begin(), used->end(), kExtensionName) != used->end();
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
    if (noise.contains("name") && noise["name"].is_string())
      noiseNames.insert(noise["name"].get<std::string>());
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
  const auto set = state_->setAttributes.find({place.mesh, place.primitive, name});
  if (set != state_->setAttributes.end())
    return set->second;
  const json& attributes = state_->primitive(place)["attributes"];
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::nullopt : std::optional(found->get<std::size_t>());
}

std::size_t GltfScene::addVertices(std::span<const std::array<float, 3>> values) {
  const std::size_t view = state_->addView(std::as_bytes(values), sizeof(float), true);
  state_->changes.member("accessors").append(describeVertices(view, values.size(), 3));
  return state_->countOf("accessors") + state_->addedAccessors++;
}

std::size_t GltfScene::addVertices(std::span<const std::array<float, 4>> values) {
  const std::size_t view = state_->addView(std::as_bytes(values), sizeof(float), true);
  state_->changes.member("accessors").append(describeVertices(view, values.size(), 4));
  return state_->countOf("accessors") + state_->addedAccessors++;
}

void GltfScene::setAttribute(PrimitivePlace place, const std::string& name, std::size_t accessor) {
  state_->setAttributes[{place.mesh, place.primitive, name}] = accessor;
  state_->changes.member("meshes")
      .element(place.mesh)
      .member("primitives")
      .element(place.primitive)
      .member("attributes")
      .member(name)
      .set(accessor);
}

void GltfScene::setFactor(std::size_t material, std::string_view parent, std::string_view key,
                          const std::vector<double>& value) {
  JsonChange& whole = state_->changes.member("materials").element(material);
  JsonChange& change = (parent.empty() ? whole : whole.member(parent)).member(key);
  if (value.size() == 1)
    change.set(value.front());
  else
    change.set(value);
}

std::size_t GltfScene::addTexture(std::span<const std::byte> file, std::string_view mediaType) {
  const std::size_t view = state_->addView(file, sizeof(std::uint32_t), false);
  const std::size_t image = state_->countOf("images") + state_->addedTextures;
  const std::size_t sampler = state_->countOf("samplers") + state_->addedTextures;
  constexpr int kClampToEdge = 33071;
  state_->changes.member("images").append({{"mimeType", mediaType}, {"bufferView", view}});
  state_->changes.member("samplers").append({{"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}});
  state_->changes.member("textures").append({{"sampler", sampler}, {"source", image}});
  ++state_->addedTextures;
  return textureCount() - 1;
}

std::size_t GltfScene::textureCount() const {
  return state_->countOf("textures") + state_->addedTextures;
}

Result<AppliedNoise> GltfScene::applyNoise(const Bundle& bundle, std::size_t noise,
                                           const MaterialNoise& use,
                                           std::span<const std::size_t> materials) {
  const auto apply = [&]() -> Result<AppliedNoise> {
    Bundle& own = state_->bundle;
    const std::size_t tablesBefore = own.tables.size(), noisesBefore = own.noises.size();
    const std::size_t place = placeNoise(own, bundle, noise, state_->noiseNames);
    JsonChange& root = state_->changes.member("extensions").member(kExtensionName);
    for (std::size_t t = tablesBefore; t < own.tables.size(); ++t)
      root.member("tables").append(describeTable(
          own.tables[t], state_->addView(encodeKtx2(own.tables[t]), kTableAlignment, false)));
    if (own.noises.size() > noisesBefore) {
      Noise added = own.noises[place];
      for (NoiseMap& map : added.maps)
        visitTables(map, [&](std::size_t& table) { table += state_->ignoredTables; });
      root.member("noises").append(describeNoise(added));
      state_->noiseNames.insert(added.name);
    }
    if (!std::exchange(state_->listsExtension, true))
      state_->changes.member("extensionsUsed").append(kExtensionName);
    MaterialNoise described = use;
    described.noise = state_->ignoredNoises + place;
    for (const std::size_t material : materials)
      state_->changes.member("materials")
          .element(material)
          .member("extensions")
          .member(kExtensionName)
          .set(describeMaterialNoise(described));
    return AppliedNoise{own.noises[place].name, own.noises.size() > noisesBefore,
                        own.tables.size() - tablesBefore};
  };
  return withinMemory([&] { return state_->path.string() + ": not enough memory to add a noise"; },
                      apply);
}

} // namespace lichen
