// SPDX-License-Identifier: MIT
// Materials and textures [glTF 2.0, sections 3.8 and 3.9], KHR_texture_transform,
// KHR_materials_emissive_strength, and what the renderer needs of LICHEN_materials_exemplar_noise.
#include "material_load.h"

#include "printable.h"

#include <lichen/gltf_files.h>
#include <lichen/image_io.h>

#include <algorithm>
#include <cmath>
#include <object_reader.h>

namespace lichen::renderer {
namespace {

using nlohmann::json;

constexpr float kByteMax = 255.0f;
// Filters and wraps of a sampler [glTF 2.0, section 5.26].
constexpr std::uint64_t kNearest = 9728, kLinear = 9729, kNearestMipNearest = 9984,
                        kLinearMipNearest = 9985, kNearestMipLinear = 9986, kLinearMipLinear = 9987;
constexpr std::uint64_t kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;

Sampler readSampler(const Place& source) {
  Sampler result;
  const auto wrap = [&](const char* key) {
    const auto value = source.oneOf(key, {kRepeat, kClampToEdge, kMirroredRepeat});
    if (value == kClampToEdge)
      return Wrap::clampToEdge;
    return value == kMirroredRepeat ? Wrap::mirroredRepeat : Wrap::repeat;
  };
  result.wrapU = wrap("wrapS");
  result.wrapV = wrap("wrapT");
  if (source.oneOf("magFilter", {kNearest, kLinear}) == kNearest)
    result.magnification = Filter::nearest;
  const auto minify =
      source.oneOf("minFilter", {kNearest, kLinear, kNearestMipNearest, kLinearMipNearest,
                                 kNearestMipLinear, kLinearMipLinear});
  result.mipmapped = minify != kNearest && minify != kLinear;
  if (minify == kNearest || minify == kNearestMipNearest || minify == kNearestMipLinear)
    result.minification = Filter::nearest;
  if (minify == kNearestMipNearest || minify == kLinearMipNearest)
    result.mip = Filter::nearest;
  return result;
}

/// Sets the image and the sampler of a slot. The image index refers to the file's images;
/// readMaterials() replaces it.
void setTexture(const SceneFile& file, const Place& texture, TextureSlot& slot) {
  slot.image = file.index(texture, "source", "images");
  if (const std::optional<Place> sampler = file.follow(texture, "sampler", "samplers"))
    slot.sampler = readSampler(*sampler);
}

/// Reads the coordinates of a textureInfo and their transform.
void readTransform(const Place& info, TextureSlot& slot) {
  const Place transform = info.extension("KHR_texture_transform");
  slot.texCoord = int(transform.integer("texCoord", 0, 1, info.integer("texCoord", 0, 1, 0)));
  slot.offset = transform.vector("offset", slot.offset);
  slot.scale = transform.vector("scale", slot.scale);
  slot.rotation = float(transform.number("rotation", 0.0));
}

TextureSlot readSlot(const SceneFile& file, const std::optional<Place>& info) {
  TextureSlot slot;
  if (!info)
    return slot;
  (void)info->member("index");
  setTexture(file, *file.follow(*info, "index", "textures"), slot);
  readTransform(*info, slot);
  return slot;
}

// The plugin validates the noise extension later; until then, this file treats its faults and
// unknown methods or revisions as absence.

/// A member or an element of a value of any type; a null value if it does not exist.
const json& at(const json& value, const char* key) {
  static const json kNull;
  const json* member = memberOf(&value, key);
  return member != nullptr ? *member : kNull;
}
const json& at(const json& value, std::optional<std::size_t> index) {
  static const json kNull;
  return value.is_array() && index && *index < value.size() ? value[*index] : kNull;
}

std::optional<std::size_t> indexIn(const json& value) {
  return value.is_number_unsigned() ? std::optional(value.get<std::size_t>()) : std::nullopt;
}

/// An integer from 0 to `most`, or 0.
int smallInteger(const json& value, std::size_t most) {
  const std::size_t number = indexIn(value).value_or(0);
  return number <= most ? int(number) : 0;
}

bool isText(const json& value, std::string_view expected) {
  return value.is_string() && value.get_ref<const std::string&>() == expected;
}

/// The noise that a material uses.
const json& noiseOf(const SceneFile& file, const json& use) {
  static const json kNull;
  const json& root = at(at(file.root().json(), "extensions"), kExtensionName.data());
  const json& noise = at(at(root, "noises"), indexIn(at(use, "noise")));
  const std::string* name = stringMember(noise, "method");
  const std::optional<Method> method = name != nullptr ? methodFrom(*name) : std::nullopt;
  const std::optional<std::size_t> revision = indexIn(at(noise, "revision"));
  const bool isRead = method && revision && *revision <= std::size_t(revisionOf(*method));
  return isRead ? noise : kNull;
}

/// Reads the source of a mix's weight, if that is a texture or vertex colours.
void readMix(const SceneFile& file, const Place& use, Material& result) {
  const std::optional<Place> mix = use.find("mix");
  if (!mix || !mix->json().is_object())
    return;
  const json& source = at(mix->json(), "source");
  constexpr int kAlpha = 3;
  constexpr int kLastColorSet = 15;
  if (source.is_string())
    result.mixChannel = smallInteger(at(mix->json(), "channel"), kAlpha);
  if (isText(source, nameOf(MixSource::vertexColor)))
    result.mixColorSet = smallInteger(at(mix->json(), "set"), kLastColorSet);
  const std::optional<Place> info = mix->find("texture");
  if (!info || !info->json().is_object())
    return;
  TextureSlot mask;
  readTransform(*info, mask);
  const std::optional<std::size_t> index = indexIn(at(info->json(), "index"));
  if (!isText(source, nameOf(MixSource::texture)) || !index ||
      *index >= file.root().countOf("textures"))
    return;
  setTexture(file, file.element("textures", *index), mask);
  if (mask.image)
    result.mixTexture = mask;
}

/// Whether a noise has these channels of a target, so that no core texture of them is drawn.
bool brings(const json& noise, MapTarget target, std::initializer_list<MapChannel> channels) {
  for (const json& map : at(noise, "maps")) {
    if (!isText(at(map, "target"), nameOf(target)))
      continue;
    const json& list = at(map, "channels");
    return std::all_of(channels.begin(), channels.end(), [&](MapChannel channel) {
      return std::any_of(list.begin(), list.end(),
                         [&](const json& name) { return isText(name, nameOf(channel)); });
    });
  }
  return false;
}

void readNoiseUse(const SceneFile& file, const Place& use, Material& result) {
  result.hasNoise = true;
  const json& noise = noiseOf(file, use.json());
  result.noiseHasHeight = brings(noise, MapTarget::height, {MapChannel::height});
  const json& mapping = at(use.json(), "mapping");
  if (isText(mapping, nameOf(Mapping::surface))) {
    result.noiseNeedsTangents = noise.is_object();
  } else if (!isText(mapping, nameOf(Mapping::triplanar)) &&
             !isText(mapping, nameOf(Mapping::solid))) {
    // The slopes of those are 3-D gradients.
    result.noiseTexCoord = smallInteger(at(use.json(), "texCoord"), 1);
    if (brings(noise, MapTarget::normal, {}))
      result.noiseNormalTexCoord = result.noiseTexCoord;
  }
  readMix(file, use, result);
}

Material readMaterial(const SceneFile& file, const Place& source) {
  Material result;
  result.name = source.string("name").value_or("");
  if (const std::optional<Place> pbr = source.find("pbrMetallicRoughness")) {
    result.baseColor = pbr->vector("baseColorFactor", result.baseColor, 0, 1);
    result.metallic = float(pbr->number("metallicFactor", 1, 0, 1));
    result.roughness = float(pbr->number("roughnessFactor", 1, 0, 1));
    result.baseColorTexture = readSlot(file, pbr->find("baseColorTexture"));
    result.metallicRoughnessTexture = readSlot(file, pbr->find("metallicRoughnessTexture"));
  }
  result.emissive =
      source.vector("emissiveFactor", result.emissive, 0, 1) *
      float(source.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1, 0));
  if (const std::optional<Place> normals = source.find("normalTexture")) {
    result.normalTexture = readSlot(file, normals);
    result.normalScale = float(normals->number("scale", 1));
  }
  if (const std::optional<Place> occlusion = source.find("occlusionTexture")) {
    result.occlusionTexture = readSlot(file, occlusion);
    result.occlusionStrength = float(occlusion->number("strength", 1, 0, 1));
  }
  result.emissiveTexture = readSlot(file, source.find("emissiveTexture"));
  const std::string alphaMode = source.oneOf("alphaMode", {"OPAQUE", "MASK", "BLEND"});
  if (alphaMode != "OPAQUE")
    result.alphaMode = alphaMode == "MASK" ? AlphaMode::mask : AlphaMode::blend;
  result.alphaCutoff = float(source.number("alphaCutoff", 0.5, 0));
  result.doubleSided = source.boolean("doubleSided");
  if (const std::optional<Place> use = source.findExtension(kExtensionName.data()))
    readNoiseUse(file, *use, result);
  return result;
}

/// Converts grey, grey + alpha, RGB or RGBA to RGBA bytes.
TextureImage asBytes(const SrgbImage& image) {
  TextureImage result;
  result.width = image.width;
  result.height = image.height;
  result.rgba.resize(image.pixelCount() * 4);
  const auto channels = std::size_t(image.channels);
  const std::size_t colors = channels >= 3 ? 3 : 1;
  const auto byte = [](float v) {
    return std::uint8_t(std::lround(std::clamp(v, 0.0f, 1.0f) * kByteMax));
  };
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    const float* pixel = image.values.data() + i * channels;
    for (std::size_t c = 0; c < 3; ++c)
      result.rgba[i * 4 + c] = byte(pixel[colors == 3 ? c : 0]);
    result.rgba[i * 4 + 3] = channels > colors ? byte(pixel[colors]) : std::uint8_t(255);
  }
  return result;
}

/// The slots of a material whose place its noise takes.
std::vector<const TextureSlot*> replacedSlots(const SceneFile& file, const Place& source,
                                              const Material& material) {
  const json& noise = noiseOf(file, source.extension(kExtensionName.data()).json());
  const auto orm = MapTarget::occlusionRoughnessMetallic;
  std::vector<const TextureSlot*> slots;
  const auto add = [&](const TextureSlot& slot, bool isReplaced) {
    if (isReplaced)
      slots.push_back(&slot);
  };
  add(material.baseColorTexture, brings(noise, MapTarget::baseColor, {MapChannel::red}) &&
                                     (material.alphaMode == AlphaMode::opaque ||
                                      brings(noise, MapTarget::opacity, {MapChannel::opacity})));
  add(material.metallicRoughnessTexture,
      brings(noise, orm, {MapChannel::roughness, MapChannel::metallic}));
  add(material.normalTexture, brings(noise, MapTarget::normal, {MapChannel::slopeX}));
  add(material.occlusionTexture, brings(noise, orm, {MapChannel::occlusion}));
  add(material.emissiveTexture, brings(noise, MapTarget::emissive, {MapChannel::red}));
  return slots;
}

class MaterialReader {
public:
  MaterialReader(SceneFile& file, Scene& scene)
      : file_(file), scene_(scene), indexOf_(file.root().countOf("images")) {}

  void run() {
    checkImageBytes();
    file_.root().each("materials", [&](const Place& source, std::size_t) {
      scene_.materials.push_back(readMaterial(file_, source));
      Material& material = scene_.materials.back();
      const std::vector<const TextureSlot*> replaced = replacedSlots(file_, source, material);
      for (TextureSlot* slot :
           {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
            &material.occlusionTexture, &material.emissiveTexture, &material.mixTexture})
        if (slot->image)
          load(*slot, std::find(replaced.begin(), replaced.end(), slot) != replaced.end(),
               source.pointer());
    });
    scene_.materials.push_back(Material());
  }

private:
  /// Throws a Fault if the files and data URIs of all images, used or not, are too large.
  void checkImageBytes() const {
    std::uintmax_t total = 0;
    file_.root().each("images", [&](const Place& image, std::size_t) {
      const std::string uri = image.string("uri").value_or("");
      const Result<std::filesystem::path> path = fileOfUri(file_.path(), uri);
      std::error_code absent;
      const std::uintmax_t size =
          path ? std::filesystem::file_size(path.value(), absent) : uri.size() / 4 * 3;
      total += absent ? 0 : size;
      if (total > kMaxImageBytes)
        throw Fault{"/images: more than " + std::to_string(kMaxImageBytes) +
                        " bytes of image files in total; use smaller images",
                    ErrorKind::resources};
    });
  }

  /// Each image of the file at most once. One that is absent is a note if a noise takes its place.
  void load(TextureSlot& slot, bool isReplaced, const std::string& material) {
    std::optional<std::size_t>& index = indexOf_[*slot.image];
    if (index) {
      slot.image = index;
      return;
    }
    const Place image = file_.element("images", *slot.image);
    std::vector<std::byte> loaded;
    const std::span<const std::byte> bytes = fileOf(image, loaded);
    if (bytes.empty()) {
      const std::string name = image.string("uri").value_or("");
      const std::string absence = image.pointer() + ": its file" +
                                  (name.empty() ? "" : " \"" + printable(name) + "\"") +
                                  " cannot be read";
      if (!isReplaced)
        throw Fault{absence + "; expected a PNG or JPEG inside the scene's folder"};
      scene_.notes.push_back(absence + "; the noise of " + material + " takes its place");
      slot.image.reset();
      return;
    }
    slot.image = index = scene_.images.size();
    scene_.images.push_back(decode(bytes, image.pointer()));
  }

  /// The encoded file of an image, in a bufferView or read into `loaded`; empty if it is absent.
  std::span<const std::byte> fileOf(const Place& image, std::vector<std::byte>& loaded) {
    const std::optional<Place> view = image.find("bufferView");
    const std::optional<std::string> uri = image.string("uri");
    if (view.has_value() == uri.has_value())
      image.fail("expected exactly one of uri and bufferView");
    if (view)
      return file_.view(*view);
    Result<std::vector<std::byte>> read = readUri(file_.path(), *uri);
    if (!read) {
      if (read.error().kind == ErrorKind::resources)
        throw Fault{image.pointer() + ": " + read.error().message, ErrorKind::resources};
      return {};
    }
    loaded = std::move(read).value();
    return loaded;
  }

  TextureImage decode(std::span<const std::byte> bytes, const std::string& name) {
    const Result<ImageFile> file = decodeImage(bytes, name);
    if (!file)
      throw Fault{file.error().message, file.error().kind};
    const auto* pixels = std::get_if<SrgbImage>(&file.value().pixels);
    if (pixels == nullptr)
      throw Fault{name + ": is an EXR; expected a PNG or JPEG"};
    texels_ += pixels->pixelCount();
    if (texels_ > kMaxSceneTexels)
      throw Fault{"/images: more than " + std::to_string(kMaxSceneTexels) +
                      " texels in total; use smaller images",
                  ErrorKind::resources};
    return asBytes(*pixels);
  }

  SceneFile& file_;
  Scene& scene_;
  std::vector<std::optional<std::size_t>> indexOf_; ///< into scene_.images, by image of the file
  std::size_t texels_ = 0;
};

} // namespace

void readMaterials(SceneFile& file, Scene& scene) { MaterialReader(file, scene).run(); }

} // namespace lichen::renderer
