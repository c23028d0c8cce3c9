// SPDX-License-Identifier: MIT
// Layered noises: index maps that choose between several noises [MKN12] section 5.
#pragma once

#include <lichen/bundle.h>

#include <cstdint>
#include <lichen_interface.h>
#include <string>

namespace lichen {

/// Whether a layer of a noise may have this method.
[[nodiscard]] bool isLayerable(Method method);
/// The names of the methods that isLayerable() accepts: "tiling, texton or multiple-kernels".
[[nodiscard]] std::string layerableMethods();

/// Why `noise` of `bundle` does not fit beside `first`, the first layer, of `firstBundle`: a
/// sentence that names it, or empty. Compares `first` with itself too.
[[nodiscard]] std::string layerFault(const Bundle& firstBundle, const Noise& first,
                                     const Bundle& bundle, const Noise& noise);

/// Why maps with this target do not fit into so many layers, in [2, 4]: in one sentence, or empty.
[[nodiscard]] std::string layerTargetFault(std::size_t layers, MapTarget target);

/// Why the layers of a noise, which has some, do not fit together: in one sentence, or empty.
[[nodiscard]] std::string layersFault(const Bundle& bundle, std::size_t noise);

/// Whether noises with layers support a mapping, if all their layers and index maps do.
[[nodiscard]] constexpr bool mappingFitsLayers(Mapping mapping) {
  return mapping != Mapping::surface;
}

/// Why a noise, or one among its layers and index maps, does not support a mapping: a sentence that
/// names it, or empty.
[[nodiscard]] std::string mappingObstacle(const Bundle& bundle, std::size_t noise, Mapping mapping);

/// Whether a noise and all its layers take a MaterialNoise::tileRotation.
[[nodiscard]] bool takesTileRotation(const Bundle& bundle, std::size_t noise,
                                     std::uint32_t tileRotation);

/// A noise as an index map: with its first map alone, whose values are the Gaussian ones.
[[nodiscard]] Noise asIndex(Noise noise);

/// Where the shader finds the map of a role of a layer: the binding and the index in
/// LichenNoiseConstants::maps of this role. Layer 0 has the bindings of its roles. Others: `role`
/// is one that so many layers may have (layersFault()).
[[nodiscard]] std::uint32_t layerSlot(std::size_t layer, std::uint32_t role);

/// The members of the block of a noise that say how its layers are chosen; 0 if it has none.
[[nodiscard]] shader::LichenLayers shaderLayers(const Noise& noise);

} // namespace lichen
