// SPDX-License-Identifier: MIT
// File name -> words -> role. The words come from Poly Haven, ambientCG, FreePBR, 3dtextures.me,
// textures.com and glTF exporters, and plain ones.
#include "file_roles.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace lichen::exemplar {
namespace {

struct Phrase {
  std::string_view words; ///< joined, lower case
  FileRole role;
};

constexpr Phrase kPhrases[] = {
    {"diff", FileRole::baseColor},
    {"diffuse", FileRole::baseColor},
    {"col", FileRole::baseColor},
    {"color", FileRole::baseColor},
    {"colour", FileRole::baseColor},
    {"albedo", FileRole::baseColor},
    {"basecolor", FileRole::baseColor},
    {"basecolour", FileRole::baseColor},
    {"nor", FileRole::normal},
    {"norm", FileRole::normal},
    {"normal", FileRole::normal},
    {"norgl", FileRole::normalGl},
    {"normalgl", FileRole::normalGl},
    {"normalogl", FileRole::normalGl},
    {"normalopengl", FileRole::normalGl},
    {"nordx", FileRole::normalDx},
    {"normaldx", FileRole::normalDx},
    {"normaldirectx", FileRole::normalDx},
    {"ao", FileRole::occlusion},
    {"occ", FileRole::occlusion},
    {"occlusion", FileRole::occlusion},
    {"ambientocclusion", FileRole::occlusion},
    {"rough", FileRole::roughness},
    {"roughness", FileRole::roughness},
    {"metal", FileRole::metallic},
    {"metallic", FileRole::metallic},
    {"metalness", FileRole::metallic},
    {"arm", FileRole::occlusionRoughnessMetallic},
    {"orm", FileRole::occlusionRoughnessMetallic},
    {"aoroughmetal", FileRole::occlusionRoughnessMetallic},
    {"occlusionroughnessmetallic", FileRole::occlusionRoughnessMetallic},
    {"metallicroughness", FileRole::roughnessMetallic},
    {"roughnessmetallic", FileRole::roughnessMetallic},
    {"emissive", FileRole::emissive},
    {"emission", FileRole::emissive},
    {"emissivecolor", FileRole::emissive},
    {"emissioncolor", FileRole::emissive},
    {"disp", FileRole::height},
    {"displacement", FileRole::height},
    {"height", FileRole::height},
    {"opacity", FileRole::opacity},
    {"alpha", FileRole::opacity},
};
constexpr std::size_t kMostWords = 3; // as in "occlusion roughness metallic"

/// Returns whether a word says nothing about the role. These are words for resolution, format,
/// version and number after the role, such as "2k", "2048px", "16bit", "PNG", "v2", "LOD0" and
/// "01", and the "map" of "normal map".
bool isSkipped(const std::string& word) {
  constexpr std::string_view kFormats[] = {"png", "jpg", "jpeg", "exr", "tif", "tiff", "tga"};
  constexpr std::string_view kNumbered[] = {"v", "lod"};
  if (std::isdigit(static_cast<unsigned char>(word.front())) != 0 || word == "map" ||
      std::find(std::begin(kFormats), std::end(kFormats), word) != std::end(kFormats))
    return true;
  const std::size_t digits = word.find_last_not_of("0123456789") + 1;
  return digits < word.size() &&
         std::find(std::begin(kNumbered), std::end(kNumbered),
                   std::string_view(word).substr(0, digits)) != std::end(kNumbered);
}

bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool isLower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Returns whether a word begins with the capital at `i`, such as the G of "normalGL" or the R of
/// "AORoughness".
bool beginsAtCapital(std::string_view text, std::size_t i) {
  return i > 0 && isUpper(text[i]) &&
         (isLower(text[i - 1]) ||
          (isUpper(text[i - 1]) && i + 1 < text.size() && isLower(text[i + 1])));
}

std::vector<std::string> lowerCaseWords(std::string_view text) {
  std::vector<std::string> words;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool partOfWord = isWordCharacter(text[i]);
    if (partOfWord && (!inside || beginsAtCapital(text, i)))
      words.emplace_back();
    if (partOfWord)
      words.back() += char(std::tolower(static_cast<unsigned char>(text[i])));
    inside = partOfWord;
  }
  return words;
}

/// The parts of a file name.
struct NameParts {
  std::vector<std::string> before; ///< the words before the role
  std::optional<FileRole> role;
};

NameParts taken(std::string_view stem) {
  std::vector<std::string> words = lowerCaseWords(stem);
  while (!words.empty() && isSkipped(words.back()))
    words.pop_back();
  for (std::size_t count = std::min(kMostWords, words.size()); count > 0; --count) {
    std::string joined;
    for (std::size_t w = words.size() - count; w < words.size(); ++w)
      joined += words[w];
    const auto found = std::find_if(std::begin(kPhrases), std::end(kPhrases),
                                    [&](const Phrase& p) { return p.words == joined; });
    if (found == std::end(kPhrases))
      continue;
    words.resize(words.size() - count);
    return {std::move(words), found->role};
  }
  return {};
}

/// Returns whether a skipped word belongs to the material's name, such as the number of "rock_02".
bool isNumber(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

} // namespace

std::optional<FileRole> fileRole(std::string_view stem) { return taken(stem).role; }

std::string wordsBeforeRole(std::string_view stem) {
  std::string joined;
  for (const std::string& word : taken(stem).before)
    if (!isSkipped(word) || isNumber(word))
      joined += word;
  return joined;
}

} // namespace lichen::exemplar
