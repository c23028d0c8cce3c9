// SPDX-License-Identifier: MIT
// The checker and the JSON schemas agree. tests/cli/gltf_validator/schema_cases.json holds patches
// (RFC 6902) of the extension's examples with the expected verdict of both. The script beside that
// file checks the same cases against the schemas.
#include "checkout_paths.h"
#include "temporary_folder.h"

#include <lichen/bundle_files.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

using namespace lichen;
using nlohmann::json;

namespace {

json readJson(const std::string& path) {
  std::ifstream stream(sourcePath(path));
  return json::parse(stream);
}

} // namespace

TEST_CASE("the checker accepts and refuses what the JSON schemas do") {
  const std::string examples = "docs/gltf_extension/examples/";
  const TemporaryFolder folder;
  std::map<std::string, json> documents;
  for (const char* name : {"felt.gltf", "dune.gltf"}) {
    const json& document = documents[name] = readJson(examples + name);
    const std::string binary = document["buffers"][0]["uri"];
    std::filesystem::copy_file(sourcePath(examples + binary), folder.path() / binary);
  }
  const json cases = readJson("tests/cli/gltf_validator/schema_cases.json");
  CHECK(cases.size() >= 30);
  for (const json& entry : cases) {
    INFO(entry["what"].get<std::string>());
    const std::filesystem::path path = folder.path() / "case.gltf";
    std::ofstream(path)
        << documents.at(entry.value("example", "felt.gltf")).patch(entry["patch"]).dump();
    const auto findings = checkBundle(path);
    REQUIRE(findings.ok());
    const bool sound =
        std::none_of(findings.value().begin(), findings.value().end(), [](const Finding& finding) {
          return finding.severity == Finding::Severity::error;
        });
    CHECK(sound == entry["valid"].get<bool>());
  }
}
