// SPDX-License-Identifier: MIT
// docs/architecture.md against the sources: which files name a method, and who includes whom; and
// docs/library.md against its example; and the links of all pages.
#include "checkout_paths.h"

#include <lichen/bundle.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace lichen;

namespace {

std::string textOf(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Our own C++, by path relative to the root. Not shaders and tests, which have folders by method.
std::map<std::string, std::string> sources() {
  std::map<std::string, std::string> texts;
  for (const char* folder :
       {"analysis", "bundle", "bundle_files", "engine_plugin", "image", "files", "samples"})
    for (const auto& entry : fs::recursive_directory_iterator(sourcePath(folder)))
      if (const fs::path extension = entry.path().extension();
          extension == ".cpp" || extension == ".h")
        texts[fs::relative(entry.path(), sourcePath("")).generic_string()] = textOf(entry.path());
  return texts;
}

/// A method's name in code: local-random-phase, local_random_phase and LocalRandomPhase alike.
std::regex nameIn(Method method) {
  return std::regex(std::regex_replace(std::string(nameOf(method)), std::regex("-"), "[-_]?"),
                    std::regex::icase);
}

/// With _ for -, as in folders and files.
std::string fileNameOf(Method method) {
  std::string name(nameOf(method));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Whether a file belongs to a method: its folder or its name has the name of the method.
bool belongsToMethod(const std::string& path) {
  for (const Method method : allMethods())
    for (const char* end : {"/", "_", "."})
      if (path.find("/" + fileNameOf(method) + end) != std::string::npos)
        return true;
  return false;
}

bool namesMethod(const std::string& text) {
  static const std::regex unrelated(
      "//[^\n]*|/\\*[^]*?\\*/|VK_\\w*|optimalTiling\\w*|info\\.tiling");
  const std::string code = std::regex_replace(text, unrelated, "");
  for (const Method method : allMethods())
    if (std::regex_search(code, nameIn(method)))
      return true;
  return false;
}

} // namespace

TEST_CASE("the files that name a method are those that docs/architecture.md lists") {
  std::set<std::string> listed, found;
  const std::string page = textOf(sourcePath("docs/architecture.md"));
  const std::regex row("\n\\| `([\\w/.]+\\.(?:cpp|h))` \\|");
  const std::string list = page.substr(page.find("## Files outside a method's folders"));
  for (std::sregex_iterator hit(list.begin(), list.end(), row), end; hit != end; ++hit)
    listed.insert((*hit)[1]);
  for (const auto& [path, text] : sources())
    if (!belongsToMethod(path) && path.find("samples/exemplars/") != 0 && namesMethod(text))
      found.insert(path);
  CHECK(found == listed);
}

TEST_CASE("no method's folder includes another's") {
  const std::regex include("#include [<\"](?:lichen/|methods/)?(\\w+)");
  for (const auto& [path, text] : sources())
    for (const Method method : allMethods()) {
      if (path.find("/" + fileNameOf(method) + "/") == std::string::npos)
        continue;
      for (std::sregex_iterator hit(text.begin(), text.end(), include), end; hit != end; ++hit)
        for (const Method other : allMethods()) {
          INFO(path << " includes " << (*hit)[1]);
          CHECK((other == method || (*hit)[1].str().rfind(fileNameOf(other), 0) != 0));
        }
    }
}

TEST_CASE("the reader of bundles knows no files, and no JSON type in its public headers") {
  const std::regex files("#include <(filesystem|fstream|cstdio)>"), json("nlohmann");
  for (const auto& [path, text] : sources()) {
    INFO(path);
    CHECK((path.find("bundle/") != 0 || !std::regex_search(text, files)));
    CHECK((path.find("bundle/include/") != 0 || !std::regex_search(text, json)));
  }
}

TEST_CASE("only the command names its options in messages") {
  // Not custom properties of a style sheet, "--width:{}".
  const std::regex option("\"[^\"\n]*--[a-z]+\\b(?!:\\{)[^\"\n]*\"");
  for (const auto& [path, text] : sources()) {
    const bool isCommand = path.find("/cli/") != std::string::npos || path.find("samples/") == 0;
    INFO(path);
    std::smatch found;
    CHECK((isCommand || !std::regex_search(text, found, option)));
  }
}

TEST_CASE("docs/library.md shows the sample that is built") {
  const std::string code = textOf(sourcePath("samples/library/bake_material.cpp"));
  const std::string page = textOf(sourcePath("docs/library.md"));
  CHECK(page.find(code.substr(code.find("#include"))) != std::string::npos);
}

TEST_CASE("every relative link of a page points to a file of the checkout") {
  std::vector<fs::path> pages{sourcePath("README.md"), sourcePath("shaders_glsl/README.md")};
  for (const auto& entry : fs::recursive_directory_iterator(sourcePath("docs")))
    if (entry.path().extension() == ".md")
      pages.push_back(entry.path());
  const std::regex link("\\]\\(([^)#: ]+)(?:#[^)]*)?\\)|(?:src|href)=\"([^\"#:]+)\"");
  std::size_t links = 0;
  for (const fs::path& page : pages) {
    const std::string text = textOf(page);
    for (std::sregex_iterator hit(text.begin(), text.end(), link), end; hit != end; ++hit) {
      const std::string target = (*hit)[1].str() + (*hit)[2].str();
      INFO(page.string() << ": " << target);
      CHECK(fs::exists(page.parent_path() / target));
      ++links;
    }
  }
  CHECK(links > 100);
}
