// SPDX-License-Identifier: MIT
// The checker on a texton's texels: no fault in valid texels of every kind, and the fault's name
// for texels that contradict their map.
#include "bundle_faults.h"
#include "synthetic_texton.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace lichen;
using example::GlbParts;
using test::SyntheticTexton;

namespace {

constexpr SyntheticTexton kTexton; // 21 x 18 coefficients of three channels in frames of 28 x 24

const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = test::syntheticTextonGlb(kTexton);
  return file;
}

const Table& soundTable() {
  static const Table table = parseBundle(soundFile(), "sound.glb").value().tables[0];
  return table;
}

std::vector<float> levelOf(std::uint32_t level) { return decodeLevel(soundTable(), level); }

/// Overwrites the texels of a level.
void setLevel(GlbParts& parts, std::uint32_t level, const std::vector<float>& values) {
  constexpr std::size_t kLevelIndex = 80, kLevelEntry = 24; // of a KTX2 file
  std::vector<std::byte> texels;
  appendTexels(texels, soundTable().format, values);
  const std::size_t file = parts.tableOffset(0);
  const std::uint32_t begin =
      GlbParts::word(parts.binary, file + kLevelIndex + kLevelEntry * level);
  std::copy(texels.begin(), texels.end(), parts.binary.begin() + std::ptrdiff_t(file + begin));
}

/// Offset of the component of a channel at (x, y) of a level.
std::size_t placeOf(std::uint32_t level, int x, int y, int channel) {
  const auto width = int(soundTable().width >> level);
  return std::size_t((y * width + x) * channelCount(soundTable().format) + channel);
}

float texel(std::uint32_t level, int x, int y, int channel) {
  return levelOf(level)[placeOf(level, x, y, channel)];
}

/// Replaces one component.
void setTexel(GlbParts& parts, std::uint32_t level, int x, int y, int channel, float value) {
  std::vector<float> values = levelOf(level);
  values[placeOf(level, x, y, channel)] = value;
  setLevel(parts, level, values);
}

/// Multiplies one channel in all levels.
void scaleChannel(GlbParts& parts, int channel, float factor) {
  for (std::uint32_t level = 0; level < soundTable().mipLevels; ++level) {
    std::vector<float> values = levelOf(level);
    for (std::size_t i = std::size_t(channel); i < values.size();
         i += std::size_t(channelCount(soundTable().format)))
      values[i] *= factor;
    setLevel(parts, level, values);
  }
}

} // namespace

TEST_CASE("sound textons of every order, size and format have no fault") {
  for (const int order : {0, 1, 3})
    for (const int channels : {1, 2, 3})
      for (const bool wholeFloats : {false, true}) {
        INFO("order " << order << ", " << channels << " channels");
        SyntheticTexton texton = kTexton;
        texton.order = order;
        texton.channels = channels;
        texton.wholeFloats = wholeFloats;
        CHECK(checkBundle(test::syntheticTextonGlb(texton)).empty());
        texton.smoothings = 4;
        CHECK(checkBundle(test::syntheticTextonGlb(texton)).empty());
        texton.coefficientsX = 1;
        texton.mipLevels = 1;
        CHECK(checkBundle(test::syntheticTextonGlb(texton)).empty());
        texton.steps = 4;
        CHECK(checkBundle(test::syntheticTextonGlb(texton)).empty());
      }
}

TEST_CASE("texels that are not what the map says of them are found") {
  example::checkFaults(
      soundFile(),
      {
          {"a texel right of the coefficients", "texton-border",
           [](GlbParts& p) { setTexel(p, 0, 21, 0, 0, 0x1p-10f); }},
          {"a texel below them", "texton-border",
           [](GlbParts& p) { setTexel(p, 0, 0, 18, 2, -0x1p-24f); }},
          {"the frame's last texel", "texton-border",
           [](GlbParts& p) { setTexel(p, 0, 27, 23, 1, 0.5f); }},
          {"a mip's texel that is no average", "texton-mips",
           [](GlbParts& p) { setTexel(p, 1, 5, 4, 1, 1.01f * texel(1, 5, 4, 1)); }},
          {"a texel of the last mip that should be 0", "texton-mips",
           [](GlbParts& p) { setTexel(p, 2, 6, 5, 0, 0x1p-16f); }},
          {"a channel of more variance than the map says", "texton-covariance",
           [](GlbParts& p) { scaleChannel(p, 1, 1.01f); }},
          {"a channel that goes against the others", "texton-covariance",
           [](GlbParts& p) { scaleChannel(p, 2, -1.0f); }},
          {"another covariance than the texels'", "texton-covariance",
           [](GlbParts& p) {
             nlohmann::json& covariance = p.map(0, 0)["covariance"];
             covariance[1] = covariance[3] = 0.99 * covariance[1].get<double>();
           }},
          {"a scale that is not six deviations", "texton-scale",
           [](GlbParts& p) {
             nlohmann::json& scale = p.map(0, 0)["scale"];
             scale[0] = 1.001 * scale[0].get<double>();
           }},
          {"a mip that loses more of the third channel than the map says", "texton-mip-loss",
           [](GlbParts& p) {
             nlohmann::json& loss = p.map(0, 0)["mipLoss"][2 * kMaxTextonLosses + 1];
             loss = 0.98 * loss.get<double>();
           }},
          {"the losses of two channels, exchanged", "texton-mip-loss",
           [](GlbParts& p) {
             nlohmann::json& loss = p.map(0, 0)["mipLoss"];
             for (std::size_t level = 0; level < kMaxTextonLosses; ++level)
               std::swap(loss[level], loss[kMaxTextonLosses + level]);
           }},
          {"an average beyond the mips that loses more", "texton-mip-loss",
           [](GlbParts& p) {
             nlohmann::json& loss = p.map(0, 0)["mipLoss"];
             loss[4] = loss[3];
           }},
      });
}

TEST_CASE("mips may be averages of texels before they were rounded, or after") {
  // The valid file averages the texels from before rounding; this one averages the rounded texels.
  GlbParts parts(soundFile());
  const auto channels = std::size_t(channelCount(soundTable().format));
  std::vector<float> fine = levelOf(0);
  for (std::uint32_t level = 1; level < soundTable().mipLevels; ++level) {
    std::vector<float> values = levelOf(level);
    const std::size_t width = soundTable().width >> level, row = 2 * width * channels;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t x = i / channels % width, y = i / channels / width;
      const float* texel = &fine[2 * y * row + 2 * x * channels + i % channels];
      values[i] = (texel[0] + texel[channels] + texel[row] + texel[row + channels]) / 4.0f;
    }
    setLevel(parts, level, values);
    std::vector<std::byte> rounded;
    appendTexels(rounded, soundTable().format, values);
    Table stored{
        "", soundTable().format, std::uint32_t(width), soundTable().height >> level, 0, 1, rounded};
    fine = decodeLevel(stored, 0);
  }
  for (const Finding& finding : checkBundle(parts.join()))
    FAIL(finding.code << ": " << finding.message);
}
