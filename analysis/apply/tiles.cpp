// SPDX-License-Identifier: MIT
// Materials and a noise -> what one tile measures on them.
#include "steps.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lichen::apply {
namespace {

// Bounds in pixels of the typical view, in which an object is kViewHeight high. Details of an
// eighth of the smallest tile are 2 pixels, the finest pattern that a picture can show; of a
// smaller tile little more than the mean is left. A wide object, such as 50 m of ground with tiles
// of 1 m, is not beyond it. A tile larger than the object shows only a part of the exemplar there.
constexpr double kSmallestTile = 16.0;
constexpr double kLargestTile = kViewHeight;
// The size that the proposed scale gives: a sixteenth and a quarter of the object.
constexpr double kRaisedTile = 64.0;
constexpr double kLoweredTile = 256.0;

/// Three significant digits, without an exponent for large values.
std::string lengthText(double value) {
  constexpr double kWhole = 100.0;
  return value >= kWhole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string pixelsText(double pixels) {
  constexpr double kFew = 10.0; // fewer have a decimal
  return pixels < kFew ? fmt::format("{:.2g} pixels", pixels)
                       : fmt::format("{:.0f} pixels", pixels);
}

std::string viewOf(const MaterialTile& tile) {
  return fmt::format("when {} {} {} x {} pixels", tile.object,
                     tile.size.nodeCount == 1 ? "fills" : "fill", kViewWidth, kViewHeight);
}

/// One note on all materials with a tile beyond a bound; `fault` describes it. The proposed scale
/// mends the first one.
std::string noteOn(const std::string& scene, const std::vector<MaterialTile>& tiles,
                   const std::string& fault, double aim, double scale, SettingWords words) {
  const TileSize& first = tiles.front().size;
  const double mended = std::clamp(scale * aim / first.pixels, kScaleRange.least, kScaleRange.most);
  constexpr double kTwoDigits = 10.0;
  const std::string value =
      mended < kTwoDigits ? fmt::format("{:.2g}", mended) : fmt::format("{:.0f}", mended);
  std::vector<std::string> titles;
  for (const MaterialTile& tile : tiles)
    titles.push_back(tile.material);
  const std::string of = tiles.size() > 1 ? " of the first" : "";
  return fmt::format("{}: {}: one tile{} is {} {}; {}; {} makes it {}", scene, shortList(titles),
                     of, pixelsText(first.pixels), viewOf(tiles.front()), fault,
                     words({"scale", value}), pixelsText(first.pixels * mended / scale));
}

} // namespace

std::vector<MaterialTile> measuredTiles(GltfScene& scene, std::span<const std::size_t> materials,
                                        const Noise& noise, const MaterialNoise& use,
                                        SettingWords words, std::vector<std::string>& notes) {
  std::vector<MaterialTile> tiles, small, large;
  std::vector<std::string> others;
  std::string reason; // of the first of these
  const std::vector<Result<TileSize>> sizes = measureTiles(scene, materials, noise, use);
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const std::string title = scene.materialTitle(materials[m]);
    if (!sizes[m]) {
      others.push_back(title);
      reason = reason.empty() ? sizes[m].error().message : reason;
      continue;
    }
    const TileSize& size = sizes[m].value();
    tiles.push_back({title,
                     size.nodeCount == 1 ? scene.nodeTitle(size.node)
                                         : fmt::format("its {} nodes", size.nodeCount),
                     size});
    if (size.pixels < kSmallestTile)
      small.push_back(tiles.back());
    if (size.pixels > kLargestTile)
      large.push_back(tiles.back());
  }
  if (!others.empty())
    notes.push_back(
        fmt::format("{}; the size of a tile is unknown on {}", reason, shortList(others)));
  const std::string path = scene.path().string();
  if (!small.empty())
    notes.push_back(noteOn(path, small, "it is so small that little more than its mean shows",
                           kRaisedTile, use.scale, words));
  if (!large.empty())
    notes.push_back(noteOn(path, large,
                           "it is larger than the object, which shows only a part of it",
                           kLoweredTile, use.scale, words));
  return tiles;
}

} // namespace lichen::apply

namespace lichen {

std::vector<std::string> linesOn(std::span<const MaterialTile> tiles, SettingWords words) {
  using namespace apply;
  constexpr std::size_t kMostLines = 8;
  std::vector<std::string> lines;
  for (const MaterialTile& tile : tiles.first(std::min(tiles.size(), kMostLines)))
    lines.push_back(fmt::format("{}: one tile is {} m, {} {}", tile.material,
                                lengthText(tile.size.metres), pixelsText(tile.size.pixels),
                                viewOf(tile)));
  if (tiles.size() > kMostLines)
    lines.push_back(
        fmt::format("and {} more; {} lists them", tiles.size() - kMostLines, words({"json", ""})));
  return lines;
}

} // namespace lichen
