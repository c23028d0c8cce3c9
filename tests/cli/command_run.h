// SPDX-License-Identifier: MIT
// The `lichen` command run as a user runs it, in a folder of the test's own.
#pragma once

#include <lichen/image.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <temporary_folder.h>
#include <vector>

namespace lichen::cli_test {

using Arguments = std::vector<std::string>;

/// How a program ended, and what it wrote.
struct Ended {
  int code = -1; ///< the exit status; -1 when a signal ended it
  std::string output;
  std::string errors;
};

struct Limits {
  std::size_t fileBytes = 0;   ///< writing beyond fails, as on a full disk; 0 for no limit
  std::size_t memoryBytes = 0; ///< of address space; 0 for no limit
  unsigned killedAfterMs = 0;  ///< `signal` then; 0 for never
  int signal = SIGTERM;
  bool terminal = false;   ///< standard error is one
  bool fullOutput = false; ///< standard output takes nothing, as on a full disk
};

/// Runs a program and waits for its end.
[[nodiscard]] Ended run(const std::filesystem::path& program, const Arguments& arguments,
                        const Limits& limits = {});
/// As above: the `lichen` of this build.
[[nodiscard]] Ended runLichen(const Arguments& arguments, const Limits& limits = {});

/// A folder of the test's own with files of its own.
class Workplace {
public:
  [[nodiscard]] std::string path(const std::string& name) const;
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::vector<std::byte>& bytes) const;
  std::string write(const std::string& name, const std::string& text) const;
  std::string write(const std::string& name, const SrgbImage& image) const;
  std::string write(const std::string& name, const LinearImage& image) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const; ///< of all entries, sorted

private:
  TemporaryFolder folder_;
};

/// Speckles one or two texels wide, dark or light and little between; every channel different.
[[nodiscard]] SrgbImage speckled(int width, int height, int channels);
/// Smooth blobs of many colours that continue over opposite borders, several texels wide.
[[nodiscard]] SrgbImage smooth(int side);
/// Its first channel, as a grey image: baked in no time, where the colour does not matter.
[[nodiscard]] SrgbImage smoothGrey(int side);
/// The mean of each channel, in the image's own encoding.
[[nodiscard]] std::vector<double> meanOf(const SrgbImage& image);

/// Runs `lichen bake` with these arguments after the input and output, and requires that it
/// succeeds. Returns the bundle's path.
std::string bake(const Workplace& workplace, const std::string& input,
                 const std::string& name = "noise.glb", const Arguments& more = {});
/// Runs `lichen synth` and requires that it succeeds. Returns the image, sRGB.
SrgbImage synth(const Workplace& workplace, const std::string& bundle, const Arguments& more);

/// Checks that `lichen` ends with `code`, writes nothing on standard output and one line on
/// standard error that has each of `words`.
void checkRefusal(const Arguments& arguments, int code, const std::vector<std::string>& words);

} // namespace lichen::cli_test
