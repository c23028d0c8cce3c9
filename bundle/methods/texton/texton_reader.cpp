// SPDX-License-Identifier: MIT
// Reads the texton members of a noise: the shape that its textons share, and each map's texton. n
// is the number of a map's channels.
#include "methods/method_reader.h"
#include "methods/noise_members.h"

#include <lichen/counted.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

using nlohmann::json;

/// Whether the shape was invalid; readNoise() then returns a default shape.
bool isUnknown(const TextonShape& shape) { return shape.coefficientsX == 0; }

int readOrder(ObjectReader& reader) {
  constexpr std::uint64_t kCubic = 3;
  const auto order = reader.integer("order", kCubic);
  if (order == 2u)
    reader.error("range", "order", "2; expected 0, 1 or 3");
  return int(order.value_or(1));
}

/// Checks the numbers of coefficients, mip levels and steps against one another and against the
/// exemplar's size.
void checkShape(ObjectReader& reader, const TextonShape& shape) {
  const auto sides = [](int x, int y) { return std::to_string(x) + " x " + std::to_string(y); };
  const std::string coefficients = sides(shape.coefficientsX, shape.coefficientsY);
  if (shape.coefficientsX > shape.texelsPerTileX || shape.coefficientsY > shape.texelsPerTileY)
    return reader.error("texton-coefficients", "coefficients",
                        coefficients + "; expected at most the exemplar's, " +
                            sides(shape.texelsPerTileX, shape.texelsPerTileY) + " texels");
  if (shape.mipLevels > shape.mostMipLevels())
    return reader.error("texton-mip-levels", "mipLevels",
                        std::to_string(shape.mipLevels) + "; expected 1 to " +
                            std::to_string(shape.mostMipLevels()) + " for " + coefficients +
                            " coefficients");
  const std::uint32_t most = kMaxTableSide / shape.frameHeight();
  if (std::uint32_t(shape.steps) > most)
    reader.error("texton-steps", "steps",
                 std::to_string(shape.steps) + "; expected 1 to " + std::to_string(most) +
                     " for frames of " + std::to_string(shape.frameHeight()) + " rows");
}

/// Checks that an image has the size, mip levels and format of textons with this shape and n
/// channels.
bool checkImage(ObjectReader& reader, const TextonShape& shape, std::size_t n, const Table& image) {
  const auto error = [&](const std::string& message) {
    reader.error("map-texton", "texton", message);
    return false;
  };
  const std::uint32_t width = shape.frameWidth();
  const std::uint32_t height = shape.frameHeight() * std::uint32_t(shape.steps);
  if (image.depth != 0 || image.width != width || image.height != height)
    return error(shapeOf(image) + " texels; expected " + std::to_string(width) + " x " +
                 std::to_string(height) + " for its noise's texton");
  if (image.mipLevels != std::uint32_t(shape.mipLevels))
    return error(counted(image.mipLevels, "mip level") + "; expected the noise's " +
                 std::to_string(shape.mipLevels));
  if (texelBytes(image.format) == std::size_t(channelCount(image.format)))
    return error("8-bit texels; expected a float format");
  if (usedChannels(image.format) < n)
    return error(counted(usedChannels(image.format), "channel") +
                 "; expected at least the map's, " + std::to_string(n));
  return true;
}

/// One value per channel, or an empty vector on a fault.
std::vector<double> readPerChannel(ObjectReader& reader, const char* key, const char* code,
                                   NumberRange range, std::size_t n) {
  const auto values = reader.numbers(key, range);
  if (values && n != 0 && values->size() != n)
    reader.error(code, key,
                 counted(values->size(), "value") + "; expected " + std::to_string(n) +
                     ", one per channel");
  return values.value_or(std::vector<double>());
}

/// Reads the steps after the first. `texton` already has the first step's mipLoss.
void readLaterSteps(ObjectReader& reader, const TextonShape& shape, const NoiseMap& map,
                    FindingList& findings, TextonMap& texton) {
  constexpr const char* kCode = "map-later-steps";
  constexpr const char* kKey = "laterSteps";
  if (!reader.has(kKey) && shape.steps > 1)
    reader.error(kCode, kKey, "absent; expected the steps after the first");
  if (!reader.has(kKey))
    return;
  const json* list = reader.array(kKey, kMaxTextonSteps);
  if (list == nullptr || isUnknown(shape))
    return;
  const std::size_t later = std::size_t(shape.steps) - 1;
  if (list->size() != later)
    return reader.error(kCode, kKey,
                        counted(list->size(), "element") + "; expected " + std::to_string(later) +
                            ", one for each step after the first");
  for (std::size_t k = 0; k < later; ++k) {
    ObjectReader step((*list)[k], reader.pointerTo(kKey) + "/" + std::to_string(k), findings);
    const std::size_t n = map.channels.size();
    MapMoments moments = readMoments(step, map.encoding, n);
    texton.laterSteps.push_back(
        {std::move(moments.mean), std::move(moments.covariance), readLosses(step, n)});
    step.warnOfUnknown();
    const std::size_t losses = texton.laterSteps.back().mipLoss.size();
    if (losses != 0 && losses != texton.mipLoss.size())
      step.error("map-mip-loss", "mipLoss",
                 counted(losses, "value") + "; expected " + std::to_string(texton.mipLoss.size()) +
                     ", as many as in the first step");
  }
}

/// Checks that each scale is six times its channel's standard deviation, in a mix the largest of
/// all steps.
void checkScale(ObjectReader& reader, const NoiseMap& map, const TextonMap& texton) {
  constexpr double kDeviations = 6.0;
  constexpr double kTextRounding = 1e-6; // of a number written with about seven digits
  const std::size_t n = map.channels.size();
  for (std::size_t c = 0; c < n; ++c) {
    double variance = map.covariance[c * n + c];
    for (const TextonStep& step : texton.laterSteps)
      variance = std::max(variance, step.covariance[c * n + c]);
    const double wanted = kDeviations * std::sqrt(std::max(variance, 0.0));
    if (std::abs(texton.scale[c] - wanted) > kTextRounding * wanted)
      return reader.error("texton-scale", "scale",
                          json(texton.scale[c]).dump() + " at " + std::to_string(c) +
                              "; expected six times the deviation, " + json(wanted).dump());
  }
}

/// Checks that no texel is so large that the shader's sum of impacts could become infinite. The
/// variance of the noise is at most 1/36, and at least the square of a texel times the least
/// eigenvalue of the kernel's autocorrelation, which is 0.054^2 for order 3: so 3.1 is the largest
/// texel that agrees with its scale. [GLM17] section 4.1.
void checkTexels(ObjectReader& reader, const Table& image) {
  constexpr float kLargestTexel = 4.0f;
  for (std::uint32_t level = 0; level < image.mipLevels; ++level)
    for (const float texel : decodeLevel(image, level))
      if (std::abs(texel) > kLargestTexel)
        return reader.error("texton-texels", "texton",
                            "a texel of " + json(double(texel)).dump() + "; expected -4 to 4");
}

MethodNoise readNoise(ObjectReader& noise, FindingList& findings) {
  const std::size_t errorsBefore = findings.errorCount();
  const json* member = noise.required("texton");
  if (member == nullptr)
    return TextonShape();
  ObjectReader reader(*member, noise.pointerTo("texton"), findings);
  const auto coefficients = readSize(reader, "coefficients", kMaxTextonSide);
  const auto tile = readSize(reader, "texelsPerTile", int(kMaxTableSide));
  TextonShape shape;
  shape.order = readOrder(reader);
  shape.mipLevels = int(reader.integer("mipLevels", kMaxTextonMips, "range", 1).value_or(1));
  shape.steps = reader.integerOr("steps", kMaxTextonSteps, 1, 1);
  reader.warnOfUnknown();
  if (findings.errorCount() > errorsBefore || !coefficients || !tile)
    return TextonShape();
  shape.coefficientsX = (*coefficients)[0];
  shape.coefficientsY = (*coefficients)[1];
  shape.texelsPerTileX = (*tile)[0];
  shape.texelsPerTileY = (*tile)[1];
  checkShape(reader, shape);
  return findings.errorCount() > errorsBefore ? TextonShape() : shape;
}

MethodMap readMap(ObjectReader& reader, const Noise& noise, const NoiseMap& map,
                  const Tables& tables, FindingList& findings) {
  constexpr NumberRange kScales{0.0, 1e6};
  const auto& shape = noise.as<TextonShape>();
  const std::size_t n = map.channels.size();
  TextonMap texton;
  texton.mipLoss = readLosses(reader, n);
  texton.scale = readPerChannel(reader, "scale", "map-scale", kScales, n);
  readLaterSteps(reader, shape, map, findings, texton);
  const Table* image = readTableIndex(reader, "texton", "map-texton-index", tables, texton.image);
  if (isUnknown(shape))
    return texton;
  const std::size_t losses = texton.mipLoss.size();
  if (losses != 0 && n != 0 &&
      (losses % n != 0 || losses < n * std::size_t(shape.mipLevels) ||
       losses > n * kMaxTextonLosses))
    reader.error("map-mip-loss", "mipLoss",
                 counted(losses, "value") + "; expected as many for each of " +
                     counted(n, "channel") + ", " + std::to_string(shape.mipLevels) + " to " +
                     std::to_string(kMaxTextonLosses) + " each");
  const auto fits = [n](const std::vector<double>& covariance) {
    return n != 0 && covariance.size() == n * n;
  };
  const bool statisticsFit =
      fits(map.covariance) && texton.scale.size() == n &&
      texton.laterSteps.size() + 1 == std::size_t(shape.steps) &&
      std::all_of(texton.laterSteps.begin(), texton.laterSteps.end(),
                  [&](const TextonStep& step) { return fits(step.covariance); });
  if (image != nullptr && checkImage(reader, shape, n, *image))
    checkTexels(reader, *image);
  if (statisticsFit)
    checkScale(reader, map, texton);
  return texton;
}

constexpr std::array<std::string_view, 1> kTableMembers{"texton"};

} // namespace

extern const MethodReader kTextonReader{.name = "texton",
                                        .revision = 1,
                                        .tableMembers = kTableMembers,
                                        .readNoise = readNoise,
                                        .readMap = readMap};

} // namespace lichen
