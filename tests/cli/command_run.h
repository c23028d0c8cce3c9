// SPDX-License-Identifier: MIT
// Runs the `lichen` command as a user does, in a temporary folder of the test.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <nlohmann/json.hpp>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <temporary_folder.h>
#include <vector>

namespace lichen::cli_test {

using Arguments = std::vector<std::string>;

[[nodiscard]] Arguments operator+(Arguments first, const Arguments& second);

// Exit codes; docs/cli.md.
inline constexpr int kUsage = int(ErrorKind::usage);
inline constexpr int kBadInput = int(ErrorKind::badInput);
inline constexpr int kEnvironment = int(ErrorKind::environment);
inline constexpr int kResources = int(ErrorKind::resources);

/// How a program ended, and what it wrote.
struct Ended {
  int code = -1; ///< the exit status; -1 if a signal ended the program
  std::string output;
  std::string errors;
};

struct Limits {
  std::size_t memoryBytes = 0; ///< limit on the address space; 0 for no limit
  unsigned killedAfterMs = 0;  ///< send `signal` after this time; 0 for never
  int signal = SIGTERM;
  bool terminal = false;   ///< standard error is a terminal
  bool fullOutput = false; ///< writes to standard output fail, as on a full disk
};

/// Runs a program and waits until it ends.
[[nodiscard]] Ended run(const std::filesystem::path& program, const Arguments& arguments,
                        const Limits& limits = {});
/// As above, for the `lichen` program of this build.
[[nodiscard]] Ended runLichen(const Arguments& arguments, const Limits& limits = {});
/// Runs `lichen` and requires success.
Ended succeed(const Arguments& arguments);
/// The object that `lichen` prints with --json. Requires success.
[[nodiscard]] nlohmann::json jsonOf(const Arguments& arguments);

/// A temporary folder for one test.
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

/// Speckles one or two texels wide, mostly dark or light; every channel differs.
[[nodiscard]] SrgbImage speckled(int width, int height, int channels);
/// Returns the image with a white frame of these widths, and none at the bottom. [pixels]
[[nodiscard]] SrgbImage framed(SrgbImage image, int left, int top, int right);
/// A running bond of bricks of 32 x 16 pixels, each of another grey, with light joints. Tileable if
/// the side is a multiple of 32.
[[nodiscard]] SrgbImage brickwork(int side);
/// Smooth, tileable blobs of many colours, several texels wide.
[[nodiscard]] SrgbImage smooth(int side);
/// The first channel of smooth(), as a grey image: fast to bake, for tests where colour does not
/// matter.
[[nodiscard]] SrgbImage smoothGrey(int side);
/// The mean of each channel, in the image's own encoding.
[[nodiscard]] std::vector<double> meanOf(const SrgbImage& image);

/// Runs `lichen bake` with `more` after the input and output, and requires success. Returns the
/// path of the bundle.
std::string bake(const Workplace& workplace, const std::string& input,
                 const std::string& name = "noise.glb", const Arguments& more = {});
/// Runs `lichen synth` and requires success. Returns the sRGB image.
SrgbImage synth(const Workplace& workplace, const std::string& bundle, const Arguments& more);

/// Checks that `lichen` exits with `code`, writes nothing to standard output, and writes one line
/// to standard error that contains each of `words`.
void checkRefusal(const Arguments& arguments, int code, const std::vector<std::string>& words);

/// Arguments, and words of the line with which they are refused.
struct Refused {
  Arguments arguments;
  std::vector<std::string> words;
  int code = kUsage;
};
/// checkRefusal() for each row, with `first` before its arguments.
void checkRefusals(const Arguments& first, const std::vector<Refused>& rows);

/// Values of an option that are refused, with what is expected after the option and the value.
struct RefusedValues {
  std::string option;
  Arguments values;
  std::string expected;
};
/// checkRefusal() for each value, with `first` before the option.
void checkRefusals(const Arguments& first, const std::vector<RefusedValues>& rows);

} // namespace lichen::cli_test
