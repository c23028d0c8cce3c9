// SPDX-License-Identifier: MIT
// Folders and files -> one file for each map, or an error that says why the names do not decide.
#include "set_files.h"

#include <lichen/counted.h>
#include <lichen/files.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace lichen::exemplar {

std::vector<std::string_view> slotsOf(FileRole role) {
  switch (role) {
  case FileRole::baseColor:
    return {"base colour"};
  case FileRole::normal:
  case FileRole::normalGl:
  case FileRole::normalDx:
    return {"normals"};
  case FileRole::occlusion:
    return {"occlusion"};
  case FileRole::roughness:
    return {"roughness"};
  case FileRole::metallic:
    return {"metallic"};
  case FileRole::occlusionRoughnessMetallic:
    return {"occlusion", "roughness", "metallic"};
  case FileRole::roughnessMetallic:
    return {"roughness", "metallic"};
  case FileRole::emissive:
    return {"emissive light"};
  case FileRole::height:
    return {"height"};
  case FileRole::opacity:
    break;
  }
  return {"opacity"};
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kNameWords =
    "a word such as diff, nor_gl, rough, metal, ao, arm, disp, emissive or opacity";

bool hasImageExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<std::string_view, 4> kExtensions{".png", ".jpg", ".jpeg", ".exr"};
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

/// Returns the images of a folder, without hidden files, whose names begin with a dot.
Result<std::vector<fs::path>> imagesIn(const fs::path& folder) {
  Result<std::vector<fs::path>> images = listFolder(folder);
  if (images)
    std::erase_if(images.value(), [](const fs::path& path) {
      return !hasImageExtension(path) || path.filename().string().starts_with('.');
    });
  return images;
}

/// Returns "rock_diff.png (base colour), IMG_1.png (no map) and 3 others".
std::string listOf(std::span<const fs::path> files) {
  constexpr std::size_t kMostNamed = 6;
  std::string list;
  for (const fs::path& file : files.first(std::min(files.size(), kMostNamed))) {
    const std::optional<FileRole> role = fileRole(file.stem().string());
    const std::string found = role ? fmt::format("{}", fmt::join(slotsOf(*role), ", ")) : "no map";
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", file.filename().string(), found);
  }
  const std::size_t others = files.size() - std::min(files.size(), kMostNamed);
  return others == 0 ? list : fmt::format("{} and {}", list, counted(others, "other"));
}

/// The error for several inputs of which `file` is no map.
Error noMapAmong(const fs::path& file, std::span<const fs::path> files) {
  return {ErrorKind::badInput,
          fmt::format("{}: its name does not say which map it is, and several images are baked as "
                      "the maps of one material: {}; bake one photograph at a time, blend "
                      "photographs with 'lichen mix', or put {} into each name",
                      file.string(), listOf(files), kNameWords)};
}

/// The error for folders without a map.
Error noMapIn(const fs::path& folder, std::span<const fs::path> files) {
  if (files.empty())
    return {ErrorKind::badInput, folder.string() + ": a folder without PNG, JPEG or EXR images"};
  return {ErrorKind::badInput,
          fmt::format("{}: a folder without a map: {}; bake one of its images as a photograph, or "
                      "put {} into the names of the maps",
                      folder.string(), listOf(files), kNameWords)};
}

/// Drops DirectX normals if there are OpenGL ones, because downloads often have both.
void dropSecondConvention(SetFiles& set) {
  const auto gl = std::find_if(set.files.begin(), set.files.end(),
                               [](const SetFile& file) { return file.role == FileRole::normalGl; });
  if (gl == set.files.end())
    return;
  const std::string kept = gl->path.filename().string();
  std::erase_if(set.files, [&](const SetFile& file) {
    if (file.role != FileRole::normalDx)
      return false;
    set.notes.push_back(file.path.filename().string() + " is not used: " + kept +
                        " has the normals in the OpenGL convention");
    return true;
  });
}

/// Returns the slots that a file fills in the end.
std::vector<std::string_view> slotsOf(const SetFile& file) {
  std::vector<std::string_view> slots = slotsOf(file.role);
  for (const FileRole other : file.leftOut)
    std::erase(slots, slotsOf(other).front());
  return slots;
}

/// Drops channels of packed files that separate files provide, because downloads often have both.
void preferOwnFiles(SetFiles& set) {
  for (SetFile& packed : set.files) {
    const std::vector<std::string_view> slots = slotsOf(packed.role);
    if (slots.size() < 2)
      continue;
    for (const SetFile& own : set.files) {
      const std::vector<std::string_view> one = slotsOf(own.role);
      const bool isLeftOut = std::find(packed.leftOut.begin(), packed.leftOut.end(), own.role) !=
                             packed.leftOut.end(); // by a second file; checkSlots() fails
      if (one.size() > 1 || isLeftOut ||
          std::find(slots.begin(), slots.end(), one.front()) == slots.end())
        continue;
      packed.leftOut.push_back(own.role);
      set.notes.push_back("the " + std::string(one.front()) + " of " +
                          packed.path.filename().string() +
                          " is not used: " + own.path.filename().string() + " has it");
    }
  }
  std::erase_if(set.files, [](const SetFile& file) { return slotsOf(file).empty(); });
}

Result<void> checkSlots(const std::vector<SetFile>& files) {
  for (std::size_t b = 1; b < files.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      for (const std::string_view slot : slotsOf(files[a])) {
        const std::vector<std::string_view> others = slotsOf(files[b]);
        if (std::find(others.begin(), others.end(), slot) != others.end())
          return Error{ErrorKind::badInput,
                       fmt::format("{}: a second file of {} beside {}; keep one of them, or blend "
                                   "two materials with 'lichen mix'",
                                   files[b].path.string(), slot,
                                   files[a].path.filename().string())};
      }
  return {};
}

/// Returns the folder's name, also for "." and "folder/".
std::string folderName(const fs::path& folder) {
  std::error_code ignored;
  fs::path whole = (fs::current_path(ignored) / folder).lexically_normal();
  if (!whole.has_filename())
    whole = whole.parent_path();
  return whole.filename().string();
}

/// Returns whether position `place` splits a word: letters or digits of one word are on both sides.
/// A capital after a small letter begins a new word. UTF-8 bytes beyond ASCII count as letters.
bool isInsideWord(const std::string& stem, std::size_t place) {
  if (place == 0 || place >= stem.size())
    return false;
  const auto before = static_cast<unsigned char>(stem[place - 1]);
  const auto after = static_cast<unsigned char>(stem[place]);
  const auto isOfWord = [](unsigned char c) { return c >= 128 || std::isalnum(c) != 0; };
  return isOfWord(before) && isOfWord(after) &&
         !(std::islower(before) != 0 && std::isupper(after) != 0);
}

/// Returns the words that the stems of all files begin with, without punctuation at the end. If
/// there are none, returns the first file's stem.
std::string commonName(const std::vector<fs::path>& files) {
  const std::string first = files.front().stem().string();
  std::size_t length = first.size();
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    const auto [end, ignored] = std::mismatch(first.begin(), first.begin() + std::ptrdiff_t(length),
                                              stem.begin(), stem.end());
    length = std::size_t(end - first.begin());
  }
  const auto cutsWord = [&](const fs::path& file) {
    return isInsideWord(file.stem().string(), length);
  };
  while (length > 0 && std::any_of(files.begin(), files.end(), cutsWord))
    --length;
  while (length > 0 && std::ispunct(static_cast<unsigned char>(first[length - 1])) != 0)
    --length;
  return length > 0 ? first.substr(0, length) : first;
}

bool hasMap(const std::vector<fs::path>& images) {
  return std::any_of(images.begin(), images.end(), [](const fs::path& image) {
    return fileRole(image.stem().string()).has_value();
  });
}

/// Returns the images of a folder. If none is a map, returns the images of its only subfolder with
/// maps.
Result<std::vector<fs::path>> materialIn(const fs::path& folder, std::vector<std::string>& notes) {
  Result<std::vector<fs::path>> images = imagesIn(folder);
  if (!images || hasMap(images.value()))
    return images;
  const Result<std::vector<fs::path>> entries = listFolder(folder);
  if (!entries)
    return entries.error();
  std::vector<std::string> names;
  std::vector<fs::path> inner;
  for (const fs::path& entry : entries.value()) {
    std::error_code ignored;
    if (entry.filename().string().starts_with('.') || !fs::is_directory(entry, ignored))
      continue;
    Result<std::vector<fs::path>> found = imagesIn(entry);
    if (!found || !hasMap(found.value())) // unreadable or unrelated folders are ignored
      continue;
    names.push_back(entry.filename().string());
    inner = std::move(found).value();
  }
  if (names.empty())
    return images;
  if (names.size() > 1) {
    std::string list;
    for (const std::string& name : names)
      list += (list.empty() ? "" : ", ") + name;
    return Error{ErrorKind::badInput, folder.string() +
                                          ": a folder without a map; choose one of the folders "
                                          "inside that have maps: " +
                                          list};
  }
  notes.push_back("the maps are read from the folder " + names.front());
  return inner;
}

/// The images of folders and the files named directly, with a flag for those from a folder.
struct Listed {
  std::vector<fs::path> files;
  std::vector<bool> fromFolder;
  std::vector<std::string> notes;
};

Result<Listed> listFiles(std::span<const fs::path> inputs) {
  Listed listed;
  for (const fs::path& input : inputs) {
    std::error_code ignored;
    const bool isFolder = fs::is_directory(input, ignored);
    if (!isFolder) {
      listed.files.push_back(input);
      listed.fromFolder.push_back(false);
      continue;
    }
    Result<std::vector<fs::path>> images = materialIn(input, listed.notes);
    if (!images)
      return images.error();
    listed.files.insert(listed.files.end(), images.value().begin(), images.value().end());
    listed.fromFolder.resize(listed.files.size(), true);
  }
  return listed;
}

/// The maps among the files of `inputs`.
Result<SetFiles> chosenOf(const Listed& listed, const fs::path& firstInput, FileRole plainNormal) {
  const std::vector<fs::path>& files = listed.files;
  SetFiles set;
  set.notes = listed.notes;
  if (files.size() == 1 && !listed.fromFolder.front()) {
    set.name = files.front().stem().string();
    const FileRole role = fileRole(set.name).value_or(FileRole::baseColor);
    set.files = {{files.front(), role == FileRole::normal ? plainNormal : role, {}}};
    set.isSingleImage = true;
    return set;
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string name = files[f].filename().string();
    if (const auto role = fileRole(files[f].stem().string()))
      set.files.push_back({files[f], *role == FileRole::normal ? plainNormal : *role, {}});
    else if (listed.fromFolder[f])
      set.notes.push_back(name + " is not used: its name does not say which map it is");
    else
      return noMapAmong(files[f], files);
  }
  if (set.files.empty())
    return noMapIn(firstInput, files);
  set.name = listed.fromFolder.front() ? folderName(firstInput) : commonName(files);
  dropSecondConvention(set);
  preferOwnFiles(set);
  if (Result<void> checked = checkSlots(set.files); !checked)
    return checked.error();
  return set;
}

Error noImage() { return {ErrorKind::usage, "no image to bake; expected at least one"}; }

} // namespace

Result<SetFiles> findSetFiles(std::span<const fs::path> inputs, FileRole plainNormal) {
  if (inputs.empty())
    return noImage();
  const Result<Listed> listed = listFiles(inputs);
  return listed ? chosenOf(listed.value(), inputs.front(), plainNormal) : listed.error();
}

Result<SetFiles> chooseSetFiles(std::span<const fs::path> files, FileRole plainNormal) {
  if (files.empty())
    return noImage();
  return chosenOf({{files.begin(), files.end()}, std::vector<bool>(files.size(), false), {}},
                  files.front(), plainNormal);
}

// File name -> words -> role. The words come from Poly Haven, ambientCG, FreePBR, 3dtextures.me,
// textures.com and glTF exporters, and plain ones.
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

} // namespace

std::optional<FileRole> fileRole(std::string_view stem) {
  std::vector<std::string> words = lowerCaseWords(stem);
  while (!words.empty() && isSkipped(words.back()))
    words.pop_back();
  for (std::size_t count = std::min(kMostWords, words.size()); count > 0; --count) {
    std::string joined;
    for (std::size_t w = words.size() - count; w < words.size(); ++w)
      joined += words[w];
    const auto found = std::find_if(std::begin(kPhrases), std::end(kPhrases),
                                    [&](const Phrase& p) { return p.words == joined; });
    if (found != std::end(kPhrases))
      return found->role;
  }
  return std::nullopt;
}

} // namespace lichen::exemplar
