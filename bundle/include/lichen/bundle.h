// SPDX-License-Identifier: MIT
// The content of a glTF file that uses LICHEN_materials_exemplar_noise: tables, noises, and the
// materials that use them. docs/gltf_extension/README.md specifies the format.
#pragma once

#include <lichen/local_random_phase_map.h>
#include <lichen/multiple_kernels_map.h>
#include <lichen/quilting_map.h>
#include <lichen/result.h>
#include <lichen/table.h>
#include <lichen/texton_map.h>
#include <lichen/tile_corners.h>
#include <lichen/tiling_map.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
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
/// The encoding of stored values; the mean and covariance are in these units. root: the square root
/// of light in [0, 1]; inverse tables hold it too. linear: the quantity itself, in [0, 1]. slope:
/// slopes of normals. log2: log2(1 + quantity), of which inverse tables hold the quantity. srgb:
/// sRGB codes, which only exemplars have; their noises store roots. index: Gaussian values
/// themselves, which evaluators read of index maps; never in a file.
enum class ValueEncoding { root, linear, slope, log2, srgb, index };
enum class Mapping { uv, triplanar, surface, solid };
/// The coordinate space of a mapping that evaluates the noise at 3-D positions: world space, or
/// object space, where the noise moves, rotates and scales with the object.
enum class NoiseSpace { world, object };
/// The synthesis method: tiling and blending [HN18], sparse convolution of a texton [GLM17], local
/// random-phase noise [LRP14], sparse convolution of several kernels [MKN12], or quilting: tiles
/// cut along the outlines of what they show.
enum class Method { tiling, texton, localRandomPhase, multipleKernels, quilting };

/// All methods, in the order of the enumeration.
[[nodiscard]] std::span<const Method> allMethods();
/// The method revision that this version writes and evaluates. Readers ignore noises of later
/// revisions and report others as errors.
[[nodiscard]] int revisionOf(Method method);
/// How a texton noise distributes its impacts: one in each cell of a grid, or as a Poisson
/// process.
enum class PointProcess { stratified, poisson };
/// The source of a mix weight: a constant, a direction in texture coordinates, a texture, or vertex
/// colours.
enum class MixSource { constant, direction, texture, vertexColor };

/// Conversion between enumerators and their JSON names. The ...From functions return nothing for an
/// unknown name.
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

/// Inclusive bounds of a number.
struct NumberRange {
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
};

/// The data of one method: what all maps of a noise share, and what each map has. The alternatives
/// of both variants follow the order of Method.
using MethodNoise = std::variant<TilingNoise, TextonShape, LocalRandomPhaseNoise,
                                 MultipleKernelsNoise, QuiltingNoise>;
using MethodMap =
    std::variant<TilingMap, TextonMap, LocalRandomPhaseMap, MultipleKernelsMap, QuiltingMap>;

/// One map of a noise.
struct NoiseMap {
  MapTarget target = MapTarget::baseColor;
  std::vector<MapChannel> channels; ///< 1 to 3
  ValueEncoding encoding = ValueEncoding::root;
  std::vector<double> mean;       ///< of the exemplar's stored values; n = channels.size() of them
  std::vector<double> covariance; ///< n x n, row-major, symmetric
  MethodMap data;

  /// The map's data. Precondition: Data belongs to the map's method. (std::get would pull an
  /// exception type into the library.)
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

/// The index of the image that the shader fetches for a map, and of the inverse table.
[[nodiscard]] std::size_t imageTableOf(const NoiseMap& map);
[[nodiscard]] std::optional<std::size_t> decodingTableOf(const NoiseMap& map);

/// Calls visit(index) for each table index in a map, const or not.
template <class Map, class Visit>
void visitTables(Map& map, const Visit& visit) {
  std::visit([&](auto& data) { data.visitTables(data, visit); }, map.data);
}

/// One side of a node of a layered noise: another node, or a layer.
struct LayerSide {
  bool isNode = false;
  std::size_t index = 0; ///< in NoiseLayers::nodes, or of the layer

  [[nodiscard]] bool operator==(const LayerSide&) const = default;
};

/// A node of the tree of a layered noise. The first channel of the first map of the noise `index`,
/// as a Gaussian value, is its index map: where that exceeds a threshold lies the side `above`, and
/// elsewhere the side `below`. [MKN12] section 5
struct LayerNode {
  std::size_t index = 0;   ///< in Bundle::noises: not layered, and no mix
  double proportion = 0.5; ///< share of the node's area that is `above`; in kProportionRange
  /// Deviation of the transition, in deviations of the index map; in kSoftnessRange.
  double softness = 0.1;
  LayerSide below, above;

  [[nodiscard]] bool operator==(const LayerNode&) const = default;
};
inline constexpr NumberRange kProportionRange{0.01, 0.99};
inline constexpr NumberRange kSoftnessRange{0.01, 4.0};

/// What makes a noise layered: index maps that choose between the noise itself, its first layer,
/// and up to three others, which have the same targets and channels.
struct NoiseLayers {
  /// Layers 1 and up, in Bundle::noises; none is layered, or a mix.
  std::vector<std::size_t> others;
  std::vector<LayerNode> nodes; ///< as many as `others`; nodes[0] is the root

  [[nodiscard]] bool operator==(const NoiseLayers&) const = default;
};

/// A part of an exemplar that was replaced by another part of it, in pixels of the first map.
struct FilledPlace {
  std::array<std::uint32_t, 4> place{}; ///< column, row, width and height of what was replaced
  std::array<std::uint32_t, 2> from{}; ///< column and row of the part of this size that replaced it

  [[nodiscard]] bool operator==(const FilledPlace&) const = default;
};
inline constexpr std::size_t kMaxFilledPlaces = 16;

/// How the exemplar was made from its files, so that a comparison can make it again. Evaluation
/// does not need it.
struct Preparation {
  /// Column, row, width and height of the part that was used, in pixels of the largest map.
  std::optional<std::array<std::uint32_t, 4>> crop;
  std::optional<std::array<std::uint32_t, 2>> size; ///< to which all maps were resampled
  bool isGreenDown = false;     ///< normals whose files did not say were read as DirectX has them
  bool usesAlpha = false;       ///< the base colour's alpha became the opacity
  std::optional<bool> periodic; ///< whether borders fit, if that was given or measured
  double flattenPeriod = 0.0;   ///< pixels of the first map; 0, or in kFlattenPeriodRange
  std::vector<MapTarget> flattened; ///< the maps that lost their slower variation
  std::vector<FilledPlace> filled;  ///< in order, after flattening; at most kMaxFilledPlaces
  /// The part that was made the tile, after filling; in pixels of the first map, convex.
  std::optional<TileCorners> corners;

  [[nodiscard]] bool operator==(const Preparation&) const = default;
};
/// Periods of the variation that flattening removes, in pixels.
inline constexpr NumberRange kFlattenPeriodRange{4.0, 16384.0};

/// One noise. Its maps share the lattice, hash, seed and weights, or the impacts.
struct Noise {
  std::string name;
  double tileSizeMetres = 1.0; ///< width of one exemplar
  MethodNoise data;
  std::vector<NoiseMap> maps;
  /// The tree of a layered noise, whose members above describe its first layer.
  std::optional<NoiseLayers> layers;
  Preparation preparation; ///< none if several exemplars made it

  [[nodiscard]] Method method() const { return Method(data.index()); }
  /// The noise's data. Precondition: Data belongs to the noise's method.
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

/// The index in noise.maps of the map with this target, or nothing.
[[nodiscard]] std::optional<std::size_t> findMap(const Noise& noise, MapTarget target);

/// Width and height in texels of the exemplar from which a map was baked. All maps of a texton
/// noise report the size of the largest. Precondition: `map` belongs to `noise`, and the bundle
/// contains its image.
[[nodiscard]] std::array<std::uint32_t, 2> exemplarSize(const Bundle& bundle, const Noise& noise,
                                                        const NoiseMap& map);

/// Whether a method supports a mapping. All methods support uv and triplanar; textons and some
/// noises of multiple kernels also surface, and some of multiple kernels and of local random phase
/// solid (mappingObstacle()).
[[nodiscard]] bool mappingFits(Method method, Mapping mapping);
/// The names of those that it supports: "uv, triplanar".
[[nodiscard]] std::string mappingsOf(Method method);

/// Whether a noise is a mix, that is, varies with a mix weight.
[[nodiscard]] bool isMix(const Noise& noise);

/// The noises whose maps a noise shows: itself, and of a layered noise its other layers.
[[nodiscard]] std::vector<std::size_t> layersOf(const Bundle& bundle, std::size_t noise);

/// Calls visit(index) for each noise index in the layers of a noise, const or not.
template <class AnyNoise, class Visit>
void visitLayerNoises(AnyNoise& noise, const Visit& visit) {
  if (!noise.layers)
    return;
  for (auto& layer : noise.layers->others)
    visit(layer);
  for (auto& node : noise.layers->nodes)
    visit(node.index);
}

/// Whether a mapping evaluates the noise at 3-D positions rather than texture coordinates.
[[nodiscard]] bool isInSpace(Mapping mapping);

/// Range of Noise::tileSizeMetres, as in the format's schema.
inline constexpr NumberRange kTileSizeRange{1e-6, 1e6};

/// Ranges of the material parameters, as in the format's schema.
inline constexpr NumberRange kScaleRange{1e-6, 1e6};
inline constexpr NumberRange kOffsetRange{-1e9, 1e9};
inline constexpr NumberRange kRotationRange{-1e6, 1e6};
inline constexpr NumberRange kBlendSharpnessRange{0.25, 16.0};
inline constexpr NumberRange kPlaneSharpnessRange{1.0, 64.0};
inline constexpr NumberRange kContrastRange{0.0, 4.0};
inline constexpr NumberRange kImpactsRange{1.0, 1000.0};
inline constexpr NumberRange kMixWeightRange{0.0, 1.0};
/// The values of MaterialNoise::tileRotation, for messages; takesTileRotation() checks one.
inline constexpr std::string_view kTileRotations = "0, 1, 2, or 4 if tiles are square";
inline constexpr NumberRange kMixPlaceRange{-1e6, 1e6};
/// Minimum distance between MixWeight::start and end, in texture coordinates: a sixtieth of a texel
/// of the widest exemplar. The weight is divided by the squared distance, which underflows to 0 for
/// a distance of 1e-170.
inline constexpr double kLeastMixLength = 1e-6;

/// How a material computes the mix weight at a point. Weight 0 selects the first step and 1 the
/// last; the weight is clamped to [0, 1].
struct MixWeight {
  MixSource source = MixSource::constant;
  double weight = 0.0; ///< for MixSource::constant; in kMixWeightRange
  /// For MixSource::direction: the texture coordinates, in the noise's set, where the weight is 0
  /// and 1. Other points are projected onto the line through the two. Both are in kMixPlaceRange
  /// and at least kLeastMixLength apart.
  std::array<double, 2> start{0.0, 0.0};
  std::array<double, 2> end{0.0, 1.0};
  std::size_t texture = 0; ///< for MixSource::texture: glTF texture index; stored values, undecoded
  int texCoord = 0;        ///< texture coordinate set of the texture, [0, 15]
  int colorSet = 0;        ///< for MixSource::vertexColor: the n of COLOR_n, [0, 15]
  int channel = 0;         ///< for texture and vertexColor: 0 (red) to 3 (alpha)

  [[nodiscard]] bool operator==(const MixWeight&) const = default;
};

/// How a material uses a noise: all parameters that can change without a new bake.
struct MaterialNoise {
  std::size_t noise = 0;
  Mapping mapping = Mapping::uv;
  NoiseSpace space = NoiseSpace::world; ///< always world where isInSpace(mapping) is false
  int texCoord = 0;
  /// Tile coordinate = offset + R(rotation) uv / scale, with the rotation of KHR_texture_transform:
  /// x' = cos x + sin y, y' = -sin x + cos y. One unit of tile space is one exemplar.
  double scale = 1.0;                     ///< texture-coordinate units that one exemplar spans, > 0
  std::array<double, 2> offset{0.0, 0.0}; ///< tiles
  double rotation = 0.0;                  ///< radians
  std::uint32_t seed = 1;
  double blendSharpness = 1.0; ///< exponent of the blend weights, [0.25, 16]
  double planeSharpness = 8.0; ///< triplanar only: exponent of the plane weights, [1, 64]
  double contrast = 1.0;       ///< factor on the Gaussian value about its mean, [0, 4]
  /// Tiling only: the number of angles that tiles take: 2 (half turns) or, of square tiles, 4
  /// (quarter turns). 0 and 1 leave tiles unrotated.
  std::uint32_t tileRotation = 0;
  /// Texton only: the mean number of impacts that cover a point, in kImpactsRange.
  double impacts = 30.0;
  PointProcess pointProcess = PointProcess::stratified;
  MixWeight mix; ///< only for a mix of textons
};

/// A noise of an unknown method or a later revision than this version supports. Renderers show the
/// materials that use it with their core glTF textures.
struct IgnoredNoise {
  std::size_t place = 0; ///< index among all noises of the file
  std::string name;      ///< may be empty
  std::string method;
  int revision = 0;                   ///< 0 if the file states none
  std::vector<std::size_t> materials; ///< glTF material indices, ascending

  /// The reason for a message, such as "revision 3 of tiling; this version knows 1".
  [[nodiscard]] std::string reason() const;
};

/// The extension's content. materials[i] belongs to glTF material i. Noises and tables are numbered
/// without the ignored ones.
struct Bundle {
  std::vector<Table> tables;
  std::vector<Noise> noises;
  std::vector<IgnoredNoise> ignoredNoises;
  std::vector<std::optional<MaterialNoise>> materials;
  std::vector<std::string> materialNames; ///< as many as materials; empty if unnamed
};

/// Total bytes of the texels of all tables: their GPU memory, without driver overhead.
[[nodiscard]] std::size_t texelBytes(const Bundle& bundle);

/// Supplies a file that a .gltf names: its first `length` bytes, or an Error, whose message becomes
/// the finding's. Fewer bytes are a fault of the .gltf too; further bytes are ignored. `uri` is
/// relative, as the .gltf has it. pathOfUri() decodes it to a path, which the function must refuse
/// if it leaves the folder that it may read: the reader does not check that. May throw
/// std::bad_alloc only.
using ExternalFile =
    std::function<Result<std::vector<std::byte>>(const std::string& uri, std::size_t length)>;

/// Decodes the %XX escapes of a relative URI to a path. Returns nothing for a URI with a scheme
/// (such as data:), a malformed escape or a NUL. Throws std::bad_alloc.
[[nodiscard]] std::optional<std::string> pathOfUri(const std::string& uri);

/// Reads the extension from the bytes of a .glb or .gltf. Buffers may be in the GLB chunk, in data
/// URIs, or in files that `externalFile` supplies; without it, a buffer in a file is an error.
/// Messages begin with `name`. Errors: badInput, with the first error that checkBundle() reports;
/// resources when memory does not suffice. Thread-safe.
[[nodiscard]] Result<Bundle> parseBundle(std::span<const std::byte> file, const std::string& name,
                                         const ExternalFile& externalFile = {});

/// One fault of a file, with a stable code such as "noise-index" and a JSON pointer to its
/// location.
struct Finding {
  enum class Severity { error, warning } severity = Severity::error;
  std::string code;
  std::string pointer;
  std::string message;
};

/// Reports every fault of the extension and its tables that can be detected without the exemplar.
/// An unreadable file is one too. Reads as parseBundle() does. Thread-safe.
[[nodiscard]] std::vector<Finding> checkBundle(std::span<const std::byte> file,
                                               const ExternalFile& externalFile = {});

} // namespace lichen
