// SPDX-License-Identifier: MIT
// The steps of applyNoise(). Notes are sentences for the user; `words` name settings in them.
#pragma once

#include <lichen/apply_noise.h>
#include <lichen/counted.h>

#include <iterator>

namespace lichen::apply {

inline void append(std::vector<std::string>& notes, std::vector<std::string> more) {
  notes.insert(notes.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

struct ChosenMaterials {
  std::vector<std::size_t> indices; ///< unique, in the scene's order
  bool areAll = false;              ///< every material is meant, not single ones
};

/// Finds materials: all of them, the one with a given name, or the one with a given index. Errors:
/// usage if a value matches no material or several, badInput if the scene has no materials.
[[nodiscard]] Result<ChosenMaterials>
findMaterials(const GltfScene& scene, const std::vector<std::string>& wanted, SettingWords words);

/// Returns the materials for which every primitive has the attribute that `option` needs. If the
/// user chose all materials, the others are skipped with a note. Errors: badInput if a material
/// that the user named has a primitive without the attribute, or if no material remains; `instead`
/// tells the user what would work.
[[nodiscard]] Result<std::vector<std::size_t>>
materialsWith(const std::string& attribute, const GltfScene& scene, const ChosenMaterials& chosen,
              const std::string& option, const std::string& instead,
              std::vector<std::string>& notes);

/// Returns the materials whose meshes can use the frame's tangents, and skips or refuses the others
/// as materialsWith() does. `bringsNormals` is the parameter of checkFrames(). Errors: badInput.
[[nodiscard]] Result<std::vector<std::size_t>> materialsWithFrames(const GltfScene& scene,
                                                                   const ChosenMaterials& chosen,
                                                                   bool bringsNormals,
                                                                   std::vector<std::string>& notes);

/// Reads the vertices of all meshes. Invalid vertices are a badInput error if the primitive uses
/// one of the materials; otherwise the primitive stays as it is and gets a note. Compressed
/// vertices, which only some viewers can read, get a note too.
[[nodiscard]] Result<void> checkMeshes(GltfScene& scene, std::span<const std::size_t> materials,
                                       std::vector<std::string>& notes);

struct ChosenMix {
  MixWeight weight;
  std::vector<std::size_t> materials; ///< whose meshes have what the source of the weight needs
};

/// Returns the source that the options choose; without options, the source of `use`, whose mapping
/// and texture coordinates must be final. An image file becomes a texture of the scene. Notes name
/// materials that are skipped. Errors: usage for options that contradict each other or do not fit
/// the noise; badInput for an unusable image, and as materialsWith().
[[nodiscard]] Result<ChosenMix> chosenMix(const MixOptions& options, const Noise& noise,
                                          const MaterialNoise& use, const ChosenMaterials& chosen,
                                          GltfScene& scene, SettingWords words,
                                          std::vector<std::string>& notes);

/// Adds the tangent frames that `surface` needs to the meshes that use one of the materials, with
/// notes on them and on what they change. Errors: as addSurfaceFrames().
[[nodiscard]] Result<std::vector<MeshFrames>>
addFrames(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise,
          const std::optional<Vector3>& grain, const BakeObserver& observer,
          std::vector<std::string>& notes);

/// Checks that no material is described by KHR_materials_pbrSpecularGlossiness instead of the
/// core's textures, which the noise replaces. Errors: badInput.
[[nodiscard]] Result<void> checkShading(const GltfScene& scene,
                                        std::span<const std::size_t> materials);

/// Removes KHR_materials_unlit, with one note: it replaces the shading by the base colour. All
/// other extensions stay.
void removeUnlit(GltfScene& scene, std::span<const std::size_t> materials,
                 std::vector<std::string>& notes);

/// Returns one note on the textures that remain, wholly or in part, because the noise does not have
/// all their channels; empty if none remains. They keep their own texture coordinates and do not
/// follow the noise's mapping.
[[nodiscard]] std::vector<std::string>
notesOnTextures(const GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise);

/// Describes, with at most one note of each kind, the material factors that change the look of the
/// noise. If `areSetToOne`, the factors do not change the noise, but other viewers show an emissive
/// factor of 1.
[[nodiscard]] std::vector<std::string> notesOnFactors(const GltfScene& scene,
                                                      std::span<const std::size_t> materials,
                                                      const Noise& noise, bool areSetToOne,
                                                      SettingWords words);

/// Sets every factor that multiplies a map of the noise to 1, except the alpha of a colour.
void setFactorsToOne(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise);

} // namespace lichen::apply
