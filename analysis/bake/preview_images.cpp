// SPDX-License-Identifier: MIT
// Bundle -> PNG files for the core texture slots.
#include <lichen/bake_material.h>
#include <lichen/synthesize.h>

#include <map>
#include <utility>

namespace lichen {
namespace {

/// Exemplar widths along a side of the preview image: enough that the image repeats less often than
/// the exemplar would.
constexpr int kTilesPerPreview = 2;

LinearImage white() {
  LinearImage image(1, 1, 1);
  image.values.front() = 1.0f;
  return image;
}

/// Tileable images of the maps of a material's noise.
Result<PreviewImages> previewImages(const Bundle& bundle, const MaterialNoise& material) {
  std::map<MapTarget, LinearImage> textures;
  for (const NoiseMap& map : bundle.noises[material.noise].maps) {
    if (map.target == MapTarget::height)
      continue; // core materials have no height texture
    Result<LinearImage> values = synthesizePreview(bundle, material, map.target, kTilesPerPreview);
    if (!values)
      return values.error();
    textures[map.target] = coreTexture(map, std::move(values).value());
  }
  if (const auto opacity = textures.find(MapTarget::opacity); opacity != textures.end())
    textures[MapTarget::baseColor] = withAlpha(textures[MapTarget::baseColor], opacity->second);
  // The white texture uses the scene's texture coordinates; otherwise the Khronos validator would
  // report them as unused, although the noise needs them.
  if (textures.empty())
    textures[MapTarget::baseColor] = white();

  PreviewImages images;
  images.tilesPerImage = kTilesPerPreview;
  const std::pair<MapTarget, std::vector<std::byte>*> slots[] = {
      {MapTarget::baseColor, &images.baseColor},
      {MapTarget::normal, &images.normal},
      {MapTarget::occlusionRoughnessMetallic, &images.occlusionRoughnessMetallic},
      {MapTarget::emissive, &images.emissive}};
  for (const auto& [target, slot] : slots) {
    const auto texture = textures.find(target);
    if (texture == textures.end())
      continue;
    Result<std::vector<std::byte>> png = encodeCoreTexture(target, std::move(texture->second));
    if (!png)
      return png.error();
    *slot = std::move(png).value();
  }
  return images;
}

} // namespace

Result<BundleFile> withPreviews(Bundle bundle, PreviewShape shape, std::string generator,
                                const Progress& progress) {
  BundleFile file;
  file.bundle = std::move(bundle);
  file.shape = shape;
  file.generator = std::move(generator);
  const auto count = double(file.bundle.materials.size());
  for (const std::optional<MaterialNoise>& material : file.bundle.materials) {
    Result<PreviewImages> images = previewImages(file.bundle, *material);
    if (!images)
      return images.error();
    file.previews.push_back(std::move(images).value());
    if (progress && !progress(double(file.previews.size()) / count))
      return Error{ErrorKind::environment, "interrupted"};
  }
  return file;
}

} // namespace lichen
