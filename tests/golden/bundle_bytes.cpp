// SPDX-License-Identifier: MIT
// The bytes of revision 1 of the format. The writer must still produce these bytes, and every later
// reader must read them. Only the target regenerate_bundle_goldens regenerates them.
#include "bundle_example.h"
#include "checkout_paths.h"

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

TEST_CASE("the smallest bundle is written as its golden bytes") {
  CHECK(encodeGlb(example::smallest()).value() == golden("bundle_smallest.glb"));
}

TEST_CASE("the smallest bundle of a texton is written as its golden bytes") {
  CHECK(encodeGlb(example::smallestTexton()).value() == golden("bundle_texton.glb"));
}

TEST_CASE("the smallest bundle of cosines is written as its golden bytes") {
  CHECK(encodeGlb(example::smallestCosines()).value() == golden("bundle_cosines.glb"));
}

TEST_CASE("the smallest bundle of kernels is written as its golden bytes") {
  CHECK(encodeGlb(example::smallestKernels()).value() == golden("bundle_kernels.glb"));
}

TEST_CASE("the smallest bundle of quilting is written as its golden bytes") {
  CHECK(encodeGlb(example::smallestQuilting()).value() == golden("bundle_quilting.glb"));
}

TEST_CASE("a layered bundle is written as its golden bytes") {
  CHECK(encodeGlb(example::layered()).value() == golden("bundle_layers.glb"));
}

TEST_CASE("a KTX2 table is written as its golden bytes") {
  CHECK(encodeKtx2(example::tableWithMips()) == golden("table_mips.ktx2"));
}

TEST_CASE("the golden files are read") {
  CHECK(checkBundle(golden("bundle_smallest.glb")).empty());
  CHECK(checkBundle(golden("bundle_texton.glb")).empty());
  CHECK(checkBundle(golden("bundle_cosines.glb")).empty());
  CHECK(checkBundle(golden("bundle_kernels.glb")).empty());
  CHECK(checkBundle(golden("bundle_quilting.glb")).empty());
  CHECK(checkBundle(golden("bundle_layers.glb")).empty());
  const auto table = decodeKtx2(golden("table_mips.ktx2"), "mips");
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
