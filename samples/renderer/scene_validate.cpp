// SPDX-License-Identifier: MIT
// Checks of glTF 2.0 rules, in order of dependency [glTF 2.0, sections 3.5 to 3.11 and 5].
#include "scene_validate.h"

#include "json_place.h"
#include "printable.h"
#include "scene.h"

#include <lichen/bundle.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <set>

namespace lichen::renderer {
namespace {

constexpr double kLargest = std::numeric_limits<float>::max();
constexpr std::uint64_t kMaxBytes = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kFloatComponent = 5126;
constexpr std::array<const char*, 5> kSupportedExtensions{
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_mesh_quantization",
    "KHR_texture_transform", kExtensionName.data()};

bool isSupported(const std::string& extension) {
  return std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), extension) !=
         kSupportedExtensions.end();
}

struct Accessor {
  std::uint64_t componentType = 0;
  std::string type;
  std::uint64_t count = 0;
  bool normalized = false;
};

class Validator {
public:
  Validator(const GltfFile& file, std::vector<std::string>& notes)
      : file_(file), root_(file.container.document, ""), notes_(notes) {}

  void run() {
    asset();
    extensions();
    root_.each("buffers", [&](const Place& p, std::size_t i) { buffer(p, i); });
    root_.each("bufferViews", [&](const Place& p, std::size_t) { bufferView(p); });
    root_.each("accessors", [&](const Place& p, std::size_t) { accessor(p); });
    root_.each("images", [&](const Place& p, std::size_t) { image(p); });
    root_.each("samplers", [&](const Place& p, std::size_t) { sampler(p); });
    root_.each("textures", [&](const Place& p, std::size_t) { texture(p); });
    root_.each("materials", [&](const Place& p, std::size_t) { material(p); });
    root_.each("meshes", [&](const Place& p, std::size_t) { mesh(p); });
    root_.each("cameras", [&](const Place& p, std::size_t i) { camera(p, i); });
    root_.extension("KHR_lights_punctual").each("lights", [&](const Place& p, std::size_t) {
      light(p);
    });
    root_.each("nodes", [&](const Place& p, std::size_t i) { node(p, i); });
    noCycles();
    root_.each("skins", [&](const Place& p, std::size_t) { skin(p); });
    root_.each("scenes", [&](const Place& p, std::size_t) { scene(p); });
    // tinygltf loads them, the renderer ignores them
    root_.each("animations", [](const Place&, std::size_t) {});
    if (root_.find("animations"))
      notes_.push_back("animations are ignored; the scene is rendered in its rest pose");
    (void)root_.index("scene", root_.countOf("scenes"));
  }

private:
  void asset() const {
    const Place place = root_.member("asset");
    const std::string version = place.member("version").json().is_string()
                                    ? *place.string("version")
                                    : std::string("not a string");
    if (!version.starts_with("2."))
      place.fail("version " + printable(version) + " is not supported; expected 2.0");
    if (const auto minimum = place.string("minVersion"); minimum && *minimum != "2.0")
      place.fail("minVersion " + printable(*minimum) + " is not supported; expected 2.0");
  }

  void extensions() {
    root_.each("extensionsRequired", [&](const Place& place, std::size_t) {
      if (!place.json().is_string())
        place.fail("expected a string");
      if (const auto name = place.json().get<std::string>(); !isSupported(name)) {
        std::string list;
        for (const char* supported : kSupportedExtensions)
          list += std::string(list.empty() ? "" : ", ") + supported;
        place.fail("the required extension " + printable(name) +
                   " is not supported; export without it (supported: " + list + ")");
      }
    });
    root_.each("extensionsUsed", [&](const Place& place, std::size_t) {
      if (!place.json().is_string())
        place.fail("expected a string");
      if (const auto name = place.json().get<std::string>(); !isSupported(name))
        notes_.push_back("the extension " + printable(name) + " is ignored");
    });
  }

  void buffer(const Place& place, std::size_t index) {
    const std::uint64_t length = place.integer("byteLength", 1, kMaxBytes);
    const std::optional<std::string> uri = place.string("uri");
    const auto& chunk = file_.container.binaryChunk;
    if (!uri && (!chunk || index != 0))
      place.fail("has no uri; only the first buffer of a .glb with a BIN chunk needs none");
    if (!uri && length > chunk->size())
      place.fail("byteLength " + std::to_string(length) + " exceeds the " +
                 std::to_string(chunk->size()) + " bytes of the BIN chunk");
    bufferLengths_.push_back(length);
    bufferBytes_ += length;
    if (bufferBytes_ > kMaxBufferBytes)
      throw Fault{"/buffers: more than " + std::to_string(kMaxBufferBytes) +
                      " bytes in total; use a smaller scene",
                  ErrorKind::resources};
  }

  void bufferView(const Place& place) {
    (void)place.member("buffer");
    const std::size_t buffer = *place.index("buffer", bufferLengths_.size());
    const std::uint64_t offset = place.integer("byteOffset", 0, kMaxBytes, 0);
    const std::uint64_t length = place.integer("byteLength", 1, kMaxBytes);
    if (offset + length > bufferLengths_[buffer])
      place.fail("bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) +
                 " exceed their buffer of " + std::to_string(bufferLengths_[buffer]) + " bytes");
    const std::uint64_t stride = place.integer("byteStride", 4, 252, 0);
    if (stride % 4 != 0)
      place.fail("byteStride " + std::to_string(stride) +
                 " is invalid; expected a multiple of 4 from 4 to 252");
    views_.push_back({length, stride});
  }

  /// Fails unless `count` elements of `size` bytes from `offset` fit into the view.
  void fits(const Place& place, std::size_t view, std::uint64_t offset, std::uint64_t count,
            std::uint64_t size, bool mayStride) const {
    const auto [length, stride] = views_[view];
    const std::uint64_t step = mayStride && stride != 0 ? stride : size;
    if (step < size || offset > length || length - offset < size ||
        (length - offset - size) / step < count - 1)
      place.fail(std::to_string(count) + " elements of " + std::to_string(size) +
                 " bytes from offset " + std::to_string(offset) + " exceed their bufferView of " +
                 std::to_string(length) + " bytes");
  }

  void accessor(const Place& place) {
    Accessor result;
    (void)place.member("componentType");
    result.componentType =
        *place.oneOf("componentType", {5120, 5121, 5122, 5123, 5125, kFloatComponent});
    (void)place.member("type");
    result.type = *place.string("type");
    const std::size_t components = componentCount(result.type);
    if (components == 0)
      place.fail("type " + printable(result.type) +
                 " is invalid; expected SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
    result.count = place.integer("count", 1, kMaxBytes);
    place.boolean("normalized");
    const std::optional<Place> normalized = place.find("normalized");
    result.normalized = normalized && normalized->json().get<bool>();
    // Matrices of 8- and 16-bit components have padded columns, but the loader reads only float
    // matrices.
    const std::uint64_t size = components * componentBytes(result.componentType);
    const std::uint64_t offset = place.integer("byteOffset", 0, kMaxBytes, 0);
    if (const auto view = place.index("bufferView", views_.size()))
      fits(place, *view, offset, result.count, size, true);
    else if (result.count > kMaxImplicitCount)
      place.fail("count " + std::to_string(result.count) +
                 " without a bufferView is too large; the limit is " +
                 std::to_string(kMaxImplicitCount));
    if (const auto patch = place.find("sparse"))
      sparse(*patch, result, size);
    accessors_.push_back(result);
  }

  void sparse(const Place& place, const Accessor& accessor, std::uint64_t size) const {
    const std::uint64_t count = place.integer("count", 1, accessor.count);
    const Place indices = place.member("indices");
    (void)indices.member("bufferView");
    (void)indices.member("componentType");
    const std::uint64_t type = *indices.oneOf("componentType", {5121, 5123, 5125});
    fits(indices, *indices.index("bufferView", views_.size()),
         indices.integer("byteOffset", 0, kMaxBytes, 0), count, componentBytes(type), false);
    const Place values = place.member("values");
    (void)values.member("bufferView");
    fits(values, *values.index("bufferView", views_.size()),
         values.integer("byteOffset", 0, kMaxBytes, 0), count, size, false);
  }

  void image(const Place& place) const {
    const auto view = place.index("bufferView", views_.size());
    const auto uri = place.string("uri");
    if (view.has_value() == uri.has_value())
      place.fail("expected exactly one of uri and bufferView");
    (void)place.string("mimeType");
  }

  static void sampler(const Place& place) {
    place.oneOf("magFilter", {9728, 9729});
    place.oneOf("minFilter", {9728, 9729, 9984, 9985, 9986, 9987});
    place.oneOf("wrapS", {10497, 33071, 33648});
    place.oneOf("wrapT", {10497, 33071, 33648});
  }

  void texture(const Place& place) const {
    (void)place.index("sampler", root_.countOf("samplers"));
    (void)place.index("source", root_.countOf("images"));
  }

  void textureInfo(const Place& parent, const char* key) const {
    const auto place = parent.find(key);
    if (!place)
      return;
    (void)place->member("index");
    (void)place->index("index", root_.countOf("textures"));
    (void)place->integer("texCoord", 0, 1, 0);
    place->number("scale", -kLargest, kLargest, 1);
    place->number("strength", 0, 1, 1);
    textureTransform(*place);
  }

  static void textureTransform(const Place& info) {
    const Place transform = info.extension("KHR_texture_transform");
    transform.numbers("offset", 2, -kLargest, kLargest);
    transform.numbers("scale", 2, -kLargest, kLargest);
    transform.number("rotation", -kLargest, kLargest, 0);
    (void)transform.integer("texCoord", 0, 1, 0);
  }

  void material(const Place& place) const {
    (void)place.string("name");
    if (const auto pbr = place.find("pbrMetallicRoughness")) {
      pbr->numbers("baseColorFactor", 4, 0, 1);
      pbr->number("metallicFactor", 0, 1, 1);
      pbr->number("roughnessFactor", 0, 1, 1);
      textureInfo(*pbr, "baseColorTexture");
      textureInfo(*pbr, "metallicRoughnessTexture");
    }
    textureInfo(place, "normalTexture");
    textureInfo(place, "occlusionTexture");
    textureInfo(place, "emissiveTexture");
    // The noise plugin checks the rest of a mix, if it knows the noise's revision.
    const auto mix = place.extension(kExtensionName.data()).find("mix");
    const auto mask = mix && mix->json().is_object() ? mix->find("texture") : std::nullopt;
    if (mask && mask->json().is_object())
      textureTransform(*mask);
    place.numbers("emissiveFactor", 3, 0, 1);
    place.extension("KHR_materials_emissive_strength").number("emissiveStrength", 0, kLargest, 1);
    if (const auto mode = place.string("alphaMode");
        mode && *mode != "OPAQUE" && *mode != "MASK" && *mode != "BLEND")
      place.fail("alphaMode " + printable(*mode) + " is invalid; expected OPAQUE, MASK or BLEND");
    place.number("alphaCutoff", 0, kLargest, 0.5);
    place.boolean("doubleSided");
  }

  void attribute(const Place& place, const std::string& name, std::uint64_t vertices) const {
    const Accessor& accessor = accessors_[place.asIndex(accessors_.size())];
    if (accessor.count != vertices)
      place.fail("has " + std::to_string(accessor.count) + " elements, but POSITION has " +
                 std::to_string(vertices));
    const bool isFloat = accessor.componentType == kFloatComponent;
    const auto require = [&](bool typeFits, const char* accepted) {
      if (!typeFits)
        place.fail(accessor.type + " of componentType " + std::to_string(accessor.componentType) +
                   " is invalid for " + name + "; expected " + accepted);
    };
    const bool notUint32 = accessor.componentType != 5125;
    if (name == "POSITION" || name == "NORMAL")
      require(accessor.type == "VEC3" && notUint32, "VEC3 of float, byte or short");
    else if (name == "TANGENT")
      require(accessor.type == "VEC4" && notUint32, "VEC4 of float, byte or short");
    else if (name == "TEXCOORD_0" || name == "TEXCOORD_1")
      require(accessor.type == "VEC2" && notUint32, "VEC2 of float, byte or short");
    else if (name.starts_with("COLOR_"))
      require((accessor.type == "VEC3" || accessor.type == "VEC4") &&
                  (isFloat || accessor.componentType == 5121 || accessor.componentType == 5123),
              "VEC3 or VEC4 of float, unsigned byte or unsigned short");
    else if (name.starts_with("JOINTS_"))
      require(accessor.type == "VEC4" &&
                  (accessor.componentType == 5121 || accessor.componentType == 5123),
              "VEC4 of unsigned byte or unsigned short");
    else if (name.starts_with("WEIGHTS_"))
      require(accessor.type == "VEC4" && notUint32, "VEC4 of float, byte or short");
  }

  /// Deltas of morph targets have three components, even deltas of TANGENT.
  void morphTarget(const Place& place, std::uint64_t vertices) const {
    for (const auto& [name, value] : place.json().items()) {
      const Place entry = place.member(name.c_str());
      (void)entry.asIndex(accessors_.size());
      if (vertices != 0)
        attribute(entry, name == "TANGENT" ? "NORMAL" : name, vertices);
    }
  }

  void mesh(const Place& place) {
    (void)place.member("primitives");
    place.each("primitives", [&](const Place& primitive, std::size_t) {
      const Place attributes = primitive.member("attributes");
      std::uint64_t vertices = 0;
      if (const auto position = attributes.index("POSITION", accessors_.size()))
        vertices = accessors_[*position].count;
      for (const auto& [name, value] : attributes.json().items()) {
        const Place entry = attributes.member(name.c_str());
        (void)entry.asIndex(accessors_.size());
        if (vertices != 0)
          attribute(entry, name, vertices);
      }
      primitive.each("targets",
                     [&](const Place& target, std::size_t) { morphTarget(target, vertices); });
      (void)primitive.index("material", root_.countOf("materials"));
      primitive.oneOf("mode", {0, 1, 2, 3, 4, 5, 6});
      if (const auto indices = primitive.index("indices", accessors_.size())) {
        const Accessor& accessor = accessors_[*indices];
        if (accessor.type != "SCALAR" ||
            (accessor.componentType != 5121 && accessor.componentType != 5123 &&
             accessor.componentType != 5125))
          primitive.fail("indices are " + accessor.type + " of componentType " +
                         std::to_string(accessor.componentType) +
                         "; expected SCALAR of 5121, 5123 or 5125");
      }
    });
    weights(place);
  }

  /// Default weights of morph targets.
  static void weights(const Place& place) {
    place.each("weights",
               [](const Place& weight, std::size_t) { weight.asNumber(-kLargest, kLargest); });
  }

  void camera(const Place& place, std::size_t index) {
    (void)place.member("type");
    const std::string type = *place.string("type");
    const bool perspective = type == "perspective";
    if (!perspective && type != "orthographic")
      place.fail("type " + printable(type) + " is invalid; expected perspective or orthographic");
    const Place lens = place.member(perspective ? "perspective" : "orthographic");
    // Only checks that these are numbers; camera_load.cpp checks their ranges when a node uses the
    // camera.
    for (const char* key : {"xmag", "ymag", "yfov", "znear", "zfar", "aspectRatio"})
      (void)lens.number(key, -kLargest, kLargest, 0);
    (void)lens.member("znear");
    (void)lens.member(perspective ? "yfov" : "zfar");
    if (!perspective) {
      (void)lens.member("xmag");
      (void)lens.member("ymag");
    }
    for (const char* key : {"zfar", "aspectRatio"}) // tinygltf stores an absent one as 0
      if (perspective && lens.find(key) && lens.number(key, -kLargest, kLargest, 1) == 0.0)
        notes_.push_back("/cameras/" + std::to_string(index) + "/perspective/" + key +
                         ": 0 is invalid and treated as absent; expected more than 0");
  }

  static void light(const Place& place) {
    (void)place.member("type");
    const std::string type = *place.string("type");
    if (type != "directional" && type != "point" && type != "spot")
      place.fail("type " + printable(type) + " is invalid; expected directional, point or spot");
    place.numbers("color", 3, 0, kLargest);
    place.number("intensity", 0, kLargest, 1);
    place.number("range", 0, kLargest, 0);
    if (const auto spot = place.find("spot")) {
      constexpr double kRightAngle = 1.5707964;
      const double outer = spot->number("outerConeAngle", 0, kRightAngle, kRightAngle / 2);
      spot->number("innerConeAngle", 0, outer, 0);
    }
  }

  void node(const Place& place, std::size_t index) {
    const std::size_t nodes = root_.countOf("nodes");
    parents_.resize(nodes, nodes);
    place.each("children", [&](const Place& child, std::size_t) {
      const std::size_t c = child.asIndex(nodes);
      if (parents_[c] != nodes)
        child.fail("node " + std::to_string(c) + " is already a child of node " +
                   std::to_string(parents_[c]) + "; a node may have only one parent");
      parents_[c] = index;
    });
    (void)place.index("mesh", root_.countOf("meshes"));
    (void)place.index("camera", root_.countOf("cameras"));
    (void)place.index("skin", root_.countOf("skins"));
    place.numbers("matrix", 16, -kLargest, kLargest);
    place.numbers("translation", 3, -kLargest, kLargest);
    place.numbers("rotation", 4, -1, 1);
    place.numbers("scale", 3, -kLargest, kLargest);
    (void)place.string("name");
    weights(place);
    (void)place.extension("KHR_lights_punctual")
        .index("light", root_.extension("KHR_lights_punctual").countOf("lights"));
  }

  /// Each node has at most one parent, so a cycle is a chain of parents without end.
  void noCycles() const {
    const std::size_t nodes = parents_.size();
    std::vector<bool> reachesRoot(nodes, false);
    for (std::size_t start = 0; start < nodes; ++start) {
      std::vector<std::size_t> chain;
      std::size_t at = start;
      while (at != nodes && !reachesRoot[at]) {
        if (chain.size() == nodes)
          root_.member("nodes").fail("node " + std::to_string(start) +
                                     " is its own ancestor; nodes must not form cycles");
        chain.push_back(at);
        at = parents_[at];
      }
      for (const std::size_t done : chain)
        reachesRoot[done] = true;
    }
  }

  void skin(const Place& place) const {
    (void)place.member("joints");
    place.each("joints",
               [&](const Place& joint, std::size_t) { (void)joint.asIndex(parents_.size()); });
    (void)place.index("skeleton", parents_.size());
    const std::size_t joints = place.countOf("joints");
    if (const auto matrices = place.index("inverseBindMatrices", accessors_.size())) {
      const Accessor& accessor = accessors_[*matrices];
      if (accessor.type != "MAT4" || accessor.componentType != kFloatComponent ||
          accessor.count < joints)
        place.fail("inverseBindMatrices are " + std::to_string(accessor.count) + " " +
                   accessor.type + " of componentType " + std::to_string(accessor.componentType) +
                   "; expected MAT4 of " + std::to_string(kFloatComponent) +
                   ", one for each of the " + std::to_string(joints) + " joints");
    }
  }

  void scene(const Place& place) const {
    std::set<std::size_t> listed;
    place.each("nodes", [&](const Place& entry, std::size_t) {
      const std::size_t node = entry.asIndex(parents_.size());
      if (parents_[node] != parents_.size())
        entry.fail("node " + std::to_string(node) + " is a child of node " +
                   std::to_string(parents_[node]) + "; scenes may list only root nodes");
      if (!listed.insert(node).second)
        entry.fail("node " + std::to_string(node) + " appears twice");
    });
  }

  struct View {
    std::uint64_t length;
    std::uint64_t stride;
  };

  const GltfFile& file_;
  Place root_;
  std::vector<std::string>& notes_;
  std::vector<std::uint64_t> bufferLengths_;
  std::uint64_t bufferBytes_ = 0; ///< their sum
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::vector<std::size_t> parents_; ///< parent of each node; the number of nodes for a root
};

} // namespace

std::size_t componentBytes(std::uint64_t componentType) {
  switch (componentType) {
  case 5120:
  case 5121:
    return 1;
  case 5122:
  case 5123:
    return 2;
  case 5125:
  case kFloatComponent:
    return 4;
  default:
    return 0;
  }
}

std::size_t componentCount(const std::string& type) {
  if (type == "SCALAR")
    return 1;
  if (type == "VEC2")
    return 2;
  if (type == "VEC3")
    return 3;
  if (type == "VEC4" || type == "MAT2")
    return 4;
  if (type == "MAT3")
    return 9;
  return type == "MAT4" ? 16 : 0;
}

Result<void> validateScene(const GltfFile& file, std::vector<std::string>& notes) {
  try {
    Validator(file, notes).run();
  } catch (const Fault& fault) {
    return Error{fault.kind, file.path.string() + ": " + fault.message};
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources,
                 file.path.string() + ": not enough memory to validate the scene"};
  }
  return {};
}

} // namespace lichen::renderer
