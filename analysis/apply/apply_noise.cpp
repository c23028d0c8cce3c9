// SPDX-License-Identifier: MIT
// Scene, noise and options -> the scene with the noise on its materials.
#include "steps.h"

#include <lichen/layered_noise.h>

#include <fmt/format.h>

namespace lichen {
namespace {

using namespace apply;

Result<void> checkOptions(const Bundle& bundle, std::size_t noise, const ApplyOptions& options,
                          SettingWords words) {
  const MaterialNoise& use = options.use;
  if (noise >= bundle.noises.size())
    return Error{ErrorKind::usage,
                 fmt::format("noise {}: the bundle has {}", noise, bundle.noises.size())};
  if (const std::string obstacle = mappingObstacle(bundle, noise, use.mapping); !obstacle.empty())
    return Error{ErrorKind::usage,
                 words({"mapping", std::string(nameOf(use.mapping))}) + ": " + obstacle};
  if (!takesTileRotation(bundle, noise, use.tileRotation))
    return Error{ErrorKind::usage,
                 fmt::format("{}: the tiles of the noise '{}' are not square; expected none or 2",
                             words({"tile-rotation", std::to_string(use.tileRotation)}),
                             bundle.noises[noise].name)};
  if (options.grain && use.mapping != Mapping::surface)
    return Error{ErrorKind::usage, fmt::format("{}: belongs to {}, not to {}", words({"grain", ""}),
                                               words({"mapping", "surface"}), nameOf(use.mapping))};
  return {};
}

/// Returns the materials that have, or can be given, what the mapping needs.
Result<std::vector<std::size_t>>
suitableMaterials(const GltfScene& scene, const ChosenMaterials& chosen, const Noise& noise,
                  const MaterialNoise& use, SettingWords words, std::vector<std::string>& notes) {
  switch (use.mapping) {
  case Mapping::uv:
    return materialsWith(fmt::format("TEXCOORD_{}", use.texCoord), scene, chosen,
                         words({"mapping", "uv"}), words({"mapping", "triplanar"}), notes);
  case Mapping::surface:
    return materialsWithFrames(scene, chosen, findMap(noise, MapTarget::normal).has_value(), notes);
  default:
    return chosen.indices;
  }
}

/// Adds a note if the noise is renamed in the scene.
void noteName(const GltfScene& scene, const std::string& name, const AppliedNoise& applied,
              std::vector<std::string>& notes) {
  if (applied.name == name)
    return;
  notes.push_back(
      fmt::format("{}: noise '{}' {} '{}'", scene.path().string(), name,
                  applied.isNew ? "is renamed, since the name is taken, to" : "is already there as",
                  applied.name));
}

/// The noise of a bundle as it goes on a scene.
Result<NoiseOnScene> applied(GltfScene& scene, const Bundle& bundle, std::size_t index,
                             const ApplyOptions& options, const BakeObserver& observer) {
  const SettingWords words = observer.words;
  if (Result<void> checked = checkOptions(bundle, index, options, words); !checked)
    return checked.error();
  const Noise& noise = bundle.noises[index];
  NoiseOnScene done;
  const Result<ChosenMaterials> chosen = findMaterials(scene, options.materials, words);
  if (!chosen)
    return chosen.error();
  MaterialNoise use = options.use;
  Result<std::vector<std::size_t>> suitable =
      suitableMaterials(scene, chosen.value(), noise, use, words, done.notes);
  if (!suitable)
    return suitable.error();
  const Result<ChosenMix> mix =
      chosenMix(options.mix, noise, use, {std::move(suitable).value(), chosen.value().areAll},
                scene, words, done.notes);
  if (!mix)
    return mix.error();
  use.mix = mix.value().weight;
  const std::vector<std::size_t>& materials = mix.value().materials;
  if (Result<void> checked = checkShading(scene, materials); !checked)
    return checked.error();
  std::vector<std::string> frameNotes; // come last
  if (use.mapping == Mapping::surface) {
    Result<std::vector<MeshFrames>> frames =
        addFrames(scene, materials, noise, options.grain, observer, frameNotes);
    if (!frames)
      return frames.error();
    done.frames = std::move(frames).value();
  } else if (Result<void> sound = checkMeshes(scene, materials, done.notes); !sound) {
    return sound.error(); // frames read the same vertices and report their own errors
  }
  Result<AppliedNoise> noiseOn = scene.applyNoise(bundle, index, use, materials);
  if (!noiseOn)
    return noiseOn.error();
  done.noise = std::move(noiseOn).value();
  if (options.setsFactors)
    setFactorsToOne(scene, materials, noise);
  removeUnlit(scene, materials, done.notes);
  noteName(scene, noise.name, done.noise, done.notes);
  for (const std::size_t material : materials)
    done.materials.push_back(scene.materialTitle(material));
  append(done.notes, notesOnFactors(scene, materials, noise, options.setsFactors, words));
  append(done.notes, notesOnTextures(scene, materials, noise));
  append(done.notes, std::move(frameNotes));
  return done;
}

} // namespace

Result<NoiseOnScene> applyNoise(GltfScene& scene, const Bundle& bundle, std::size_t noise,
                                const ApplyOptions& options, const BakeObserver& observer) {
  return withinMemory(
      [&] { return scene.path().string() + ": not enough memory to put the noise on it"; },
      [&] { return applied(scene, bundle, noise, options, observer); });
}

} // namespace lichen
