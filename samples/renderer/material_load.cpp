// SPDX-License-Identifier: MIT
// Materials and textures [glTF 2.0, sections 3.8 and 3.9], KHR_texture_transform,
// KHR_materials_emissive_strength, and what the renderer needs of LICHEN_materials_exemplar_noise.
#include "material_load.h"

#include "printable.h"

#include <lichen/bundle.h>
#include <lichen/image_io.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace lichen::renderer {
namespace {

constexpr float kByteMax = 255.0f;

Sampler readSampler(const tinygltf::Model& model, int index) {
  Sampler result;
  if (index < 0)
    return result;
  const tinygltf::Sampler& source = model.samplers[std::size_t(index)];
  const auto wrap = [](int value) {
    if (value == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE)
      return Wrap::clampToEdge;
    return value == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirroredRepeat : Wrap::repeat;
  };
  const int minify = source.minFilter;
  result.wrapU = wrap(source.wrapS);
  result.wrapV = wrap(source.wrapT);
  if (source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
    result.magnification = Filter::nearest;
  result.mipmapped =
      minify != TINYGLTF_TEXTURE_FILTER_NEAREST && minify != TINYGLTF_TEXTURE_FILTER_LINEAR;
  if (minify == TINYGLTF_TEXTURE_FILTER_NEAREST ||
      minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
      minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR)
    result.minification = Filter::nearest;
  if (minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
      minify == TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST)
    result.mip = Filter::nearest;
  return result;
}

const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

float numberIn(const tinygltf::Value& object, const char* key, float absent) {
  return object.Has(key) ? float(object.Get(key).GetNumberAsDouble()) : absent;
}

glm::vec2 pairIn(const tinygltf::Value& object, const char* key, glm::vec2 absent) {
  if (!object.Has(key))
    return absent;
  const tinygltf::Value& pair = object.Get(key);
  return {float(pair.Get(0).GetNumberAsDouble()), float(pair.Get(1).GetNumberAsDouble())};
}

/// A member or an element of a value of any type; a null value if it does not exist.
const tinygltf::Value& at(const tinygltf::Value& value, const char* key) {
  static const tinygltf::Value kNull;
  return value.Has(key) ? value.Get(key) : kNull;
}
const tinygltf::Value& at(const tinygltf::Value& value, int index) {
  static const tinygltf::Value kNull;
  return index >= 0 && std::size_t(index) < value.ArrayLen() ? value.Get(index) : kNull;
}

/// The noise that a material uses. The plugin validates the extension later; until then, this file
/// treats faults and unknown methods or revisions as absence.
const tinygltf::Value& noiseOf(const tinygltf::Model& model, const tinygltf::Value& use) {
  static const tinygltf::Value kNull;
  const tinygltf::Value* root = extension(model.extensions, kExtensionName.data());
  const tinygltf::Value& index = at(use, "noise");
  if (root == nullptr || !index.IsInt())
    return kNull;
  const tinygltf::Value& noise = at(at(*root, "noises"), index.GetNumberAsInt());
  const tinygltf::Value& method = at(noise, "method");
  const tinygltf::Value& revision = at(noise, "revision");
  const std::optional<Method> known =
      method.IsString() ? methodFrom(method.Get<std::string>()) : std::nullopt;
  const bool isRead = known && revision.IsInt() && revision.GetNumberAsInt() <= revisionOf(*known);
  return isRead ? noise : kNull;
}

/// Whether a material states this mapping; not meant for uv, the default.
bool hasMapping(const tinygltf::Value& use, Mapping expected) {
  const tinygltf::Value& mapping = at(use, "mapping");
  return mapping.IsString() && mapping.Get<std::string>() == nameOf(expected);
}

/// Reads the source of a mix's weight, if that is a texture or vertex colours.
void readMix(const tinygltf::Model& model, const tinygltf::Value& use, Material& result) {
  const tinygltf::Value& mix = at(use, "mix");
  const tinygltf::Value& source = at(mix, "source");
  const auto integer = [](const tinygltf::Value& value, int most) {
    const int number = value.IsInt() ? value.GetNumberAsInt() : 0;
    return number >= 0 && number <= most ? number : 0;
  };
  constexpr int kAlpha = 3;
  constexpr int kLastColorSet = 15;
  if (!source.IsString())
    return;
  result.mixChannel = integer(at(mix, "channel"), kAlpha);
  if (source.Get<std::string>() == nameOf(MixSource::vertexColor))
    result.mixColorSet = integer(at(mix, "set"), kLastColorSet);
  if (source.Get<std::string>() != nameOf(MixSource::texture))
    return;
  const tinygltf::Value& info = at(mix, "texture");
  const tinygltf::Value& index = at(info, "index");
  if (!index.IsInt() || index.GetNumberAsInt() < 0 ||
      std::size_t(index.GetNumberAsInt()) >= model.textures.size())
    return;
  const tinygltf::Texture& texture = model.textures[std::size_t(index.GetNumberAsInt())];
  if (texture.source < 0)
    return;
  TextureSlot& slot = result.mixTexture;
  slot.image = std::size_t(texture.source);
  slot.sampler = readSampler(model, texture.sampler);
  const tinygltf::Value& transform = at(at(info, "extensions"), "KHR_texture_transform");
  const auto pair = [&](const char* key, glm::vec2 absent) {
    const tinygltf::Value& values = at(transform, key);
    const bool isPair = values.IsArray() && values.ArrayLen() == 2;
    return isPair ? glm::vec2(at(values, 0).GetNumberAsDouble(), at(values, 1).GetNumberAsDouble())
                  : absent;
  };
  slot.offset = pair("offset", slot.offset);
  slot.scale = pair("scale", slot.scale);
  slot.rotation = float(at(transform, "rotation").GetNumberAsDouble());
  const tinygltf::Value& other = at(transform, "texCoord");
  slot.texCoord = integer(other.IsInt() ? other : at(info, "texCoord"), 1);
}

/// Whether a noise has these channels of a target, so that no core texture of them is drawn.
bool brings(const tinygltf::Value& noise, MapTarget target,
            std::initializer_list<MapChannel> channels) {
  const tinygltf::Value& maps = at(noise, "maps");
  for (int m = 0; m < int(maps.ArrayLen()); ++m) {
    const tinygltf::Value& map = at(maps, m);
    const tinygltf::Value& name = at(map, "target");
    if (!name.IsString() || name.Get<std::string>() != nameOf(target))
      continue;
    const tinygltf::Value& list = at(map, "channels");
    const auto has = [&](MapChannel channel) {
      for (int c = 0; c < int(list.ArrayLen()); ++c)
        if (at(list, c).IsString() && at(list, c).Get<std::string>() == nameOf(channel))
          return true;
      return false;
    };
    return std::all_of(channels.begin(), channels.end(), has);
  }
  return false;
}

/// Info is one of tinygltf's three textureInfo structs. The image index refers to the file's
/// images; readMaterials() replaces it.
template <class Info>
TextureSlot readSlot(const tinygltf::Model& model, const Info& info) {
  TextureSlot slot;
  if (info.index < 0)
    return slot;
  const tinygltf::Texture& texture = model.textures[std::size_t(info.index)];
  if (texture.source < 0)
    return slot; // only an unsupported extension names the image
  slot.image = std::size_t(texture.source);
  slot.sampler = readSampler(model, texture.sampler);
  slot.texCoord = info.texCoord;
  if (const tinygltf::Value* transform = extension(info.extensions, "KHR_texture_transform")) {
    slot.offset = pairIn(*transform, "offset", slot.offset);
    slot.scale = pairIn(*transform, "scale", slot.scale);
    slot.rotation = numberIn(*transform, "rotation", 0.0f);
    slot.texCoord = int(numberIn(*transform, "texCoord", float(slot.texCoord)));
  }
  return slot;
}

Material readMaterial(const tinygltf::Model& model, const tinygltf::Material& source) {
  Material result;
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  result.name = source.name;
  for (int c = 0; c < 4; ++c)
    result.baseColor[c] = float(pbr.baseColorFactor[std::size_t(c)]);
  result.metallic = float(pbr.metallicFactor);
  result.roughness = float(pbr.roughnessFactor);
  float strength = 1.0f;
  if (const tinygltf::Value* e = extension(source.extensions, "KHR_materials_emissive_strength"))
    strength = numberIn(*e, "emissiveStrength", 1.0f);
  for (int c = 0; c < 3; ++c)
    result.emissive[c] = float(source.emissiveFactor[std::size_t(c)]) * strength;
  result.normalScale = float(source.normalTexture.scale);
  result.occlusionStrength = float(source.occlusionTexture.strength);
  if (source.alphaMode == "MASK")
    result.alphaMode = AlphaMode::mask;
  else if (source.alphaMode == "BLEND")
    result.alphaMode = AlphaMode::blend;
  result.alphaCutoff = float(source.alphaCutoff);
  result.doubleSided = source.doubleSided;
  result.baseColorTexture = readSlot(model, pbr.baseColorTexture);
  result.metallicRoughnessTexture = readSlot(model, pbr.metallicRoughnessTexture);
  result.normalTexture = readSlot(model, source.normalTexture);
  result.occlusionTexture = readSlot(model, source.occlusionTexture);
  result.emissiveTexture = readSlot(model, source.emissiveTexture);
  if (const tinygltf::Value* use = extension(source.extensions, kExtensionName.data())) {
    result.hasNoise = true;
    const tinygltf::Value& noise = noiseOf(model, *use);
    result.noiseHasHeight = brings(noise, MapTarget::height, {MapChannel::height});
    if (hasMapping(*use, Mapping::surface)) {
      result.noiseNeedsTangents = noise.IsObject();
    } else if (!hasMapping(*use, Mapping::triplanar) && !hasMapping(*use, Mapping::solid)) {
      // The slopes of those are 3-D gradients.
      const tinygltf::Value& texCoord = at(*use, "texCoord");
      result.noiseTexCoord = texCoord.IsInt() ? texCoord.GetNumberAsInt() : 0;
      if (brings(noise, MapTarget::normal, {}))
        result.noiseNormalTexCoord = result.noiseTexCoord;
    }
    readMix(model, *use, result);
  }
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
std::vector<const TextureSlot*> replacedSlots(const tinygltf::Model& model,
                                              const tinygltf::Material& source,
                                              const Material& material) {
  const tinygltf::Value* use = extension(source.extensions, kExtensionName.data());
  if (use == nullptr)
    return {};
  const tinygltf::Value& noise = noiseOf(model, *use);
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

/// The encoded file of an image: in a bufferView, or loaded by tinygltf.
std::span<const std::byte> fileOf(const tinygltf::Model& model, const tinygltf::Image& image) {
  if (image.bufferView < 0)
    return std::as_bytes(std::span(image.image));
  const tinygltf::BufferView& view = model.bufferViews[std::size_t(image.bufferView)];
  return std::as_bytes(std::span(model.buffers[std::size_t(view.buffer)].data))
      .subspan(view.byteOffset, view.byteLength);
}

/// For a message.
std::string absenceOf(const tinygltf::Model& model, std::size_t image) {
  const std::string& uri = model.images[image].uri;
  return "/images/" + std::to_string(image) + ": its file" +
         (uri.empty() ? "" : " \"" + printable(uri) + "\"") + " cannot be read";
}

Result<TextureImage> decode(const tinygltf::Model& model, std::size_t index) {
  const std::span<const std::byte> bytes = fileOf(model, model.images[index]);
  const std::string name = "/images/" + std::to_string(index);
  if (bytes.empty())
    return Error{ErrorKind::badInput, absenceOf(model, index) + "; a PNG or JPEG inside the "
                                                                "scene's folder"};
  Result<ImageFile> file = decodeImage(bytes, name);
  if (!file)
    return file.error();
  const auto* pixels = std::get_if<SrgbImage>(&file.value().pixels);
  if (pixels == nullptr)
    return Error{ErrorKind::badInput, name + ": is an EXR; expected a PNG or JPEG"};
  return asBytes(*pixels);
}

} // namespace

Result<void> readMaterials(const tinygltf::Model& model, Scene& scene) {
  for (const tinygltf::Material& material : model.materials)
    scene.materials.push_back(readMaterial(model, material));
  scene.materials.push_back(Material());

  // Decode only images that a material uses, each once.
  std::vector<std::optional<std::size_t>> indexOf(model.images.size());
  std::size_t texels = 0;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    Material& material = scene.materials[m];
    const std::vector<const TextureSlot*> replaced =
        m < model.materials.size() ? replacedSlots(model, model.materials[m], material)
                                   : std::vector<const TextureSlot*>();
    for (TextureSlot* slot :
         {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
          &material.occlusionTexture, &material.emissiveTexture, &material.mixTexture}) {
      if (!slot->image)
        continue;
      if (fileOf(model, model.images[*slot->image]).empty() &&
          std::find(replaced.begin(), replaced.end(), slot) != replaced.end()) {
        scene.notes.push_back(absenceOf(model, *slot->image) + "; the noise of /materials/" +
                              std::to_string(m) + " takes its place");
        slot->image.reset();
        continue;
      }
      std::optional<std::size_t>& index = indexOf[*slot->image];
      if (!index) {
        Result<TextureImage> image = decode(model, *slot->image);
        if (!image)
          return image.error();
        texels += std::size_t(image.value().width) * std::size_t(image.value().height);
        if (texels > kMaxSceneTexels)
          return Error{ErrorKind::resources, "/images: more than " +
                                                 std::to_string(kMaxSceneTexels) +
                                                 " texels in total; use smaller images"};
        index = scene.images.size();
        scene.images.push_back(std::move(image).value());
      }
      slot->image = index;
    }
  }
  return {};
}

} // namespace lichen::renderer
