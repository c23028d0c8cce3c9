// SPDX-License-Identifier: MIT
// What a glTF file with LICHEN_materials_exemplar_noise holds: tables, noises, and the materials
// that use them. docs/gltf_extension/README.md is the format's specification.
#pragma once

#include <lichen/result.h>
#include <lichen/table.h>
#include <lichen/texton_map.h>
#include <lichen/tiling_map.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lichen {

inline constexpr std::string_view kExtensionName = "LICHEN_materials_exemplar_noise";

enum class MapTarget { baseColor, normal, occlusionRoughnessMetallic, emissive, height, opacity };
enum class MapChannel {
  red,
  green,
  blue,
  slopeX,
  slopeY,
  occlusion,
  roughness,
  metallic,
  height,
  opacity
};
/// Of the exemplar's stored values, in which mean and covariance are stated. The inverse table
/// holds light for srgb, the decoded value for the others.
enum class ValueEncoding { srgb, linear, slope, log2 };
enum class Mapping { uv, triplanar, surface, solid };
/// Where the places of a mapping in space are: in the world, or on each object, which the noise
/// then moves, turns and scales with.
enum class NoiseSpace { world, object };
/// How a noise is evaluated: tiling and blending [HN18], or sparse convolution of a texton [GLM17].
enum class Method { tiling, texton };

/// All methods, in their order.
[[nodiscard]] std::span<const Method> allMethods();
/// The revision of a method that this version writes and evaluates. Noises of other revisions are
/// ignored.
[[nodiscard]] int revisionOf(Method method);
/// How the impacts of a texton noise lie: one in each cell of a grid, or a Poisson process.
enum class PointProcess { stratified, poisson };
/// Where the weight of a mix comes from: a number, a way along texture coordinates, a texture, or
/// vertex colours.
enum class MixSource { constant, direction, texture, vertexColor };

/// The names that the JSON uses, for both directions.
[[nodiscard]] std::string_view nameOf(MapTarget value);
[[nodiscard]] std::string_view nameOf(MapChannel value);
[[nodiscard]] std::string_view nameOf(ValueEncoding value);
[[nodiscard]] std::string_view nameOf(Mapping value);
[[nodiscard]] std::string_view nameOf(NoiseSpace value);
[[nodiscard]] std::string_view nameOf(Method value);
[[nodiscard]] std::string_view nameOf(PointProcess value);
[[nodiscard]] std::string_view nameOf(MixSource value);
[[nodiscard]] std::optional<MapTarget> mapTargetFrom(std::string_view name);
[[nodiscard]] std::optional<MapChannel> mapChannelFrom(std::string_view name);
[[nodiscard]] std::optional<ValueEncoding> valueEncodingFrom(std::string_view name);
[[nodiscard]] std::optional<Mapping> mappingFrom(std::string_view name);
[[nodiscard]] std::optional<NoiseSpace> noiseSpaceFrom(std::string_view name);
[[nodiscard]] std::optional<Method> methodFrom(std::string_view name);
[[nodiscard]] std::optional<PointProcess> pointProcessFrom(std::string_view name);
[[nodiscard]] std::optional<MixSource> mixSourceFrom(std::string_view name);

/// What a method holds for all maps of a noise, and for one map. Both alternatives of a noise are
/// those of one method, in the order of Method.
using MethodNoise = std::variant<TilingNoise, TextonShape>;
using MethodMap = std::variant<TilingMap, TextonMap>;

/// One map of a noise.
struct NoiseMap {
  MapTarget target = MapTarget::baseColor;
  std::vector<MapChannel> channels; ///< 1 to 3
  ValueEncoding encoding = ValueEncoding::srgb;
  std::vector<double> mean;       ///< of the exemplar's stored values, n = channels.size() of them
  std::vector<double> covariance; ///< n x n, row-major, symmetric
  MethodMap data;

  /// The data of the map's own method. (std::get would bring an exception's type into libraries.)
  template <class Data>
  [[nodiscard]] const Data& as() const {
    assert(std::holds_alternative<Data>(data));
    return *std::get_if<Data>(&data);
  }
  template <class Data>
  [[nodiscard]] Data& as() {
    assert(std::holds_alternative<Data>(data));
    return *std::get_if<Data>(&data);
  }

  [[nodiscard]] bool operator==(const NoiseMap&) const = default;
};

/// Calls visit(index) for each index of a table in a map, const or not.
template <class Map, class Visit>
void visitTables(Map& map, const Visit& visit) {
  std::visit([&](auto& data) { data.visitTables(data, visit); }, map.data);
}

/// One noise: maps that share lattice, hash, seed and weights, or impacts.
struct Noise {
  std::string name;
  double tileSizeMetres = 1.0; ///< width of one exemplar
  MethodNoise data;
  std::vector<NoiseMap> maps;

  [[nodiscard]] Method method() const { return Method(data.index()); }
  /// The data of the noise's own method.
  template <class Data>
  [[nodiscard]] const Data& as() const {
    assert(std::holds_alternative<Data>(data));
    return *std::get_if<Data>(&data);
  }
  template <class Data>
  [[nodiscard]] Data& as() {
    assert(std::holds_alternative<Data>(data));
    return *std::get_if<Data>(&data);
  }

  [[nodiscard]] bool operator==(const Noise&) const = default;
};

struct Bundle;

/// The place of the noise's map of this target, where it has one.
[[nodiscard]] std::optional<std::size_t> findMap(const Noise& noise, MapTarget target);

/// Width and height in texels of the exemplar that a map was baked of. The maps of a texton noise
/// all had the size of the largest. `map` is one of the noise's, and its image is in the bundle.
[[nodiscard]] std::array<std::uint32_t, 2> exemplarSize(const Bundle& bundle, const Noise& noise,
                                                        const NoiseMap& map);

/// Whether noises of a method can be put on a surface in this way: uv and triplanar always, surface
/// for textons; none has a solid form.
[[nodiscard]] bool mappingFits(Method method, Mapping mapping);

/// Whether a noise changes along the weight of a mix.
[[nodiscard]] bool isMix(const Noise& noise);

/// Whether a mapping has its places in space, not on texture coordinates.
[[nodiscard]] bool isInSpace(Mapping mapping);

/// Inclusive bounds of a number.
struct NumberRange {
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
};

/// Of Noise::tileSizeMetres, as the format's schema states it.
inline constexpr NumberRange kTileSizeRange{1e-6, 1e6};

/// Of a material's parameters, as the format's schema states them.
inline constexpr NumberRange kScaleRange{1e-6, 1e6};
inline constexpr NumberRange kOffsetRange{-1e9, 1e9};
inline constexpr NumberRange kRotationRange{-1e6, 1e6};
inline constexpr NumberRange kBlendSharpnessRange{0.25, 16.0};
inline constexpr NumberRange kPlaneSharpnessRange{1.0, 64.0};
inline constexpr NumberRange kContrastRange{0.0, 4.0};
inline constexpr NumberRange kImpactsRange{1.0, 1000.0};
inline constexpr NumberRange kMixWeightRange{0.0, 1.0};
/// Of MaterialNoise::tileRotation: as many steps as the hash has, any angle.
inline constexpr std::uint32_t kMostTileRotation = 65536;
inline constexpr NumberRange kMixPlaceRange{-1e6, 1e6};
/// Between the two places of a direction, in texture coordinates: a sixtieth of a texel of the
/// widest exemplar. The square of 1e-170 is 0, by which the weight would be divided.
inline constexpr double kLeastMixWay = 1e-6;

/// The weight of a mix at a point: 0 is its first step, 1 the last, and it is clamped to them.
struct MixWeight {
  MixSource source = MixSource::constant;
  double weight = 0.0; ///< of MixSource::constant, in kMixWeightRange
  /// Of MixSource::direction: the texture coordinates, of the noise's set, where the weight is 0
  /// and 1; another place has that of the nearest point of the line through them. In
  /// kMixPlaceRange, and kLeastMixWay or more apart.
  std::array<double, 2> start{0.0, 0.0};
  std::array<double, 2> end{0.0, 1.0};
  std::size_t texture = 0; ///< of MixSource::texture: glTF's index; its stored value counts
  int texCoord = 0;        ///< of the texture, [0, 15]
  int colorSet = 0;        ///< of MixSource::vertexColor: the n of COLOR_n, [0, 15]
  int channel = 0;         ///< of a texture or vertex colours: 0 red to 3 alpha

  [[nodiscard]] bool operator==(const MixWeight&) const = default;
};

/// How a material uses a noise: everything that may change without a new bake.
struct MaterialNoise {
  std::size_t noise = 0;
  Mapping mapping = Mapping::uv;
  NoiseSpace space = NoiseSpace::world; ///< of mappings that are in space; world of others
  int texCoord = 0;
  /// Tile coordinate = offset + R(rotation) uv / scale, with the rotation of KHR_texture_transform:
  /// x' = cos x + sin y, y' = -sin x + cos y. One unit of tile space is one exemplar.
  double scale = 1.0;                     ///< texture-coordinate units that one exemplar spans, > 0
  std::array<double, 2> offset{0.0, 0.0}; ///< tiles
  double rotation = 0.0;                  ///< radians
  std::uint32_t seed = 1;
  double blendSharpness = 1.0; ///< exponent of the blend weights, [0.25, 16]
  double planeSharpness = 8.0; ///< of triplanar: exponent of the planes' weights, [1, 64]
  double contrast = 1.0;       ///< of the Gaussian value about its mean, [0, 4]
  /// Of tiling: how many steps of a turn tiles lie in, up to kMostTileRotation; 0 and 1: none.
  std::uint32_t tileRotation = 0;
  /// Of texton noises: the mean number of impacts that a point sees, in kImpactsRange.
  double impacts = 30.0;
  PointProcess pointProcess = PointProcess::stratified;
  MixWeight mix; ///< of a mix of textons
};

/// A noise of a method or a revision that this version does not know. Materials that use it have no
/// noise: they are to be shown with their core textures.
struct IgnoredNoise {
  std::size_t place = 0; ///< among all noises of the file
  std::string name;      ///< may be empty
  std::string method;
  int revision = 0;                   ///< 0 where the file states none
  std::vector<std::size_t> materials; ///< glTF's, in order

  /// Why, such as "revision 3 of tiling; this version knows 1".
  [[nodiscard]] std::string reason() const;
};

/// The extension's content. materials[i] belongs to glTF material i. Noises and tables are numbered
/// without those that are ignored.
struct Bundle {
  std::vector<Table> tables;
  std::vector<Noise> noises;
  std::vector<IgnoredNoise> ignoredNoises;
  std::vector<std::optional<MaterialNoise>> materials;
  std::vector<std::string> materialNames; ///< as many as materials; empty where unnamed
};

/// Bytes of the texels of all tables: what they take on a GPU, without what a driver adds.
[[nodiscard]] std::size_t texelBytes(const Bundle& bundle);

/// Reads the extension from a .glb or .gltf (buffers embedded, in the GLB chunk, or in files beside
/// it inside its folder). Everything that checkBundle() calls an error is refused, badInput, with
/// the first one's message. Never follows a path out of the file's folder. Thread-safe.
[[nodiscard]] Result<Bundle> readBundle(const std::filesystem::path& path);
/// As above from memory: a GLB, or a .gltf whose buffers are data URIs.
[[nodiscard]] Result<Bundle> parseBundle(std::span<const std::byte> file, const std::string& name);

/// One fault of a file, with a stable code such as "noise-index" and a JSON pointer to the place.
struct Finding {
  enum class Severity { error, warning } severity = Severity::error;
  std::string code;
  std::string pointer;
  std::string message;
};

/// Every fault of the extension and its tables that can be told without the exemplar. An Error only
/// when the file cannot be read at all, or is no whole GLB or JSON of glTF 2. Thread-safe.
[[nodiscard]] Result<std::vector<Finding>> checkBundle(const std::filesystem::path& path);
/// As above from memory; what cannot be read at all is a finding too.
[[nodiscard]] std::vector<Finding> checkBundle(std::span<const std::byte> file);

} // namespace lichen
