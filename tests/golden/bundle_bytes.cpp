// SPDX-License-Identifier: MIT
// The bytes of revision 1 of the format. The writer must still produce these bytes, and every later
// reader must read them. Only the target regenerate_bundle_goldens regenerates them.
#include "bundle_example.h"
#include "checkout_paths.h"

#include <lichen/bundle_files.h>
#include <lichen/files.h>

#include <catch2/catch.hpp>

using namespace lichen;

namespace {

std::vector<std::byte> golden(const std::string& name) {
  const auto file = readFile(sourcePath("tests/golden/" + name));
  REQUIRE(file.ok());
  return file.value();
}

} // namespace

TEST_CASE("bundles and tables are written as their golden bytes, and these are read") {
  for (const auto& [name, file] : {std::pair{"smallest", example::smallest()},
                                   {"texton", example::smallestTexton()},
                                   {"cosines", example::smallestCosines()},
                                   {"kernels", example::smallestKernels()},
                                   {"quilting", example::smallestQuilting()},
                                   {"layers", example::layered()}}) {
    INFO(name);
    const std::vector<std::byte> bytes = golden("bundle_" + std::string(name) + ".glb");
    CHECK((encodeGlb(file).value() == bytes));
    CHECK(checkBundle(bytes).empty());
  }
  const std::vector<std::byte> bytes = golden("table_mips.ktx2");
  CHECK((encodeKtx2(example::tableWithMips()) == bytes));
  const auto table = decodeKtx2(bytes, "mips");
  REQUIRE(table.ok());
  CHECK(table.value().texels == example::tableWithMips().texels);
}

TEST_CASE("the extension's examples are sound, and both forms hold the same bundle") {
  const std::filesystem::path folder(sourcePath("docs/gltf_extension/examples"));
  for (const std::string name : {"felt", "dune"}) {
    for (const char* extension : {".glb", ".gltf"}) {
      const auto findings = checkBundle(folder / (name + extension));
      REQUIRE(findings.ok());
      CHECK(findings.value().empty());
    }
    const auto binary = readBundle(folder / (name + ".glb"));
    const auto text = readBundle(folder / (name + ".gltf"));
    REQUIRE(binary.ok());
    REQUIRE(text.ok());
    REQUIRE(binary.value().tables.size() == text.value().tables.size());
    for (std::size_t i = 0; i < binary.value().tables.size(); ++i)
      CHECK(binary.value().tables[i].texels == text.value().tables[i].texels);
    CHECK(binary.value().noises[0].maps[0].mean == text.value().noises[0].maps[0].mean);
  }
}
