// SPDX-License-Identifier: MIT
// Out-of-memory behaviour: all allocations from the n-th on fail, for one n after another. Each
// time the function must report the error and leak nothing (AddressSanitizer runs detect leaks).
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/bundle_merge.h>
#include <lichen/bundle_writer.h>
#include <lichen/exemplar_repair.h>
#include <lichen/files.h>
#include <lichen/image_io.h>
#include <lichen/material_set.h>
#include <lichen/measures.h>
#include <lichen/noise_evaluator.h>
#include <lichen/noise_report.h>
#include <lichen/quality.h>
#include <lichen/suitability.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <exhausted_memory.h>
#include <functional>
#include <optional>
#include <sys/wait.h>
#include <temporary_folder.h>
#include <unistd.h>

using namespace lichen;

namespace {

/// Which allocation is the first to fail.
enum class First {
  each,
  sampled ///< each up to the 64th, then at steps of a sixteenth
};

/// The result of the operation with enough memory.
enum class Outcome { success, refusal };

/// How one attempt ended.
struct Attempt {
  bool reached = false; ///< the n-th allocation was requested
  std::optional<Error> error;
};

/// Runs `operation`, which returns a Result; memory ends at its `failing`th allocation of at least
/// `leastBytes`.
template <class Operation>
Attempt attempt(const Operation& operation, int failing, std::size_t leastBytes = 0) {
  Attempt ended;
  const auto result = [&] {
    const test::ExhaustedMemory memory(failing, leastBytes);
    auto made = operation();
    ended.reached = test::ExhaustedMemory::reached();
    return made;
  }();
  if (!result.ok())
    ended.error = result.error();
  return ended;
}

/// Attempts an operation with memory that ends at one allocation after another, until memory
/// suffices. Each failure must be reported as a resource error. One thread only, because the count
/// is per thread. Memory is available again when `afterFailure` runs. Returns the number of
/// failures.
int exhaustMemory(First first, Outcome outcome,
                  const std::function<Attempt(int failing)>& operation,
                  const std::function<void()>& afterFailure) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  tbb::parallel_for(0, 1, [](int) {}); // oneTBB hangs if its first use runs out of memory
  constexpr int kSteps = 16;
  int failures = 0;
  for (int failing = 1;; failing += first == First::each ? 1 : std::max(1, failing / kSteps)) {
    const auto [reached, error] = operation(failing);
    if (!reached) {
      REQUIRE(error.has_value() == (outcome == Outcome::refusal));
      if (error)
        REQUIRE(error->kind != ErrorKind::resources);
      return failures;
    }
    INFO("allocation " << failing);
    REQUIRE(error.has_value());
    REQUIRE(error->kind == ErrorKind::resources);
    REQUIRE(error->message.find("memory") != std::string::npos);
    afterFailure();
    ++failures;
  }
}

template <class Operation>
int exhaustMemory(First first, const Operation& operation) {
  return exhaustMemory(
      first, Outcome::success, [&](int failing) { return attempt(operation, failing); }, [] {});
}

/// For an operation that writes JSON: only large allocations fail, because nlohmann's destructors
/// need small ones.
template <class Operation>
int exhaustWriting(
    const Operation& operation, const std::function<void()>& afterFailure = [] {}) {
  constexpr std::size_t kLarge = 16384;
  return exhaustMemory(
      First::each, Outcome::success,
      [&](int failing) { return attempt(operation, failing, kLarge); }, afterFailure);
}

/// For an operation that rejects its input, where the message is the first allocation.
template <class Operation>
int exhaustRefusal(const Operation& operation) {
  return exhaustMemory(
      First::each, Outcome::refusal, [&](int failing) { return attempt(operation, failing); },
      [] {});
}

MapExemplar oneChannel(MapExemplar map) {
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    map.values[i] = map.values[3 * i];
  map.values.resize(map.values.size() / 3);
  map.channels = {MapChannel::red};
  return map;
}

Bundle bakedBundle(const MapExemplar& map) {
  return test::bundleOf(bakeTiling("example", {&map, 1}, {}));
}

} // namespace

TEST_CASE("a bake reports exhausted memory, whichever allocation fails") {
  const MapExemplar color = test::threeMaterials(24, 20, 1, 1);
  MapExemplar height = oneChannel(color);
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.encoding = ValueEncoding::linear;
  const std::vector<MapExemplar> set{color, height};
  CHECK(exhaustMemory(First::each, [&] { return bakeTiling("x", {&height, 1}, {}); }) > 20);
  CHECK(exhaustMemory(First::sampled, [&] { return bakeTiling("x", set, {}); }) > 64);
}

TEST_CASE("reading a set reports exhausted memory, whichever allocation fails") {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const SrgbImage& image) {
    REQUIRE(writeImage(folder / name, image));
  };
  write("a_material_with_a_long_name_diff.png", SrgbImage(6, 5, 4));
  SrgbImage flat(6, 5, 3);
  std::fill(flat.values.begin(), flat.values.end(), 1.0f); // normals that point out of the surface
  write("a_material_with_a_long_name_nor_gl.png", flat);
  write("a_material_with_a_long_name_rough.png", SrgbImage(6, 5, 1));
  write("a_material_with_a_long_name_ao.png", SrgbImage(3, 5, 1));
  write("nothing_that_is_known.png", SrgbImage(1, 1, 1));
  MaterialSetOptions options;
  options.alpha = AlphaUse::opacity;
  options.crop = PixelRectangle{1, 0, 4, 5};
  options.size = {7, 3};
  const std::filesystem::path inputs[] = {folder.path()};
  CHECK(exhaustMemory(First::each, [&] { return readMaterialSet(inputs, options); }) > 50);
  options.crop->width = 7;
  CHECK(exhaustRefusal([&] { return readMaterialSet(inputs, options); }) > 50);
}

TEST_CASE("an evaluation reports exhausted memory, whichever allocation fails") {
  const Bundle bundle = bakedBundle(oneChannel(test::threeMaterials(64, 64, 1, 1)));
  CHECK(exhaustMemory(First::each,
                      [&] { return NoiseEvaluator::create(bundle, MaterialNoise()); }) > 2);
  SynthesisOptions options;
  options.width = options.height = 64;
  CHECK(exhaustMemory(First::each, [&] { return synthesize(bundle, options); }) > 3);
  CHECK(exhaustMemory(First::each, [&] {
          return synthesizePreview(bundle, MaterialNoise(), MapTarget::baseColor, 1);
        }) > 3);
}

TEST_CASE("encoding a bundle reports exhausted memory and leaves no file") {
  BundleFile file;
  MapExemplar height = oneChannel(test::threeMaterials(8, 8, 1, 1)); // its table is small
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.encoding = ValueEncoding::linear;
  file.bundle = bakedBundle(height);
  file.bundle.materials = {MaterialNoise{}};
  // Too long for the small-string buffer; with a texture transform and every slot.
  file.bundle.materials[0]->scale = 3.0;
  file.bundle.materialNames = {"a material with a long name"};
  file.generator = "a generator with a long name";
  PreviewImages images;
  images.baseColor = images.normal = images.emissive = encodePng(SrgbImage(4, 4, 3), 8).value();
  file.previews = {images};
  CHECK(exhaustWriting([&] { return encodeGlb(file); }) > 20);
  for (const char* name : {"x.glb", "x.gltf"}) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / name;
    CHECK(exhaustWriting([&] { return writeBundle(path, file); },
                         [&] { REQUIRE(folder.entryCount() == 0); }) > 20);
  }
}

namespace {

/// Writes over an old file and as a new one, while one allocation after another fails. Returns the
/// first message about a broken promise, or an empty text.
std::string faultOfReplacing(const std::filesystem::path& folder, test::Failing failing) {
  const std::vector<std::byte> old(100, std::byte(1)), fresh(1000, std::byte(2));
  // A name too long for the small-string buffer, whose path has several parts.
  const std::filesystem::path path = folder / "a file with a name that is stored on the heap.glb";
  const auto entries = [&] { return listFolder(folder).value().size(); };
  for (const bool exists : {false, true})
    for (int nth = 1;; ++nth) {
      std::filesystem::remove(path);
      if (exists && !replaceFile(path, old))
        return "the old file cannot be written";
      Result<void> written;
      bool reached = false;
      {
        const test::ExhaustedMemory memory(nth, 0, failing);
        written = replaceFile(path, fresh);
        reached = test::ExhaustedMemory::reached();
      }
      const std::string where = "allocation " + std::to_string(nth) + ": ";
      if (!reached && !written)
        return where + "fails although there is memory";
      if (!reached && nth < 3)
        return where + "too few allocations to test";
      if (!reached)
        break;
      if (written.ok() || written.error().kind != ErrorKind::resources)
        return where + "not reported as exhausted memory";
      if (entries() != (exists ? 1u : 0u))
        return where + "a file is left";
      if (exists && readFile(path).value() != old)
        return where + "the old file has changed";
    }
  return readFile(path).value() == fresh && entries() == 1 ? "" : "the new file is not written";
}

} // namespace

TEST_CASE("whichever allocation of a write fails, the old file stays and no other file is left") {
  for (const test::Failing failing : {test::Failing::nth, test::Failing::fromNth}) {
    constexpr int kNotRoot = 77;
    const TemporaryFolder folder, newRoot;
    CHECK(faultOfReplacing(folder.path(), failing) == "");
    // Without /proc, the temporary file has a name from the start.
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chroot(newRoot.path().c_str()) != 0)
        ::_exit(kNotRoot);
      const std::string fault = faultOfReplacing("/", failing);
      std::fputs(fault.c_str(), stderr);
      ::_exit(fault.empty() ? 0 : 1);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    if (WEXITSTATUS(status) == kNotRoot)
      WARN("not tested without /proc: only root may change the root");
    else
      CHECK(WEXITSTATUS(status) == 0);
  }
}

TEST_CASE("a merge reports exhausted memory, whichever allocation fails") {
  const MapExemplar height = oneChannel(test::threeMaterials(6, 4, 1, 1));
  Bundle bundle = bakedBundle(height);
  bundle.materials = {MaterialNoise{}};
  bundle.materialNames = {"a material with a name that is stored outside its string"};
  const std::vector<NamedBundle> inputs{{"a file with a long name.glb", bundle},
                                        {"another file with a long name.glb", bundle}};
  CHECK(exhaustMemory(First::each, [&] { return mergeBundles(inputs); }) > 10);
}

TEST_CASE("a report returns an error for exhausted memory, whichever large allocation fails") {
  const MapExemplar map = oneChannel(test::threeMaterials(24, 20, 1, 1));
  Bundle bundle = bakedBundle(map);
  bundle.materials = {MaterialNoise{}};
  const std::vector<Risk> risks = assessSuitability(map, true).value();
  const ExemplarOrigin origin{{"without what is slow"}, map};
  const BakeRecord record{.bundle = bundle,
                          .exemplars = {&map, 1},
                          .risks = {&risks, 1},
                          .origins = {&origin, 1},
                          .command = "command",
                          .facts = {{"name", "value"}},
                          .notes = {"a note"}};
  CHECK(exhaustWriting([&] { return encodeNoiseReport(record); }) > 10);
}

TEST_CASE("a measure reports exhausted memory, whichever allocation fails") {
  SrgbImage a(80, 72, 1);
  for (std::size_t i = 0; i < a.values.size(); ++i)
    a.values[i] = float(pcg(std::uint32_t(i)) >> 8u) * 0x1p-24f;
  LatticeView view;
  view.tilesPerPixelX = view.tilesPerPixelY = 1.0 / 40.0;
  CHECK(exhaustMemory(First::each, [&] { return latticeVisibility(a, view); }) > 0);
  CHECK(exhaustMemory(First::sampled, [&] { return measureResult(a, a); }) > 10);
}

TEST_CASE("returning an error reports exhausted memory, whichever allocation fails") {
  TilingOptions bits;
  bits.bits = 7;
  const MapExemplar map = oneChannel(test::threeMaterials(64, 64, 1, 1));
  CHECK(exhaustRefusal([&] { return bakeTiling("x", {&map, 1}, bits); }) > 0);
  MapExemplar odd = map;
  CHECK(exhaustRefusal([&] { return flatten({&odd, 1}, 1.0, true); }) > 0);
  odd.values.pop_back();
  CHECK(exhaustRefusal([&] { return assessSuitability(odd, true); }) > 0);

  const Bundle bundle = bakedBundle(map);
  SynthesisOptions options;
  options.width = 0;
  CHECK(exhaustRefusal([&] { return synthesize(bundle, options); }) > 0);
  constexpr auto kMap = MapTarget::baseColor;
  CHECK(exhaustRefusal([&] { return synthesizePreview(bundle, MaterialNoise(), kMap, 0); }) > 0);
  MaterialNoise absent;
  absent.noise = 1;
  CHECK(exhaustRefusal([&] { return NoiseEvaluator::create(bundle, absent); }) > 0);

  const SrgbImage empty;
  const SrgbImage grey(80, 72, 1);
  LatticeView view;
  view.tilesPerPixelX = 0.0;
  CHECK(exhaustRefusal([&] { return colorDistance(empty, grey); }) > 0);
  CHECK(exhaustRefusal([&] { return spectrumDistanceDb(empty, grey); }) > 0);
  CHECK(exhaustRefusal([&] { return autocovarianceError(empty, grey, 8); }) > 0);
  CHECK(exhaustRefusal([&] { return latticeVisibility(grey, view); }) > 0);
  CHECK(exhaustRefusal([&] { return seamVisibility(empty, grey); }) > 0);

  CHECK(exhaustRefusal([&] { return encodePng(empty, 8); }) > 0);
  CHECK(exhaustRefusal([] { return encodeExr(LinearImage()); }) > 0);
}
