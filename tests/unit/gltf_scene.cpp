// SPDX-License-Identifier: MIT
// Scenes from other programs: what a change preserves, what is written, and which scenes are
// rejected.
#include "bundle/gltf_container.h"
#include "bundle_example.h"
#include "bundle_files/gltf_output.h"
#include "exhausted_memory.h"
#include "opened_scene.h"
#include "tiny_scene.h"

#include <lichen/bundle_files.h>
#include <lichen/files.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

using namespace lichen;
using example::TinyScene;
using nlohmann::json;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::byte> bytesOf(const std::filesystem::path& path) { return readFile(path).value(); }

json documentOf(const std::vector<std::byte>& file) {
  const auto opened = openGltf(file);
  REQUIRE(std::holds_alternative<GltfContainer>(opened));
  return std::get<GltfContainer>(opened).document;
}

std::vector<std::byte> chunkOf(const std::vector<std::byte>& glb) {
  const auto opened = openGltf(glb);
  const auto chunk = *std::get<GltfContainer>(opened).binaryChunk;
  return {chunk.begin(), chunk.end()};
}

/// Applies the noise to the first of these materials.
void applyAndWrite(GltfScene scene, const BundleFile& noise, const std::filesystem::path& output,
                   const MaterialNoise& use = {}) {
  const std::array<std::size_t, 1> materials{0};
  REQUIRE(scene.applyNoise(noise.bundle, 0, use, materials).ok());
  const Result<void> written = scene.write(output);
  INFO((written ? "" : written.error().message));
  REQUIRE(written.ok());
  const auto findings = checkBundle(output);
  REQUIRE(findings.ok());
  CHECK(findings.value().empty());
}

/// A value of any type; numbers have any bits, strings any characters.
Json randomJson(std::mt19937_64& random, int depth) {
  switch (random() % (depth < 4 ? 9 : 7)) {
  case 0:
    return std::int64_t(random()) >> random() % 64;
  case 1:
    return random() >> random() % 64;
  case 2:
  case 3: {
    const auto number = std::bit_cast<double>(random());
    return std::isfinite(number) ? number : -0.0;
  }
  case 4:
    return double(random() % 2000) / 10.0; // often whole: 7.0
  case 5: {
    const std::array<std::string, 8> pieces{"a",  "\n",       "\\",   "/",
                                            "\"", "\xc3\xa9", "\x7f", "\xf0\x9f\x8c\xbf"};
    std::string text;
    for (std::size_t k = random() % 6; k > 0; --k)
      text += pieces[random() % pieces.size()];
    return text;
  }
  case 6:
    return random() % 2 == 0 ? Json(nullptr) : Json(random() % 2 == 0);
  case 7: {
    Json list = Json::array();
    for (std::size_t k = random() % 5; k > 0; --k)
      list.push_back(randomJson(random, depth + 1));
    return list;
  }
  default: {
    Json object = Json::object();
    for (std::size_t k = random() % 5; k > 0; --k)
      object[std::to_string(random() % 1000) + "\xc3\xa9"] = randomJson(random, depth + 1);
    return object;
  }
  }
}

} // namespace

TEST_CASE("adding a noise leaves the other chunks and text of a GLB unchanged") {
  const Folder folder;
  const TinyScene tiny = example::tableScene();
  std::vector<std::byte> glb = tiny.glb();
  // A chunk of unknown type.
  const std::array<std::uint32_t, 3> other{4, 0x4C414953u, 77};
  const auto otherBytes = std::as_bytes(std::span(other));
  glb.insert(glb.end(), otherBytes.begin(), otherBytes.end());
  const auto size = std::uint32_t(glb.size());
  std::memcpy(glb.data() + 8, &size, sizeof size);
  const std::filesystem::path path = folder.write("scene.glb", glb);
  applyAndWrite(openScene(path), example::smallest(), folder.path("out.glb"));

  const std::vector<std::byte> out = bytesOf(folder.path("out.glb"));
  CHECK(std::equal(otherBytes.begin(), otherBytes.end(), out.end() - 12));
  const std::vector<std::byte> before = chunkOf(glb), after = chunkOf(out);
  REQUIRE(after.size() > before.size());
  CHECK(std::equal(before.begin(), before.end(), after.begin()));
  json document = documentOf(out);
  document["materials"][0].erase("extensions");
  for (const char* key : {"extensions", "extensionsUsed"})
    document.erase(key);
  document["bufferViews"].erase(document["bufferViews"].begin() + 6, document["bufferViews"].end());
  document["buffers"][0]["byteLength"] = tiny.binary.size();
  CHECK(document == documentOf(glb));
}

TEST_CASE("without a change the text of a scene keeps its indentation and every byte") {
  const Folder folder;
  const TinyScene tiny = example::tableScene();
  (void)folder.write("scene.bin", tiny.binary);
  const Json document = Json::parse(tiny.gltf("scene.bin"));
  const std::string tabs = document.dump(1, '\t');
  REQUIRE(tabs.find("\n\t\t") != std::string::npos);
  for (const std::string& text :
       {document.dump(), document.dump() + "\n", document.dump(0), document.dump(1),
        document.dump(2), document.dump(4) + "\n", document.dump(8), tabs, tabs + "\n"}) {
    REQUIRE(openScene(folder.write("scene.gltf", text)).write(folder.path("out.gltf")).ok());
    const std::vector<std::byte> out = bytesOf(folder.path("out.gltf"));
    CHECK(std::string(reinterpret_cast<const char*>(out.data()), out.size()) == text);
  }
}

TEST_CASE("a text that is indented very far is not") {
  const Folder folder;
  const std::string far(1000, ' ');
  const std::string text = "{\n" + far + R"("asset":{"version":"2.0"},"extras":[1,[2]]})";
  REQUIRE(openScene(folder.write("scene.gltf", text)).write(folder.path("out.gltf")).ok());
  CHECK(bytesOf(folder.path("out.gltf")).size() < 200);
}

TEST_CASE("any values of a scene stay what they are and in their order") {
  const Folder folder;
  std::mt19937_64 random(11);
  for (int round = 0; round < 60; ++round) {
    Json document = Json::parse(example::tableScene().gltf("absent.bin"));
    document["extras"] = randomJson(random, 0);
    document["materials"][1]["extras"] = randomJson(random, 0);
    const int indent = int(random() % 4) - 1;
    GltfScene scene = openScene(folder.write("scene.gltf", document.dump(indent)));
    scene.setFactor(1, "pbrMetallicRoughness", "roughnessFactor", {0.25});
    document["materials"][1]["pbrMetallicRoughness"]["roughnessFactor"] = 0.25;
    REQUIRE(scene.write(folder.path("out.gltf")).ok());
    const std::vector<std::byte> out = bytesOf(folder.path("out.gltf"));
    const auto* text = reinterpret_cast<const char*>(out.data());
    const Json written = Json::parse(text, text + out.size());
    CHECK(written == document);               // every value, in order
    CHECK(written.dump() == document.dump()); // and its type: 1 is not 1.0
  }
}

TEST_CASE("two members of one name are refused, and many members are no burden") {
  const Folder folder;
  const std::string start = R"({"asset":{"version":"2.0"},"extras":{"a":1,"b":{"a":2})";
  CHECK(openScene(folder.write("scene.gltf", start + "}}")).materialCount() == 0);
  const auto twice = GltfScene::open(folder.write("scene.gltf", start + R"(,"a":3}})"));
  REQUIRE(!twice.ok());
  CHECK(twice.error().kind == ErrorKind::badInput);
  CHECK_THAT(twice.error().message, Catch::Contains("two members \"a\""));
  constexpr int kMembers = 400000; // comparing each with each takes minutes
  std::string many = start;
  for (int i = 0; i < kMembers; ++i)
    many += ",\"" + std::to_string(i) + "\":0";
  const GltfScene scene = openScene(folder.write("scene.gltf", many + "}}"));
  CHECK(scene.document()["extras"].size() == kMembers + 2);
}

TEST_CASE("scenes with extensions of another type are refused") {
  const Folder folder;
  const auto refusal = [&](const auto& alter) {
    TinyScene scene = example::tableScene();
    alter(scene.json);
    const auto opened = GltfScene::open(folder.write("scene.glb", scene.glb()));
    REQUIRE(!opened.ok());
    return opened.error().message;
  };
  using Catch::EndsWith;
  CHECK_THAT(refusal([](Json& root) { root["extensions"] = Json::array(); }),
             EndsWith("/extensions: not an object"));
  CHECK_THAT(refusal([](Json& root) { root["extensionsUsed"] = "x"; }),
             EndsWith("/extensionsUsed: not an array"));
  CHECK_THAT(refusal([](Json& root) { root["materials"][1]["extensions"] = 5; }),
             EndsWith("/materials/1/extensions: not an object"));
  CHECK_THAT(refusal([](Json& root) { root["materials"][0]["pbrMetallicRoughness"] = "x"; }),
             EndsWith("/materials/0/pbrMetallicRoughness: not an object"));
}

TEST_CASE("a failure of any large allocation while a noise is applied is an error, and no file") {
  const Folder folder;
  TinyScene tiny = example::tableScene();
  constexpr std::size_t kLarge = 16384;
  (void)tiny.addView(std::vector<std::byte>(4 * kLarge));
  const BundleFile felt = example::smallest();
  const std::array<std::size_t, 1> materials{0};
  for (const char* name : {"out.glb", "out.gltf"}) {
    const std::filesystem::path out = folder.path(name);
    int failures = 0;
    for (int failing = 1;; ++failing) {
      GltfScene scene = openScene(folder.write("scene.glb", tiny.glb()));
      const test::ExhaustedMemory memory(failing, kLarge);
      Result<void> written;
      if (const auto applied = scene.applyNoise(felt.bundle, 0, {}, materials); !applied)
        written = applied.error();
      else
        written = scene.write(out);
      if (!memory.reached()) {
        CHECK(written.ok());
        break;
      }
      ++failures;
      test::ExhaustedMemory::spare();
      REQUIRE(!written.ok());
      CHECK(written.error().kind == ErrorKind::resources);
      CHECK(!std::filesystem::exists(out));
      test::ExhaustedMemory::refuse();
    }
    CHECK(failures >= 2);
  }
}

TEST_CASE("whichever allocation fails while a .gltf and its binary are written, none is left") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "pair.gltf";
  const std::vector<std::byte> binary(100);
  const std::string text =
      Json{{"asset", {{"version", "2.0"}}}, {"buffers", {{{"byteLength", 100}, {"uri", "x"}}}}}
          .dump();
  int failures = 0;
  for (int failing = 1;; ++failing) {
    bool isWritten = false, reached = false;
    {
      const test::ExhaustedMemory memory(failing);
      try {
        isWritten = writeGltfPair(path, text, binary).ok();
      } catch (const std::bad_alloc&) { // documented
      }
      reached = memory.reached();
    }
    if (!reached) {
      CHECK(isWritten);
      CHECK(folder.entryCount() == 2);
      break;
    }
    ++failures;
    INFO("allocation " << failing);
    REQUIRE(!isWritten);
    REQUIRE(folder.entryCount() == 0);
  }
  CHECK(failures > 10);
}

TEST_CASE("existing noises and tables of a scene are shared, names are not") {
  const Folder folder;
  const std::filesystem::path path = folder.write("scene.glb", example::tableScene().glb());
  const std::filesystem::path out = folder.path("out.glb");
  const BundleFile felt = example::smallest();
  applyAndWrite(openScene(path), felt, out);
  const std::size_t once = bytesOf(out).size();
  GltfScene again = openScene(out);
  const std::array<std::size_t, 1> second{1};
  const Result<AppliedNoise> same = again.applyNoise(felt.bundle, 0, {}, second);
  REQUIRE(same.ok());
  CHECK(!same.value().isNew);
  CHECK(same.value().newTables == 0);
  REQUIRE(again.write(out).ok());
  CHECK(bytesOf(out).size() < once + 100); // an extension object in a material

  BundleFile other = example::smallest();
  other.bundle.noises[0].tileSizeMetres = 3.0;
  GltfScene third = openScene(out);
  const Result<AppliedNoise> named = third.applyNoise(other.bundle, 0, {}, second);
  REQUIRE(named.ok());
  CHECK(named.value().isNew);
  CHECK(named.value().name == "felt-2");
  CHECK(named.value().newTables == 0); // the texels are the same
  REQUIRE(third.write(out).ok());
  const Bundle bundle = readBundle(out).value();
  CHECK(bundle.noises.size() == 2);
  CHECK(bundle.tables.size() == 2);
  CHECK(bundle.materials[0]->noise == 0);
  CHECK(bundle.materials[1]->noise == 1);
}

TEST_CASE("noises of a later revision are preserved") {
  const Folder folder;
  const std::filesystem::path path = folder.write("scene.glb", example::tableScene().glb());
  const std::filesystem::path out = folder.path("out.gltf");
  applyAndWrite(openScene(path), example::smallest(), out);
  json document = documentOf(bytesOf(out));
  json& extension = document["extensions"]["LICHEN_materials_exemplar_noise"];
  extension["noises"][0]["revision"] = 99;
  extension["noises"][0]["maps"] = "whatever";
  const json before = extension;
  GltfScene scene = openScene(folder.write("out.gltf", document.dump()));
  const std::array<std::size_t, 1> second{1};
  REQUIRE(scene.applyNoise(example::smallest().bundle, 0, {}, second).ok());
  REQUIRE(scene.write(out).ok());
  const json after = documentOf(bytesOf(out))["extensions"]["LICHEN_materials_exemplar_noise"];
  CHECK(after["noises"][0] == before["noises"][0]);
  CHECK(after["noises"][1]["name"] == "felt-2");
  CHECK(after["noises"][1]["maps"][0]["gaussian"] == 2);
  const Bundle bundle = readBundle(out).value();
  CHECK(bundle.noises.size() == 1);
  CHECK(bundle.ignoredNoises.size() == 1);
  CHECK(bundle.materials[1].has_value());
}

TEST_CASE(".glb and .gltf convert into each other, and a .glb embeds buffer and images") {
  const Folder folder;
  TinyScene tiny = example::tableScene();
  tiny.json["images"] = {{{"uri", "tiny%20picture.png"}, {"name", "p"}}};
  tiny.json["textures"] = {{{"source", 0}}};
  tiny.json["materials"][1]["emissiveTexture"] = {{"index", 0}};
  (void)folder.write("tiny picture.png", example::tinyPng());
  (void)folder.write("scene.bin", tiny.binary);
  const std::string text = tiny.gltf("scene.bin");
  const std::filesystem::path gltf = folder.write("scene.gltf", text);
  const BundleFile felt = example::smallest();

  applyAndWrite(openScene(gltf), felt, folder.path("out.glb"));
  const json glb = documentOf(bytesOf(folder.path("out.glb")));
  CHECK(!glb["buffers"][0].contains("uri"));
  CHECK(glb["buffers"].size() == 1);
  CHECK(glb["images"][0]["mimeType"] == "image/png");
  CHECK(!glb["images"][0].contains("uri"));
  const std::vector<std::byte> chunk = chunkOf(bytesOf(folder.path("out.glb")));
  CHECK(std::equal(tiny.binary.begin(), tiny.binary.end(), chunk.begin()));
  const json view = glb["bufferViews"][glb["images"][0]["bufferView"].get<std::size_t>()];
  const std::vector<std::byte> png = example::tinyPng();
  CHECK(
      std::equal(png.begin(), png.end(), chunk.begin() + view["byteOffset"].get<std::ptrdiff_t>()));

  applyAndWrite(openScene(gltf), felt, folder.path("out.gltf"));
  const std::vector<std::byte> out = bytesOf(folder.path("out.gltf"));
  const json pair = documentOf(out);
  REQUIRE(pair["buffers"].size() == 2);
  CHECK(pair["buffers"][0]["uri"] == "scene.bin");
  const auto binary = pair["buffers"][1]["uri"].get<std::string>();
  CHECK(std::filesystem::exists(folder.path(binary)));
  // All lines of the old text are lines of the new text, in order, except for commas.
  const std::string newText(reinterpret_cast<const char*>(out.data()), out.size());
  std::size_t at = 0;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    at = newText.find(text.substr(begin, end - begin), at);
    REQUIRE(at != std::string::npos);
  }
  // Written again without a noise: the noise's own names are gone, the scene's remain.
  REQUIRE(openScene(gltf).write(folder.path("out.gltf")).ok());
  CHECK(!std::filesystem::exists(folder.path(binary)));
  CHECK(std::filesystem::exists(folder.path("scene.bin")));
  CHECK(bytesOf(folder.path("out.gltf")) == bytesOf(gltf));

  const std::filesystem::path first = folder.write("first.glb", example::tableScene().glb());
  applyAndWrite(openScene(first), felt, folder.path("parted.gltf"));
  const json parted = documentOf(bytesOf(folder.path("parted.gltf")));
  REQUIRE(parted["buffers"].size() == 1);
  CHECK(parted["buffers"][0]["uri"].get<std::string>().starts_with("parted."));
}

TEST_CASE("an output in another folder is an error if the scene refers to files") {
  const Folder folder;
  const TinyScene tiny = example::tableScene();
  (void)folder.write("scene.bin", tiny.binary);
  const std::filesystem::path gltf = folder.write("scene.gltf", tiny.gltf("scene.bin"));
  std::filesystem::create_directory(folder.path("other"));
  const Result<void> refused = openScene(gltf).write(folder.path("other/out.gltf"));
  REQUIRE(!refused.ok());
  CHECK(refused.error().kind == ErrorKind::usage);
  CHECK_THAT(refused.error().message,
             Catch::Contains("scene.bin") && Catch::Contains("a .glb, or"));
  CHECK(std::filesystem::is_empty(folder.path("other")));
  TinyScene drawing = tiny; // its image stays outside a .glb too
  drawing.json["images"] = {{{"uri", "wood.png"}}};
  const auto beside =
      openScene(folder.write("drawing.glb", drawing.glb())).write(folder.path("other/out.gltf"));
  REQUIRE(!beside.ok());
  CHECK_THAT(beside.error().message, Catch::Contains("wood.png") && !Catch::Contains("a .glb, or"));
  applyAndWrite(openScene(gltf), example::smallest(), folder.path("other/out.glb"));
}

TEST_CASE("a scene without any buffer can have a noise") {
  const Folder folder;
  const std::string text = R"({"asset":{"version":"2.0"},"materials":[{}]})";
  const std::filesystem::path path = folder.write("scene.gltf", text);
  for (const char* output : {"out.glb", "out.gltf"})
    applyAndWrite(openScene(path), example::smallest(), folder.path(output));
}

TEST_CASE("added vertices can be read again") {
  const Folder folder;
  GltfScene scene = openScene(folder.write("scene.glb", example::tableScene().glb()));
  const std::vector<std::array<float, 3>> normals(4, {0.0f, 0.6f, 0.8f});
  const PrimitivePlace place{0, 1};
  CHECK(!scene.attribute(place, "NORMAL"));
  scene.setAttribute(place, "NORMAL", scene.addVertices(normals));
  CHECK(scene.attribute(place, "NORMAL") == 6);
  REQUIRE(scene.write(folder.path("out.glb")).ok());
  CHECK(openScene(folder.path("out.glb")).geometry(place).value().normals == normals);
}

TEST_CASE("a truncated or altered scene is read or refused, without any other effect") {
  const Folder folder;
  const std::filesystem::path out = folder.path("out.glb");
  applyAndWrite(openScene(folder.write("scene.glb", example::tableScene().glb())),
                example::smallest(), out);
  const std::vector<std::byte> whole = bytesOf(out);
  const BundleFile felt = example::smallest();
  int opened = 0;
  const auto attempt = [&](const std::vector<std::byte>& file) {
    // Without replaceFile(), which waits for the disk.
    std::ofstream(folder.path("scene.glb"), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), std::streamsize(file.size()));
    Result<GltfScene> scene = GltfScene::open(folder.path("scene.glb"));
    if (!scene)
      return false;
    for (std::size_t m = 0; m < scene.value().materialCount(); ++m) {
      for (const PrimitivePlace place : scene.value().primitivesOf(m))
        (void)scene.value().geometry(place).ok();
      const std::array<std::size_t, 1> material{m};
      (void)scene.value().applyNoise(felt.bundle, 0, {}, material).ok();
    }
    constexpr int kWritten = 20; // writes one in so many, because writing waits for the disk
    return opened++ % kWritten != 0 || (scene.value().write(out).ok() && checkBundle(out).ok());
  };
  REQUIRE(attempt(whole));
  std::mt19937 random(3);
  const std::size_t text =
      20 + std::to_integer<std::size_t>(whole[12]) + 256 * std::to_integer<std::size_t>(whole[13]);
  for (int round = 0; round < 150; ++round)
    CHECK(!attempt({whole.begin(), whole.begin() + std::ptrdiff_t(random() % whole.size())}));
  // Replaces one character of the text with another that JSON uses.
  const std::string characters = "0123456789-.,:[]{}\"\\aeE ";
  for (int round = 0; round < 1500; ++round) {
    std::vector<std::byte> altered = whole;
    altered[20 + random() % (text - 20)] = std::byte(characters[random() % characters.size()]);
    (void)attempt(altered);
  }
}
