// SPDX-License-Identifier: MIT
// The boundary of the engine plugin: structs of older and newer headers, NULL and indices out of
// range, diagnostics, and conversion of exceptions into results.
#include "abi.h"
#include "exhausted_memory.h"
#include "plugin_plan.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <new>
#include <stdexcept>
#include <tuple>

using namespace lichen;
using namespace lichen::test;

TEST_CASE("NULL arguments and indices out of range are errors and leave outputs unchanged") {
  const OwnedBundle owned(example::smallest());
  const LichenBundle b = owned.handle;
  const LichenMaterialParameters parameters = parametersOf(b);
  const auto refusesAll = [](auto type, auto structureType, const auto&... calls) {
    decltype(type) target;
    LICHEN_INIT(target, structureType);
    const decltype(type) before = target;
    const bool refused = ((calls(&target) == LICHEN_ERROR_USAGE) && ...);
    return refused && std::memcmp(&before, &target, sizeof target) == 0;
  };
  CHECK(refusesAll(LichenBundleProperties{}, LICHEN_STRUCTURE_BUNDLE_PROPERTIES,
                   [&](auto* p) { return lichenGetBundleProperties(nullptr, p); }));
  CHECK(refusesAll(
      LichenNoiseProperties{}, LICHEN_STRUCTURE_NOISE_PROPERTIES,
      [&](auto* p) { return lichenGetNoiseProperties(nullptr, 0, p); },
      [&](auto* p) { return lichenGetNoiseProperties(b, 1, p); }));
  CHECK(refusesAll(
      LichenMapProperties{}, LICHEN_STRUCTURE_MAP_PROPERTIES,
      [&](auto* p) { return lichenGetMapProperties(nullptr, 0, 0, p); },
      [&](auto* p) { return lichenGetMapProperties(b, 1, 0, p); },
      [&](auto* p) { return lichenGetMapProperties(b, 0, 1, p); }));
  CHECK(refusesAll(
      LichenMaterialProperties{}, LICHEN_STRUCTURE_MATERIAL_PROPERTIES,
      [&](auto* p) { return lichenGetMaterialProperties(nullptr, 0, p); },
      [&](auto* p) { return lichenGetMaterialProperties(b, 1, p); }));
  CHECK(refusesAll(
      LichenImageProperties{}, LICHEN_STRUCTURE_IMAGE_PROPERTIES,
      [&](auto* p) { return lichenGetImageProperties(nullptr, 0, p); },
      [&](auto* p) { return lichenGetImageProperties(b, 4, p); }));
  CHECK(refusesAll(
      LichenCopy{}, LICHEN_STRUCTURE_COPY, [&](auto* p) { return lichenGetCopy(nullptr, 0, 0, p); },
      [&](auto* p) { return lichenGetCopy(b, 4, 0, p); },
      [&](auto* p) { return lichenGetCopy(b, 0, 3, p); }));
  CHECK(refusesAll(
      LichenBinding{}, LICHEN_STRUCTURE_BINDING,
      [&](auto* p) { return lichenGetBinding(nullptr, 0, 0, p); },
      [&](auto* p) { return lichenGetBinding(b, 1, 0, p); },
      [&](auto* p) { return lichenGetBinding(b, 0, LICHEN_LAYERED_SET_BINDINGS, p); }));
  CHECK(lichenGetBundleProperties(b, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetNoiseProperties(b, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetMapProperties(b, 0, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetMaterialProperties(b, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetImageProperties(b, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetCopy(b, 0, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetBinding(b, 0, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetSamplerProperties(LICHEN_SAMPLER_TABLE, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(refusesAll(
      LichenMaterialParameters{}, LICHEN_STRUCTURE_MATERIAL_PARAMETERS,
      [&](auto* p) { return lichenGetMaterialParameters(nullptr, 0, p); },
      [&](auto* p) { return lichenGetMaterialParameters(b, 1, p); },
      [&](auto* p) { return lichenGetDefaultParameters(nullptr, 0, p); },
      [&](auto* p) { return lichenGetDefaultParameters(b, 1, p); }));
  CHECK(lichenGetMaterialParameters(b, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetDefaultParameters(b, 0, nullptr) == LICHEN_ERROR_USAGE);
  unsigned char block[LICHEN_MATERIAL_BYTES];
  CHECK(lichenFillMaterial(nullptr, nullptr, block, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenFillMaterial(&parameters, nullptr, nullptr, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenParseBundle(nullptr, nullptr, nullptr) == LICHEN_ERROR_USAGE);
  lichenDestroyBundle(nullptr);
}

TEST_CASE("exceptions become results") {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  const auto result = [&](const auto& thrown) {
    return plugin::guarded(&diagnostic, [&]() -> LichenResult { throw thrown; });
  };
  CHECK(result(std::bad_alloc()) == LICHEN_ERROR_OUT_OF_HOST_MEMORY);
  CHECK(result(std::length_error("vector")) == LICHEN_ERROR_OUT_OF_HOST_MEMORY);
  CHECK(result(std::runtime_error("a fault")) == LICHEN_ERROR_INTERNAL);
  CHECK(std::string(diagnostic.text) == "internal error: a fault");
  CHECK(result(7) == LICHEN_ERROR_INTERNAL);
}

TEST_CASE("failure of any allocation while parsing, or of any large one, is a result") {
  BundleFile file = example::smallest();
  // The message of a table begins with its name, and is large then.
  constexpr std::size_t kLarge = 2048;
  file.bundle.tables[0] =
      example::gaussianTable(std::string(kLarge, 'a'), TexelFormat::rg8Unorm, 64, 64);
  const std::vector<std::byte> glb = encodeGlb(file).value();
  const LichenParseInfo info = parseInfo(glb);
  for (const auto& [leastBytes, leastFailures] : {std::pair{std::size_t(0), 100}, {kLarge, 5}}) {
    int failures = 0;
    for (int n = 1;; ++n) {
      LichenBundle bundle = nullptr;
      LichenResult result = LICHEN_SUCCESS;
      bool reached = false;
      {
        const ExhaustedMemory memory(n, leastBytes);
        result = lichenParseBundle(&info, &bundle, nullptr);
        reached = memory.reached();
      }
      if (!reached) {
        CHECK(result == LICHEN_SUCCESS);
        lichenDestroyBundle(bundle);
        break;
      }
      ++failures;
      INFO("allocation " << n << " of " << leastBytes << " bytes or more");
      CHECK(result == LICHEN_ERROR_OUT_OF_HOST_MEMORY);
      CHECK(bundle == nullptr);
    }
    CHECK(failures > leastFailures);
  }
}

TEST_CASE("inputs of other sizes and versions behave as documented") {
  const std::vector<std::byte> glb = encodeGlb(example::smallest()).value();
  SECTION("an older, smaller struct lacks the name") {
    LichenParseInfo info = parseInfo(glb);
    info.size = offsetof(LichenParseInfo, name);
    info.name = reinterpret_cast<const char*>(1); // must not be read
    const Parsed parsed = parse(info);
    CHECK(parsed.result == LICHEN_SUCCESS);
    lichenDestroyBundle(parsed.bundle);
  }
  SECTION("a newer, larger struct is read when its new members are zero") {
    struct Newer {
      LichenParseInfo known;
      std::uint64_t added;
    } newer{parseInfo(glb), 0};
    newer.known.size = sizeof newer;
    Parsed parsed = parse(newer.known);
    CHECK(parsed.result == LICHEN_SUCCESS);
    lichenDestroyBundle(parsed.bundle);
    newer.added = 1;
    CHECK(parse(newer.known).result == LICHEN_ERROR_VERSION);
  }
  SECTION("parameters and placement of other sizes fill the same block") {
    const OwnedBundle bundle(example::smallest());
    struct {
      LichenMaterialParameters known;
      std::uint64_t added;
    } parameters{parametersOf(bundle.handle), 0};
    struct {
      LichenPlacement known;
      std::uint64_t added;
    } placement{atOrigin(), 0};
    placement.known.tileOrigin[1] = 7;
    const shader::LichenTriplanarMaterial expected = fill(parameters.known, placement.known).block;
    const auto isSame = [&] {
      const Filled filled = fill(parameters.known, placement.known);
      return filled.result == LICHEN_SUCCESS &&
             std::memcmp(&filled.block, &expected, LICHEN_MATERIAL_BYTES) == 0;
    };
    parameters.known.size = sizeof parameters;
    placement.known.size = sizeof placement;
    CHECK(isSame());
    parameters.added = 1;
    CHECK(fill(parameters.known, placement.known).result == LICHEN_ERROR_VERSION);
    parameters.added = 0;
    placement.added = 1;
    CHECK(fill(parameters.known, placement.known).result == LICHEN_ERROR_VERSION);
    placement.known.size = offsetof(LichenPlacement, maxAnisotropy);
    placement.known.maxAnisotropy = -1.0f; // must not be read
    CHECK(isSame());
  }
  SECTION("a wrong type or a chain is an error") {
    LichenParseInfo info = parseInfo(glb);
    info.type = LICHEN_STRUCTURE_DIAGNOSTIC;
    CHECK(parse(info).result == LICHEN_ERROR_USAGE);
    info = parseInfo(glb);
    info.next = &info;
    CHECK(parse(info).result == LICHEN_ERROR_VERSION);
  }
}

TEST_CASE("shaders with another interface version are an error") {
  const std::vector<std::byte> glb = encodeGlb(example::smallest()).value();
  LichenParseInfo info = parseInfo(glb);
  info.interfaceVersion = LICHEN_INTERFACE_VERSION + 1;
  const Parsed refused = parse(info);
  CHECK(refused.result == LICHEN_ERROR_VERSION);
  CHECK(refused.message.find("interface version 2") != std::string::npos);
  info.interfaceVersion = LICHEN_INTERFACE_VERSION;
  const Parsed accepted = parse(info);
  CHECK(accepted.result == LICHEN_SUCCESS);
  lichenDestroyBundle(accepted.bundle);
}

TEST_CASE("a host header may have another minor version, but not another major version") {
  constexpr std::uint32_t kMajor = 0x10000u;
  const std::vector<std::byte> glb = encodeGlb(example::smallest()).value();
  const auto resultWith = [&](std::uint32_t headerVersion) {
    LichenParseInfo info = parseInfo(glb);
    info.headerVersion = headerVersion;
    const Parsed parsed = parse(info);
    lichenDestroyBundle(parsed.bundle);
    CHECK((parsed.result == LICHEN_SUCCESS || parsed.message.find("headerVersion") == 0));
    return parsed.result;
  };
  CHECK(resultWith(LICHEN_HEADER_VERSION + 1) == LICHEN_SUCCESS);
  CHECK(resultWith(LICHEN_HEADER_VERSION | (kMajor - 1)) == LICHEN_SUCCESS);
  CHECK(resultWith(LICHEN_HEADER_VERSION + kMajor) == LICHEN_ERROR_VERSION);
  CHECK(resultWith(LICHEN_HEADER_VERSION - kMajor) == LICHEN_ERROR_VERSION);
  CHECK(resultWith(0) == LICHEN_ERROR_VERSION);
}

TEST_CASE("outputs of other sizes and versions behave as documented") {
  const OwnedBundle bundle(example::smallest());
  SECTION("an output with a chain or without its type is an error") {
    LichenBundleProperties properties;
    LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
    properties.next = &properties;
    CHECK(lichenGetBundleProperties(bundle.handle, &properties) == LICHEN_ERROR_VERSION);
    LICHEN_INIT(properties, LICHEN_STRUCTURE_NOISE_PROPERTIES);
    CHECK(lichenGetBundleProperties(bundle.handle, &properties) == LICHEN_ERROR_USAGE);
    LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
    properties.size = 8;
    CHECK(lichenGetBundleProperties(bundle.handle, &properties) == LICHEN_ERROR_USAGE);
    CHECK(properties.noiseCount == 0);
  }
  SECTION("an older, smaller properties struct is filled up to its size") {
    LichenBundleProperties properties;
    LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
    properties.size = offsetof(LichenBundleProperties, imageCount);
    properties.imageCount = 12345;
    REQUIRE(lichenGetBundleProperties(bundle.handle, &properties) == LICHEN_SUCCESS);
    CHECK(properties.noiseCount == 1);
    CHECK(properties.imageCount == 12345);
  }
}

TEST_CASE("a diagnostic is truncated and terminated if its buffer is too short") {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  diagnostic.size = offsetof(LichenDiagnostic, text) + 8;
  std::memset(diagnostic.text, 'x', sizeof diagnostic.text);
  LichenBundle bundle = nullptr;
  CHECK(lichenParseBundle(nullptr, &bundle, &diagnostic) == LICHEN_ERROR_USAGE);
  CHECK(std::strlen(diagnostic.text) == 7);
  CHECK(diagnostic.text[8] == 'x');
}

TEST_CASE("a diagnostic that cannot be formatted is empty") {
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  std::memset(diagnostic.text, 'x', sizeof diagnostic.text);
  const wchar_t noCharacter[] = {wchar_t(0x110000), 0};
  plugin::writeDiagnostic(&diagnostic, "before %ls", noCharacter);
  CHECK(std::string(diagnostic.text).empty());
}

TEST_CASE("a diagnostic is one line of whole characters for any quoted name") {
  const std::vector<std::byte> notABundle(100, std::byte(7));
  const auto messageFor = [&](const std::string& name, std::size_t capacity) {
    LichenDiagnostic diagnostic;
    LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
    diagnostic.size = std::uint32_t(offsetof(LichenDiagnostic, text) + capacity);
    LichenParseInfo info = parseInfo(notABundle);
    info.name = name.c_str();
    LichenBundle bundle = nullptr;
    CHECK(lichenParseBundle(&info, &bundle, &diagnostic) == LICHEN_ERROR_BAD_BUNDLE);
    return std::string(diagnostic.text);
  };
  constexpr std::size_t kWhole = sizeof LichenDiagnostic{}.text;
  const auto starts = [&](const std::string& name, const std::string& shown) {
    INFO(messageFor(name, kWhole));
    return messageFor(name, kWhole).starts_with(shown + ": ");
  };
  CHECK(starts("moos-gr\u00fcn \u82d4 \U0001f33f.glb", "moos-gr\u00fcn \u82d4 \U0001f33f.glb"));
  CHECK(starts("two\nlines\t\x1b[31m\x7f", R"(two\x0alines\x09\x1b[31m\x7f)"));
  CHECK(starts("next line \xc2\x85", R"(next line \xc2\x85)"));
  CHECK(starts("latin \xfc.glb", R"(latin \xfc.glb)"));
  CHECK(starts("overlong \xc0\xaf \xe0\x80\xaf", R"(overlong \xc0\xaf \xe0\x80\xaf)"));
  CHECK(starts("surrogate \xed\xa0\x80", R"(surrogate \xed\xa0\x80)"));
  CHECK(starts("beyond \xf4\x90\x80\x80 \xf8", R"(beyond \xf4\x90\x80\x80 \xf8)"));
  const std::string four = "\U0001f33f";
  for (std::size_t capacity = 1; capacity <= 12; ++capacity)
    CHECK(messageFor(four + four + four, capacity).size() == (capacity - 1) / 4 * 4);
  for (std::size_t before = 480; before < 484; ++before) // truncates at each byte of a character
    CHECK(messageFor(std::string(before, 'x') + four + four + four + four, kWhole).size() ==
          before + (kWhole - 1 - before) / 4 * 4);
}
