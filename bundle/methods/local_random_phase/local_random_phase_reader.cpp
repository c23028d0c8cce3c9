// SPDX-License-Identifier: MIT
// Reads the members of a local random-phase noise: what its cosines share, and each map's image.
#include "methods/inverse_table_reader.h"
#include "methods/method_reader.h"
#include "methods/noise_members.h"

#include <lichen/counted.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lichen {
namespace {

using nlohmann::json;

constexpr const char* kMember = "localRandomPhase";

/// Whether the members that the maps share were faulty.
bool isUnknown(const LocalRandomPhaseNoise& shared) { return shared.texelsPerTileX == 0; }

/// The number of cosines of each octave.
std::optional<std::vector<int>> readOctaves(ObjectReader& reader) {
  const json* list = reader.array("octaves", kMostOctaves);
  if (list == nullptr)
    return std::nullopt;
  const auto error = [&](const char* code, const std::string& message) {
    reader.error(code, "octaves", message);
    return std::nullopt;
  };
  std::vector<int> octaves;
  int sum = 0;
  for (const json& count : *list) {
    if (!count.is_number())
      return error("type", "has an element that is not a number");
    const double value = count.get<double>();
    if (value != std::floor(value))
      return error("type", count.dump() + "; expected integers");
    if (!(value >= 0.0 && value <= kMostCosines))
      return error("range", count.dump() + "; expected 0 to " + std::to_string(kMostCosines));
    octaves.push_back(int(value));
    sum += octaves.back();
  }
  if (std::any_of(octaves.begin(), octaves.end(), [](int count) { return count % 2 != 0; }))
    return error("octaves-odd", "an octave has an odd number of cosines; expected pairs");
  if (sum > kMostCosines)
    return error("octaves-sum", counted(std::uint64_t(sum), "cosine") + "; expected at most " +
                                    std::to_string(kMostCosines));
  if (octaves.back() == 0)
    return error("octaves-last", "the last octave has no cosine; expected at least one");
  return octaves;
}

/// The sides of a structure, and the number of its offsets. Nothing if a member is faulty.
std::optional<CosineStructure> readStructure(ObjectReader& parent, FindingList& findings) {
  constexpr const char* kStructure = "structure";
  const json* value = parent.optional(kStructure);
  if (value == nullptr)
    return CosineStructure();
  ObjectReader reader(*value, parent.pointerTo(kStructure), findings);
  const auto sides =
      reader.pair("texels", {double(kFewestStructureTexels), double(kMostStructureTexels)});
  const int offsets =
      reader.integerOr("offsets", kMostStructureOffsets, 0, kFewestStructureOffsets);
  const double turbulence = reader.numberOr("turbulence", {0.0, 1.0}, 0.0);
  reader.warnOfUnknown();
  if (!sides)
    return std::nullopt;
  for (const double side : *sides)
    if (side != std::floor(side) || !std::has_single_bit(unsigned(side))) {
      reader.error("structure-texels", "texels", json(side).dump() + "; expected powers of two");
      return std::nullopt;
    }
  return CosineStructure{int((*sides)[0]), int((*sides)[1]), offsets, turbulence};
}

/// The factors and deviations of a map's structure.
void readStructure(ObjectReader& parent, const CosineStructure& structure, FindingList& findings,
                   LocalRandomPhaseMap& map) {
  constexpr const char* kStructure = "structure";
  const json* value = parent.required(kStructure);
  if (value == nullptr)
    return;
  ObjectReader reader(*value, parent.pointerTo(kStructure), findings);
  const auto amplitudes = reader.numbers("amplitudes", {0.0, double(kMostAmplitude)});
  const auto deviations = reader.numbers("deviations", {0.0, 1.0});
  reader.warnOfUnknown();
  const auto checkCount = [&](const char* key, const std::vector<double>& values, int wanted) {
    if (values.size() != std::size_t(wanted))
      reader.error("structure-count", key,
                   counted(values.size(), "number") + "; expected " + std::to_string(wanted));
  };
  if (amplitudes) {
    checkCount("amplitudes", *amplitudes, map.dimensions);
    map.structureAmplitudes = *amplitudes;
  }
  if (deviations) {
    checkCount("deviations", *deviations, structureLevels(structure));
    if (!std::is_sorted(deviations->rbegin(), deviations->rend()))
      reader.error("structure-deviations", "deviations",
                   "a level has a larger one than the level before; expected none");
    map.structureDeviations = *deviations;
  }
}

/// Checks the magnitudes, beyond which values of the noise could be infinite. The texels of a
/// structure are within their range whatever their bits.
void checkTexels(ObjectReader& reader, const CosineImageLayout& layout, int offsets,
                 const Table& image) {
  const std::vector<float> floats = decodeLevel(image, 0);
  const auto texels = cosineTexels(floats, layout);
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (const CosineTexel& cosine : texels[i])
      for (std::size_t k = 0; k < cosine.size(); ++k) {
        const bool isFrequency = i % layout.cosineColumns < kCosineColumns;
        const float most = isFrequency ? kMostFrequency : k == 3 ? kMostTurns : kMostAmplitude;
        if (!(std::abs(cosine[k]) <= most))
          return reader.error("cosines-texels", "cosines",
                              "a number of " + json(double(cosine[k])).dump() + "; expected -" +
                                  json(most).dump() + " to " + json(most).dump());
      }
  const auto first =
      floats.begin() + std::ptrdiff_t(4 * std::size_t(layout.offsetRow) * layout.width);
  for (auto offset = first; offset != first + 2 * offsets; ++offset)
    if (!(std::abs(*offset) <= 1.0f))
      return reader.error("structure-offsets", "cosines",
                          "an offset of " + json(double(*offset)).dump() +
                              " tiles; expected -1 to 1");
}

void checkImage(ObjectReader& reader, const LocalRandomPhaseNoise& shared, const Table& image) {
  const auto error = [&](const std::string& message) {
    reader.error("map-cosines", "cosines", message);
  };
  const CosineImageLayout layout(shared);
  if (image.depth != 0 || image.width != layout.width || image.height != layout.height)
    return error(shapeOf(image) + " texels; expected " + std::to_string(layout.width) + " x " +
                 std::to_string(layout.height) + " for its noise's cosines" +
                 (shared.structure.columns > 0 ? " and structure" : ""));
  if (image.mipLevels != 1)
    return error(counted(image.mipLevels, "mip level") + "; expected 1");
  if (image.format != TexelFormat::rgba32Sfloat)
    return error("texels of another format; expected RGBA32F");
  checkTexels(reader, layout, shared.structure.offsets, image);
}

MethodNoise readNoise(ObjectReader& reader, FindingList& findings) {
  const json* value = reader.required(kMember);
  if (value == nullptr)
    return LocalRandomPhaseNoise();
  ObjectReader member(*value, reader.pointerTo(kMember), findings);
  LocalRandomPhaseNoise shared;
  const auto texels = readSize(member, "texelsPerTile", kMaxTableSide);
  const auto columns = member.integer("columns", kMostOctaveCells, "range", 1);
  const auto rows = member.integer("rows", kMostOctaveCells, "range", 2);
  const auto octaves = readOctaves(member);
  const auto variants = member.integer("variants", kMostVariants, "range", 1);
  const std::optional<bool> isGiven = readGivenSpectrum(member);
  const std::optional<CosineStructure> structure = readStructure(member, findings);
  member.warnOfUnknown();
  if (rows && *rows % 2 != 0) {
    member.error("rows-odd", "rows", std::to_string(*rows) + "; expected an even number");
    return LocalRandomPhaseNoise();
  }
  if (variants && !std::has_single_bit(*variants)) {
    member.error("variants", "variants", std::to_string(*variants) + "; expected a power of two");
    return LocalRandomPhaseNoise();
  }
  if (!texels || !columns || !rows || !octaves || !variants || !isGiven || !structure)
    return LocalRandomPhaseNoise();
  shared.texelsPerTileX = (*texels)[0];
  shared.texelsPerTileY = (*texels)[1];
  shared.columns = int(*columns);
  shared.rows = int(*rows);
  shared.cosines = *octaves;
  shared.variants = int(*variants);
  shared.structure = *structure;
  shared.hasGivenSpectrum = *isGiven;
  return shared;
}

MethodMap readMap(ObjectReader& reader, const Noise& noise, const NoiseMap& map,
                  const Tables& tables, FindingList& findings) {
  LocalRandomPhaseMap own;
  const InverseTableMembers inverse = readInverseTable(reader, map, tables);
  own.dimensions = inverse.dimensions;
  own.inverseTable = inverse.table;
  const Table* image = readTableIndex(reader, "cosines", "map-cosines-index", tables, own.cosines);
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  if (shared.structure.columns > 0)
    readStructure(reader, shared.structure, findings, own);
  if (image != nullptr && !isUnknown(shared))
    checkImage(reader, shared, *image);
  return own;
}

constexpr std::array<std::string_view, 2> kTableMembers{"cosines", "inverseTable"};

} // namespace

extern const MethodReader kLocalRandomPhaseReader{.name = "local-random-phase",
                                                  .revision = 1,
                                                  .tableMembers = kTableMembers,
                                                  .readNoise = readNoise,
                                                  .readMap = readMap};

} // namespace lichen
