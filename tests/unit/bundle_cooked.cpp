// SPDX-License-Identifier: MIT
// Cooked bundles: the engine plugin plans the same as of the glTF file, in place, and the reader
// refuses what is broken.
#include "plugin_plan.h"

#include <lichen/table.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstring>
#include <functional>
#include <limits>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kHeader = 16;

/// A cooked bundle with a changed description. Texels move with their offsets.
Bytes changed(const Bytes& cooked, const std::function<void(json&)>& change) {
  std::uint32_t size = 0;
  std::memcpy(&size, cooked.data() + kHeader - sizeof size, sizeof size);
  const auto* text = reinterpret_cast<const std::uint8_t*>(cooked.data() + kHeader);
  json document = json::from_cbor(text, text + size);
  // Room for a description that grows, before the first texels.
  constexpr std::size_t kRoom = 1024;
  json& tables = document["extensions"]["LICHEN_materials_exemplar_noise"]["tables"];
  const std::size_t first = tables[0]["offset"];
  for (json& table : tables)
    table["offset"] = table["offset"].get<std::size_t>() + kRoom;
  change(document);
  const std::vector<std::uint8_t> description = json::to_cbor(document);
  Bytes file(cooked.begin(), cooked.begin() + kHeader);
  size = std::uint32_t(description.size());
  std::memcpy(file.data() + kHeader - sizeof size, &size, sizeof size);
  for (const std::uint8_t byte : description)
    file.push_back(std::byte(byte));
  REQUIRE(file.size() <= first + kRoom);
  file.resize(first + kRoom);
  file.insert(file.end(), cooked.begin() + std::ptrdiff_t(first), cooked.end());
  return file;
}

json& extension(json& document) {
  return document["extensions"]["LICHEN_materials_exemplar_noise"];
}

std::string messageOf(const Bytes& file) {
  const Result<Bundle> bundle = parseBundle(file, "moss.lichen");
  return bundle ? "" : bundle.error().message;
}

/// Everything that the plan layer says of a bundle, as bytes.
Bytes planOf(LichenBundle bundle) {
  Bytes all;
  const auto add = [&](const void* bytes, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(bytes);
    all.insert(all.end(), first, first + size);
  };
  auto counts = got<LichenBundleProperties>(lichenGetBundleProperties, bundle);
  add(&counts, sizeof counts);
  for (std::uint32_t i = 0; i < counts.imageCount; ++i) {
    auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle, i);
    add(image.bytes, image.byteCount);
    add(image.name, std::strlen(image.name));
    image.bytes = image.name = nullptr;
    add(&image, sizeof image);
  }
  for (std::uint32_t noise = 0; noise < counts.noiseCount; ++noise) {
    Bytes constants(LICHEN_NOISE_BYTES);
    REQUIRE(lichenGetNoiseConstants(bundle, noise, constants.data()) == LICHEN_SUCCESS);
    add(constants.data(), constants.size());
    for (std::uint32_t i = 0; i < LICHEN_SET_BINDINGS; ++i) {
      auto binding = got<LichenBinding>(lichenGetBinding, bundle, noise, i);
      add(&binding, sizeof binding);
    }
  }
  for (std::uint32_t i = 0; i < counts.materialCount; ++i) {
    auto material = got<LichenMaterialProperties>(lichenGetMaterialProperties, bundle, i);
    add(&material, sizeof material);
    auto parameters = got<LichenMaterialParameters>(lichenGetMaterialParameters, bundle, i);
    add(&parameters, sizeof parameters);
  }
  return all;
}

/// Parses a cooked bundle that stays where it is.
Parsed parseInPlace(const Bytes& cooked) {
  LichenParseInfo info = parseInfo(cooked);
  info.bytesStay = 1;
  return parse(info);
}

} // namespace

TEST_CASE("a cooked bundle has the plan of its glTF file, copied or in place") {
  BundleFile masked = example::textonMix();
  masked.bundle.materials[1]->mix = {MixSource::texture, 0.0, {}, {0.0, 1.0}, 2, 1, 0, 3};
  for (const BundleFile& file :
       {example::smallest(), example::everyMap(), example::smallestTexton(),
        example::smallestCosines(), example::smallestQuilting(), example::textonMix(), masked}) {
    const Bytes cooked = cookBundle(file.bundle);
    CHECK(checkBundle(cooked).empty());
    if (file.bundle.materials.back()->mix.source != MixSource::texture) { // GLBs have no textures
      const OwnedBundle fromGlb(file);
      const Parsed copied = parse(parseInfo(cooked));
      REQUIRE(copied.message == "");
      CHECK(planOf(copied.bundle) == planOf(fromGlb.handle));
      lichenDestroyBundle(copied.bundle);
    }
    const Parsed inPlace = parseInPlace(cooked);
    REQUIRE(inPlace.message == "");
    const Parsed copied = parse(parseInfo(cooked));
    CHECK(planOf(inPlace.bundle) == planOf(copied.bundle));
    LichenImageProperties image;
    LICHEN_INIT(image, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
    for (const auto& [parsed, isInside] : {std::pair{inPlace, true}, {copied, false}}) {
      REQUIRE(lichenGetImageProperties(parsed.bundle, 0, &image) == LICHEN_SUCCESS);
      const auto* first = static_cast<const std::byte*>(image.bytes);
      CHECK((first >= cooked.data() && first < cooked.data() + cooked.size()) == isInside);
      CHECK((!isInside || (first - cooked.data()) % 64 == 0));
      lichenDestroyBundle(parsed.bundle);
    }
  }
}

TEST_CASE("the same bundle gives the same cooked bytes") {
  const Bundle bundle = example::everyMap().bundle;
  CHECK(cookBundle(bundle) == cookBundle(bundle));
}

TEST_CASE("a cooked bundle without noise is a bundle without noise") {
  Bundle bundle;
  bundle.materials.resize(2);
  bundle.materialNames.resize(2);
  const auto read = parseBundle(cookBundle(bundle), "empty.lichen");
  REQUIRE(read.ok());
  CHECK(read.value().noises.empty());
  CHECK(read.value().materials.size() == 2);
}

TEST_CASE("bytesStay takes 0 and 1") {
  const Bytes cooked = cookBundle(example::smallest().bundle);
  LichenParseInfo info = parseInfo(cooked);
  info.bytesStay = 2;
  const Parsed parsed = parse(info);
  CHECK(parsed.result == LICHEN_ERROR_USAGE);
  CHECK(parsed.message == "bytesStay 2 is invalid; expected 0 or 1");
}

TEST_CASE("a cooked bundle that is cut off or of another version is refused") {
  const Bytes cooked = cookBundle(example::smallest().bundle);
  CHECK(messageOf({cooked.begin(), cooked.begin() + 12}) ==
        "moss.lichen: the cooked bundle ends inside its header");
  CHECK(messageOf({cooked.begin(), cooked.begin() + 100}).find("is the file truncated?") !=
        std::string::npos);
  CHECK(messageOf({cooked.begin(), cooked.end() - 1}).find("the file is truncated") !=
        std::string::npos);
  Bytes later = cooked;
  later[8] = std::byte(2);
  CHECK(messageOf(later) ==
        "moss.lichen: cooked bundle of version 2; expected 1: cook it again with this release");
}

TEST_CASE("a description that is not as lichen cook writes it is refused") {
  const std::string refusal = "moss.lichen: the description is not CBOR as lichen cook writes it";
  Bytes file = cookBundle(example::smallest().bundle);
  file[kHeader] = std::byte(0xff); // a break without a start
  CHECK(messageOf(file) == refusal);
  Bytes nested(file.begin(), file.begin() + kHeader);
  const std::uint32_t size = 1u << 20u;
  std::memcpy(nested.data() + kHeader - sizeof size, &size, sizeof size);
  nested.resize(kHeader + size, std::byte(0x81)); // arrays of one element, a million deep
  CHECK(messageOf(nested) == refusal);
  const Bytes cooked = cookBundle(example::smallest().bundle);
  CHECK(messageOf(changed(cooked, [](json& document) {
          extension(document)["noises"][0]["name"] = "\xff";
        })) == refusal);
}

TEST_CASE("tables of a cooked bundle lie in the file, one after the other") {
  const Bytes cooked = cookBundle(example::smallest().bundle);
  CHECK(messageOf(changed(cooked, [](json&) {})) == "");
  const std::string tables = "moss.lichen: /extensions/LICHEN_materials_exemplar_noise/tables/";
  const struct {
    std::size_t table;
    const char* key;
    json value;
    std::string member;
  } cases[] = {
      {1, "offset", 0, "/offset"},
      {1, "offset", 1u << 30u, "/offset"},
      {0, "offset", -1, "/offset"},
      {0, "offset", 0, "/offset"}, // the header
      {0, "vkFormat", 44, "/vkFormat"},
      {0, "width", 0, "/width"},
      {0, "width", 16385, "/width"},
      {0, "height", 1.5, "/height"},
      {0, "depth", json::binary({1}), "/depth"},
      {0, "mipLevels", 4, "/mipLevels"},
      {0, "mipLevels", 0, "/mipLevels"},
  };
  for (const auto& each : cases) {
    const Bytes file = changed(cooked, [&](json& document) {
      extension(document)["tables"][each.table][each.key] = each.value;
    });
    const std::string expected = tables + std::to_string(each.table) + each.member + ": ";
    INFO(messageOf(file));
    CHECK(messageOf(file).starts_with(expected));
  }
}

TEST_CASE("numbers and texels of a cooked bundle must be finite") {
  const Bytes cooked = cookBundle(example::smallestTexton().bundle);
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    CHECK(messageOf(changed(cooked, [&](json& document) {
            extension(document)["noises"][0]["tileSize"] = value;
          })).find("/tileSize: ") != std::string::npos);
  Bytes infinite = cooked; // textons are half floats, the last bytes of the file
  infinite[infinite.size() - 2] = std::byte(0);
  infinite[infinite.size() - 1] = std::byte(0x7c);
  CHECK(messageOf(infinite).find("a texel is NaN or infinite") != std::string::npos);
}
