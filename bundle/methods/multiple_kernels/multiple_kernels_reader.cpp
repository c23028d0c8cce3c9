// SPDX-License-Identifier: MIT
// Reads the members of a multiple-kernels noise: what its kernels share, and each map's image.
#include "methods/inverse_table_reader.h"
#include "methods/method_reader.h"
#include "methods/noise_members.h"

#include <lichen/counted.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

using nlohmann::json;

constexpr const char* kMember = "multipleKernels";

/// Whether the members that the maps share were faulty.
bool isUnknown(const MultipleKernelsNoise& shared) { return shared.texelsPerTileX == 0; }

std::optional<KernelWindow> readWindow(ObjectReader& reader) {
  const std::optional<std::string> name = reader.text("window");
  if (!name)
    return std::nullopt;
  const std::optional<KernelWindow> window = kernelWindowFrom(*name);
  if (!window)
    reader.error("kernels-window", "window",
                 quoted(*name) + "; expected gabor, sinc or gaussian-sinc");
  return window;
}

/// How much a shader visits for a kernel.
struct KernelCost {
  double impacts = 0.0; ///< that reach a point, of the mapping that has the most
  double reach = 0.0;   ///< of the support along any axis of a grid [cells]
};

KernelCost costOf(const float* own, const MultipleKernelsNoise& shared) {
  const std::array<double, 4> q{own[4], own[5], own[6], own[7]};
  const double determinant = std::abs(q[0] * q[3] - q[1] * q[2]);
  const double aspect = double(shared.texelsPerTileX) / shared.texelsPerTileY;
  const double x = std::hypot(q[1], q[3]) / determinant, y = std::hypot(q[0], q[2]) / determinant;
  const double area = (shared.window == KernelWindow::gabor ? std::numbers::pi : 4.0) / determinant;
  const auto perTile = [&](std::size_t column) { return double(own[column]) / kKernelTiles; };
  const double inPlane = area * perTile(2) * perTile(3);
  const double onSurface = std::pow(area / aspect, 1.5) * std::pow(perTile(9), 3.0);
  const double inSolid = inPlane * perTile(10) / double(own[11]); // within a factor of 4 / 3
  const double longest = std::hypot(x, y / aspect);               // [tile widths], at most
  return {std::max({inPlane, onSurface, inSolid}),
          std::max({x * perTile(2), y * perTile(3), longest * perTile(9),
                    perTile(10) / double(own[11])})};
}

/// Checks the numbers, beyond which cells could not be counted and values could be infinite.
void checkTexels(ObjectReader& reader, const MultipleKernelsNoise& shared, const Table& image) {
  const std::vector<float> texels = decodeLevel(image, 0);
  const auto error = [&](std::size_t kernel, const std::string& message) {
    reader.error("kernels-texels", "kernels", "kernel " + std::to_string(kernel) + ": " + message);
  };
  const auto isWithin = [](float value, float most) { return std::abs(value) <= most; };
  double impacts = 0.0; // of all kernels
  for (std::size_t k = 0; k < std::size_t(shared.kernels); ++k) {
    const float* own = &texels[4 * kKernelTexels * k];
    if (!isWithin(own[0], kMostKernelFrequency) || !isWithin(own[1], kMostKernelFrequency))
      return error(k, "a frequency beyond -" + json(kMostKernelFrequency).dump() + " to " +
                          json(kMostKernelFrequency).dump());
    for (const float cells : {own[2], own[3], own[9], own[10]})
      if (!(cells >= 1.0f && cells <= float(kMostKernelCells)) || cells != std::floor(cells))
        return error(k, json(double(cells)).dump() +
                            " columns, rows, cubes or layers; expected a whole number from 1 to " +
                            std::to_string(kMostKernelCells));
    const float* window = own + 4;
    if (!std::all_of(window, window + 4, [&](float v) { return isWithin(v, kMostToWindow); }) ||
        !(std::abs(window[0] * window[3] - window[1] * window[2]) >= kLeastKernelDeterminant))
      return error(k, "a matrix without an inverse, or with numbers beyond -" +
                          json(kMostToWindow).dump() + " to " + json(kMostToWindow).dump());
    if (!(own[11] >= kLeastToWindowZ && own[11] <= kMostToWindow))
      return error(k, json(double(own[11])).dump() + " along z; expected " +
                          json(kLeastToWindowZ).dump() + " to " + json(kMostToWindow).dump());
    const KernelCost cost = costOf(own, shared);
    impacts += cost.impacts;
    if (impacts > kMostKernelImpacts || cost.reach > kMostKernelReach)
      return error(k, "more impacts, or a support of more cells, than a shader could visit");
    const bool isOnSquare = shared.window != KernelWindow::gabor;
    if (isOnSquare && (window[1] != 0.0f || window[2] != 0.0f))
      return error(k, "a matrix that is not diagonal, which only gabor may have");
    const bool isRing = int(k) >= shared.kernels - shared.rings;
    if (isRing && own[1] != 0.0f)
      return error(k, "a ring whose frequency along y is not 0");
    const auto isValue = [&](float v) { return isWithin(v, kMostKernelValue); };
    if (!isValue(own[8]) || !std::all_of(own + 12, own + 4 * kKernelTexels, isValue))
      return error(k, "an amplitude or colour beyond -" + json(kMostKernelValue).dump() + " to " +
                          json(kMostKernelValue).dump());
  }
  const std::vector<PatternCosine> pattern = patternCosines(image, shared);
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    const std::string name = "cosine " + std::to_string(k) + " of the pattern: ";
    for (const float cycles : pattern[k].frequency)
      if (!isWithin(cycles, kMostKernelFrequency) || cycles != std::floor(cycles))
        return reader.error("kernels-texels", "kernels",
                            name + "a frequency of " + json(double(cycles)).dump() +
                                "; expected a whole number from -" +
                                json(kMostKernelFrequency).dump() + " to " +
                                json(kMostKernelFrequency).dump());
    for (const std::array<float, 2>& wave : pattern[k].waves)
      for (const float amplitude : wave)
        if (!isWithin(amplitude, kMostKernelValue))
          return reader.error("kernels-texels", "kernels",
                              name + "an amplitude beyond -" + json(kMostKernelValue).dump() +
                                  " to " + json(kMostKernelValue).dump());
  }
}

void checkImage(ObjectReader& reader, const MultipleKernelsNoise& shared, const Table& image) {
  const auto error = [&](const std::string& message) {
    reader.error("map-kernels", "kernels", message);
  };
  if (image.depth != 0 || image.width != kKernelTexels ||
      image.height != std::uint32_t(shared.kernels) + patternRows(shared.cosines))
    return error(shapeOf(image) + " texels; expected " + std::to_string(kKernelTexels) + " x " +
                 std::to_string(std::uint32_t(shared.kernels) + patternRows(shared.cosines)) +
                 " for its noise's kernels and pattern");
  if (image.mipLevels != 1)
    return error(counted(image.mipLevels, "mip level") + "; expected 1");
  if (image.format != TexelFormat::rgba32Sfloat)
    return error("texels of another format; expected RGBA32F");
  checkTexels(reader, shared, image);
}

MethodNoise readNoise(ObjectReader& reader, FindingList& findings) {
  const json* value = reader.required(kMember);
  if (value == nullptr)
    return MultipleKernelsNoise();
  ObjectReader member(*value, reader.pointerTo(kMember), findings);
  const auto texels = readSize(member, "texelsPerTile", kMaxTableSide);
  const auto kernels = member.integer("kernels", kMostKernels, "range", 1);
  const int rings = member.integerOr("rings", kMostKernels, 0);
  const int cosines = member.integerOr("cosines", kMostPatternCosines, 0);
  const std::optional<KernelWindow> window = readWindow(member);
  const std::optional<bool> isGiven = readGivenSpectrum(member);
  member.warnOfUnknown();
  if (!texels || !kernels || !window || !isGiven)
    return MultipleKernelsNoise();
  if (rings > int(*kernels)) {
    member.error("kernels-rings", "rings",
                 std::to_string(rings) + "; expected at most the number of kernels");
    return MultipleKernelsNoise();
  }
  return MultipleKernelsNoise{(*texels)[0], (*texels)[1], int(*kernels), rings,
                              cosines,      *window,      *isGiven};
}

MethodMap readMap(ObjectReader& reader, const Noise& noise, const NoiseMap& map,
                  const Tables& tables, FindingList&) {
  MultipleKernelsMap own;
  const InverseTableMembers inverse = readInverseTable(reader, map, tables);
  own.dimensions = inverse.dimensions;
  own.inverseTable = inverse.table;
  const Table* image = readTableIndex(reader, "kernels", "map-kernels-index", tables, own.kernels);
  const auto& shared = noise.as<MultipleKernelsNoise>();
  if (image != nullptr && !isUnknown(shared))
    checkImage(reader, shared, *image);
  return own;
}

constexpr std::array<std::string_view, 2> kTableMembers{"kernels", "inverseTable"};

} // namespace

extern const MethodReader kMultipleKernelsReader{.name = "multiple-kernels",
                                                 .revision = 1,
                                                 .tableMembers = kTableMembers,
                                                 .readNoise = readNoise,
                                                 .readMap = readMap};

} // namespace lichen
