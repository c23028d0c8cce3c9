// SPDX-License-Identifier: MIT
// What a glTF file with LICHEN_materials_exemplar_noise holds: tables, noises, and the materials
// that use them. docs/gltf_extension/README.md is the format's specification.
#pragma once

#include <lichen/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

inline constexpr std::string_view kExtensionName = "LICHEN_materials_exemplar_noise";

/// The revision of each method that this version writes and evaluates. It ignores noises of later
/// ones.
inline constexpr int kNoiseRevision = 1;

enum class TexelFormat {
  r8Unorm,
  rg8Unorm,
  rgba8Unorm,
  rgba8Srgb,
  r16Sfloat,
  rg16Sfloat,
  rgba16Sfloat,
  r32Sfloat,
  rgba32Sfloat,
};

/// The largest value of a 16-bit texel; larger ones are stored as it.
inline constexpr float kHalfMax = 65504.0f;

/// Texels of a table's longest side.
inline constexpr std::uint32_t kMaxTableSide = 16384;

/// Bytes of one texel, and how many channels it has.
[[nodiscard]] std::size_t texelBytes(TexelFormat format);
[[nodiscard]] int channelCount(TexelFormat format);

/// An uncompressed 2-D texture with mips, or a 3-D texture without: the content of one KTX2 file.
/// Level l has max(1, width >> l) x max(1, height >> l) texels, rows top first, z slowest, tightly
/// packed; levels follow one another from 0 in `texels`.
struct Table {
  std::string name;
  TexelFormat format = TexelFormat::rgba8Unorm;
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t depth = 0;     ///< 0 for a 2-D texture
  std::uint32_t mipLevels = 1; ///< 1 when 3-D
  std::vector<std::byte> texels;
};

/// Offset and size in bytes of one mip level inside Table::texels. `level` < mipLevels.
struct LevelRange {
  std::size_t offset = 0;
  std::size_t size = 0;
};
[[nodiscard]] LevelRange levelRange(const Table& table, std::uint32_t level);

/// One mip level as floats, channelCount interleaved, sRGB decoded to light. Throws std::bad_alloc.
[[nodiscard]] std::vector<float> decodeLevel(const Table& table, std::uint32_t level);
/// Appends float texels, channelCount(format) interleaved, rounded to nearest into `format`; sRGB
/// formats are given light and store its code. Throws std::bad_alloc.
void appendTexels(std::vector<std::byte>& texels, TexelFormat format,
                  std::span<const float> values);

/// KTX2 of a table (throws std::bad_alloc), and back. `name`, of messages, becomes Table::name.
[[nodiscard]] std::vector<std::byte> encodeKtx2(const Table& table);
[[nodiscard]] Result<Table> decodeKtx2(std::span<const std::byte> file, const std::string& name);

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

/// Of an exemplar's stored values, or of one step of a mix of textons; members as NoiseMap's.
struct MapStatistics {
  std::vector<double> mean;
  std::vector<double> covariance;
  std::vector<double> mipLoss;
};

/// One map of a noise.
///
/// Of a texton noise: `image` is the texton's (TextonShape says where its coefficients lie), of a
/// float format with a colour channel for each of the map's, and the stored value is mean + scale x
/// the sum over impacts.
///
/// Of a tiling noise: `image` is the Gaussian image. It has D = 1, 2 or 3 colour channels
/// (R8/R16F/R32F, RG.., RGBA.. with alpha unused), D being the dimension of the affine space that
/// the exemplar's values span: a grey photograph stored as RGB has D = 1 and three `channels`. The
/// inverse table maps [0, 1]^D to the channels, as L slabs: D = 1: 2-D, 256 x L; D = 2: 2-D, 64 x
/// 64 L; D = 3: 3-D, 32 x 32 x 32 L. Slab k is prefiltered for the lost variance levels[k] = 1 - (1
/// - k / (L - 1))^2, in units of the full variance: kept amplitude falls linearly from slab 0
/// (nothing lost) to L - 1 (constant).
struct NoiseMap {
  MapTarget target = MapTarget::baseColor;
  std::vector<MapChannel> channels; ///< 1 to 3
  ValueEncoding encoding = ValueEncoding::srgb;
  std::vector<double> mean;                ///< n = channels.size() values
  std::vector<double> covariance;          ///< n x n, row-major, symmetric
  std::size_t image = 0;                   ///< index into Bundle::tables
  std::optional<std::size_t> inverseTable; ///< absent for an exemplar that is Gaussian already
  std::vector<double> levels;              ///< L >= 2 values from 0 to 1; empty without a table
  /// Of a separable table: decoded = tableOffset + tableBasis t, t one value an axis; n x D values,
  /// row-major, and n. Empty for a joint table and without a table.
  std::vector<double> tableBasis;
  std::vector<double> tableOffset;
  /// Of a texton noise: a factor >= 0 for each channel, six times its deviation, of a mix its
  /// greatest. Empty otherwise.
  std::vector<double> scale;
  /// Share of the variance that each mip level of the image has lost; in [0, 1], from 0, not
  /// decreasing. Of a Gaussian image the mean over its channels, one value a mip level. Of a texton
  /// n rows, a row a channel, of a value a mip level and up to kMaxTextonLosses: the others are of
  /// the box averages beyond the last mip.
  std::vector<double> mipLoss;
  /// Of a mix, whose first step mean, covariance and mipLoss are of, the others in order:
  /// TextonShape::steps - 1. Empty otherwise.
  std::vector<MapStatistics> laterSteps;
};

/// Levels of averaging for which the losses of a texton's channel are known.
inline constexpr std::size_t kMaxTextonLosses = 16;

/// One of the rows of a mipLoss; `row` below `rows`, of which it has a whole number.
[[nodiscard]] std::span<const double> lossRow(std::span<const double> mipLoss, std::size_t row,
                                              std::size_t rows);

/// How a map's Gaussian values become its own: one table over all dimensions, one for each, or the
/// affine map of its mean and covariance.
enum class TableKind { joint, separable, none };
[[nodiscard]] TableKind tableKindOf(const NoiseMap& map);
/// "joint", "separable" or "none".
[[nodiscard]] std::string_view nameOf(TableKind kind);

/// What all textons of a noise have in common.
///
/// Their coefficients are the top left part of a frame of frameWidth() x frameHeight() texels,
/// which is zero elsewhere: half a texel of the last mip on all sides, as the image repeats. An
/// image is `steps` frames, one above the other, together at most kMaxTableSide high.
struct TextonShape {
  int coefficientsX = 0;  ///< [1, kMaxTextonSide], at most the exemplar's texels
  int coefficientsY = 0;  ///< likewise
  int order = 1;          ///< of the B-spline between coefficients: 0, 1 or 3
  int mipLevels = 1;      ///< of the images, [1, mostMipLevels()]
  int texelsPerTileX = 0; ///< size of the exemplar, [1, kMaxTableSide]
  int texelsPerTileY = 0; ///< likewise
  int steps = 1;          ///< of a mix, textons from its first exemplar to the last; otherwise 1

  /// As many as keep four texels of the last mip, 2^(mipLevels - 1) coefficients wide, inside the
  /// texton: wider ones would reach far beyond it and make a pixel pay for impacts that it hardly
  /// sees.
  [[nodiscard]] int mostMipLevels() const;

  /// Texels of a frame: whole texels of the last mip, and one more.
  [[nodiscard]] std::uint32_t frameWidth() const;
  [[nodiscard]] std::uint32_t frameHeight() const;
};
inline constexpr int kMaxTextonSide = 1024;
inline constexpr int kMaxTextonMips = 9; ///< mostMipLevels() of the largest texton
inline constexpr int kMaxTextonSteps = 64;

/// One noise: maps that share lattice, hash, seed and weights, or impacts.
struct Noise {
  std::string name;
  Method method = Method::tiling;
  int revision = kNoiseRevision;
  double tileSizeMetres = 1.0; ///< width of one exemplar
  TextonShape texton;          ///< of Method::texton
  std::vector<NoiseMap> maps;
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

/// A noise of a revision that this version does not know. Materials that use it have no noise: they
/// are to be shown with their core textures.
struct IgnoredNoise {
  std::size_t place = 0; ///< among all noises of the file
  std::string name;      ///< may be empty
  int revision = 0;
  std::vector<std::size_t> materials; ///< glTF's, in order
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
