// SPDX-License-Identifier: MIT
#include "command_run.h"

#include "checkout_paths.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <numbers>
#include <pty.h>
#include <span>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lichen::cli_test {
namespace {

std::string textOf(const std::filesystem::path& path) {
  const Result<std::vector<std::byte>> bytes = readFile(path);
  REQUIRE(bytes);
  std::string text(bytes.value().size(), '\0');
  std::transform(bytes.value().begin(), bytes.value().end(), text.begin(),
                 [](std::byte b) { return char(b); });
  return text;
}

/// A pseudo-terminal: the program writes to it, and the test reads it.
struct Terminal {
  int ours = -1;
  int theirs = -1;
};

Terminal openTerminal() {
  Terminal terminal;
  REQUIRE(::openpty(&terminal.ours, &terminal.theirs, nullptr, nullptr, nullptr) == 0);
  return terminal;
}

/// Reads until the last program that has the terminal open ends, then closes it.
std::string readTerminal(const Terminal& terminal) {
  ::close(terminal.theirs);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t got; (got = ::read(terminal.ours, buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), std::size_t(got));
  ::close(terminal.ours);
  return text;
}

/// Runs in the child process and never returns.
[[noreturn]] void become(const std::filesystem::path& program, const Arguments& arguments,
                         const Limits& limits, const std::filesystem::path& output,
                         const std::filesystem::path& errors, const Terminal& terminal) {
  const auto redirect = [](const std::filesystem::path& path, int descriptor) {
    ::dup2(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), descriptor);
  };
  redirect(limits.fullOutput ? "/dev/full" : output, STDOUT_FILENO);
  if (limits.terminal)
    ::dup2(terminal.theirs, STDERR_FILENO);
  else
    redirect(errors, STDERR_FILENO);
  if (limits.memoryBytes > 0) {
    const rlimit limit{limits.memoryBytes, limits.memoryBytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  Arguments words = Arguments{program.string()} + arguments;
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  ::_exit(127); // the shell's code for a missing program
}

std::string joined(const Arguments& arguments) {
  std::string line;
  for (const std::string& argument : arguments)
    line += " " + argument;
  return line;
}

} // namespace

Arguments operator+(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Ended run(const std::filesystem::path& program, const Arguments& arguments, const Limits& limits) {
  const TemporaryFolder folder;
  const std::filesystem::path output = folder.path() / "output";
  const std::filesystem::path errors = folder.path() / "errors";
  const Terminal terminal = limits.terminal ? openTerminal() : Terminal{};
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0)
    become(program, arguments, limits, output, errors, terminal);
  if (limits.killedAfterMs > 0) {
    ::usleep(limits.killedAfterMs * 1000);
    ::kill(child, limits.signal);
  }
  Ended ended;
  if (limits.terminal)
    ended.errors = readTerminal(terminal);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  // A child that was killed early may not have created these files.
  ended.output = std::filesystem::exists(output) ? textOf(output) : "";
  if (std::filesystem::exists(errors))
    ended.errors = textOf(errors);
  return ended;
}

Ended runLichen(const Arguments& arguments, const Limits& limits) {
  return run(programPath("lichen"), arguments, limits);
}

std::string Workplace::path(const std::string& name) const {
  return (folder_.path() / name).string();
}

std::string Workplace::write(const std::string& name, const std::vector<std::byte>& bytes) const {
  REQUIRE(replaceFile(path(name), bytes));
  return path(name);
}

std::string Workplace::write(const std::string& name, const std::string& text) const {
  REQUIRE(replaceFile(path(name), std::as_bytes(std::span(text))));
  return path(name);
}

std::string Workplace::write(const std::string& name, const SrgbImage& image) const {
  REQUIRE(writeImage(path(name), image));
  return path(name);
}

std::string Workplace::write(const std::string& name, const LinearImage& image) const {
  REQUIRE(writeImage(path(name), image));
  return path(name);
}

std::string Workplace::read(const std::string& name) const { return textOf(path(name)); }

std::vector<std::string> Workplace::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

SrgbImage brickwork(int side) {
  constexpr int kWidth = 32, kHeight = 16, kJoint = 3;
  SrgbImage image(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int row = y / kHeight;
      const int along = (x + row % 2 * kWidth / 2) % side;
      const bool isJoint = y % kHeight < kJoint || along % kWidth < kJoint;
      const auto brick = std::uint32_t(row * side + along / kWidth);
      const float grey = float((brick * 2654435761u) >> 24u) / 255.0f;
      *image.pixel(x, y) = isJoint ? 0.9f : 0.2f + 0.3f * grey;
    }
  return image;
}

SrgbImage framed(SrgbImage image, int left, int top, int right) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (x < left || x >= image.width - right || y < top)
        std::fill_n(image.pixel(x, y), image.channels, 1.0f);
  return image;
}

SrgbImage speckled(int width, int height, int channels) {
  LinearImage noise(width, height, 1);
  std::uint32_t state = 1;
  for (float& value : noise.values) {
    state = state * 1664525u + 1013904223u; // Numerical Recipes, eq. 7.1.6
    value = float(state >> 24) / 255.0f;
  }
  SrgbImage image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int right = (x + 1) % width, below = (y + 1) % height;
      const float mean = 0.25f * (*noise.pixel(x, y) + *noise.pixel(right, y) +
                                  *noise.pixel(x, below) + *noise.pixel(right, below));
      const float light = mean < 0.5f ? 0.3f * mean : 0.4f + 0.6f * mean;
      for (int c = 0; c < channels; ++c)
        image.pixel(x, y)[c] = 0.1f + 0.2f * float(c) + (0.6f - 0.15f * float(c)) * light;
    }
  return image;
}

SrgbImage smooth(int side) {
  SrgbImage image(side, side, 3);
  const double turn = 2.0 * std::numbers::pi / side;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c) {
        const double wave = std::sin(turn * (2 * x + y) + c) + std::cos(turn * (3 * y - x) - c) +
                            std::sin(turn * (2 * y + 1) + 2.0 * std::sin(turn * x));
        image.pixel(x, y)[c] = float(0.5 + 0.15 * wave);
      }
  return image;
}

SrgbImage smoothGrey(int side) {
  const SrgbImage colour = smooth(side);
  SrgbImage grey(side, side, 1);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    grey.values[i] = colour.values[3 * i];
  return grey;
}

std::vector<double> meanOf(const SrgbImage& image) {
  std::vector<double> mean(std::size_t(image.channels), 0.0);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    mean[i % mean.size()] += double(image.values[i]) / double(image.pixelCount());
  return mean;
}

Ended succeed(const Arguments& arguments) {
  Ended ended = runLichen(arguments);
  INFO("lichen" << joined(arguments) << "\n" << ended.errors);
  REQUIRE(ended.code == 0);
  return ended;
}

nlohmann::json jsonOf(const Arguments& arguments) {
  const Ended ended = succeed(arguments + Arguments{"--json"});
  CHECK(ended.errors.empty());
  return nlohmann::json::parse(ended.output);
}

std::string bake(const Workplace& workplace, const std::string& input, const std::string& name,
                 const Arguments& more) {
  succeed(Arguments{"bake", input, "-o", workplace.path(name)} + more);
  return workplace.path(name);
}

SrgbImage synth(const Workplace& workplace, const std::string& bundle, const Arguments& more) {
  succeed(Arguments{"synth", bundle, "-o", workplace.path("synth.png")} + more);
  const Result<ImageFile> file = readImage(workplace.path("synth.png"));
  REQUIRE(file);
  return std::get<SrgbImage>(file.value().pixels);
}

void checkRefusal(const Arguments& arguments, int code, const std::vector<std::string>& words) {
  const Ended ended = runLichen(arguments);
  INFO("lichen" << joined(arguments) << "\n" << ended.errors);
  CHECK(ended.code == code);
  CHECK(ended.output.empty());
  CHECK(std::count(ended.errors.begin(), ended.errors.end(), '\n') == 1);
  for (const std::string& word : words)
    CHECK_THAT(ended.errors, Catch::Contains(word));
}

void checkRefusals(const Arguments& first, const std::vector<Refused>& rows) {
  for (const Refused& row : rows)
    checkRefusal(first + row.arguments, row.code, row.words);
}

void checkRefusals(const Arguments& first, const std::vector<RefusedValues>& rows) {
  for (const RefusedValues& row : rows)
    for (const std::string& value : row.values)
      checkRefusal(first + Arguments{row.option, value}, kUsage,
                   {row.option + " " + value + ": expected " + row.expected});
}

} // namespace lichen::cli_test
