// SPDX-License-Identifier: MIT
// Checks docs/theory.md against the sources: the names on the page exist in the code, and the
// citations in the code are on the page.
#include "checkout_paths.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const fs::path kRepository = lichen::sourcePath("");

/// The project's C++ and GLSL sources, by path relative to the root.
const std::map<std::string, std::string>& sources() {
  static const std::map<std::string, std::string> all = [] {
    const std::set<std::string> extensions{".cpp", ".h", ".c", ".glsl", ".comp", ".frag", ".vert"};
    std::map<std::string, std::string> found;
    for (const char* folder : {"analysis", "bundle", "bundle_files", "engine_plugin", "files",
                               "image", "result", "samples", "shaders_glsl", "tests"})
      for (const auto& entry : fs::recursive_directory_iterator(kRepository / folder))
        if (extensions.count(entry.path().extension().string()) == 1)
          found[entry.path().lexically_relative(kRepository).generic_string()] =
              textOf(entry.path());
    return found;
  }();
  return all;
}

const std::string& theory() {
  static const std::string page = textOf(kRepository / "docs/theory.md");
  return page;
}

const std::regex kWord("[A-Za-z_]\\w*");

std::string withoutComments(const std::string& source) {
  static const std::regex comment("//[^\n]*");
  return std::regex_replace(source, comment, "");
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_token_iterator(text.begin(), text.end(), pattern),
          std::sregex_token_iterator()};
}

} // namespace

TEST_CASE("every name in docs/theory.md is in the file that it states") {
  std::map<std::string, std::set<std::string>> words; // of the code of each file
  for (const auto& [path, text] : sources())
    if (path.rfind("tests/", 0) != 0 && path.rfind("samples/", 0) != 0)
      words[path] = matches(withoutComments(text), kWord);
  const std::regex named("`([A-Za-z_][\\w:]*)`(?: \\(([a-z_]+/[\\w/.]+)\\))?");
  const std::string& page = theory();
  std::size_t count = 0;
  for (std::sregex_iterator hit(page.begin(), page.end(), named), end; hit != end; ++hit, ++count) {
    const std::string name = (*hit)[1];
    const std::string place = (*hit)[2];
    INFO(name << (place.empty() ? "" : " in ") << place);
    const std::set<std::string> parts = matches(name, kWord); // all must be in one file
    bool found = false;
    for (const auto& [path, known] : words)
      found = found || ((place.empty() || path == place) && std::ranges::includes(known, parts));
    CHECK(found);
  }
  CHECK(count > 20); // the pattern still matches the page
}

TEST_CASE("every file that docs/theory.md names exists") {
  const std::regex path("\\b(?:analysis|bundle|docs|shaders_glsl|tests)/[\\w/.]*\\w");
  for (const std::string& name : matches(theory(), path)) {
    INFO(name);
    CHECK(fs::exists(kRepository / name));
  }
}

TEST_CASE("every citation is in the bibliography of docs/theory.md, by its key") {
  const std::size_t start = theory().find("## Bibliography");
  REQUIRE(start != std::string::npos);
  const std::regex key("\\[[A-Z]{1,4}[0-9]{2}\\]");
  const std::set<std::string> known = matches(theory().substr(start), key);
  // A source cited by author and year instead of by key.
  const std::regex longForm("\\[[A-Z][a-z]+[^\\]\n]* (18|19|20)[0-9]{2}");
  std::set<std::string> used = matches(theory().substr(0, start), key);
  for (const auto& [path, text] : sources()) {
    INFO(path);
    for (const std::string& citation : matches(text, key)) {
      INFO(citation);
      CHECK(known.count(citation) == 1);
      used.insert(citation);
    }
    // The renderer has sources of its own, and its comments name them in full.
    if (path.rfind("samples/", 0) != 0)
      CHECK(matches(text, longForm) == std::set<std::string>{});
  }
  for (const std::string& entry : known) {
    INFO(entry << " stands in the bibliography and is cited nowhere");
    CHECK(used.count(entry) == 1);
  }
}
