// SPDX-License-Identifier: MIT
// An X server without a screen, the programs that open windows on it, and simulated user input.
#pragma once

#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace lichen::cli_test {

/// Waits for the condition. Returns false if it does not hold within a time that is ample on any
/// machine.
[[nodiscard]] bool eventually(const std::function<bool()>& condition);

/// A child process. The destructor ends it if it is still running.
class RunningProgram {
public:
  RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& display, const std::string& output, const std::string& errors);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  /// Waits, and returns the exit status; -1 if a signal ended the program.
  int wait();

private:
  pid_t process_ = -1;
};

/// Every function acts on the window of awaitWindow(), and fails the test if it cannot.
class XServer {
public:
  XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;
  ~XServer();

  [[nodiscard]] const std::string& name() const { return name_; } ///< such as ":1"
  /// Waits for a window whose title starts with `title`.
  void awaitWindow(const std::string& title);
  void pressKey(char letter, bool shift);
  /// Drags with the left button, from the centre of the window; in pixels.
  void drag(int right, int down);
  /// The window's pixels as red, green and blue, row by row. `width` and `height` are the window's
  /// size.
  [[nodiscard]] std::vector<unsigned char> pixels(unsigned width, unsigned height);
  void resizeWindow(unsigned width, unsigned height);
  /// Closes the window as the close button of its frame does.
  void closeWindow();

private:
  void send(long mask, void* event);

  pid_t process_ = -1;
  std::string name_;
  void* display_ = nullptr;
  unsigned long window_ = 0;
  unsigned long time_ = 1; ///< of the last event, in ms; GLFW drops events with equal times
};

} // namespace lichen::cli_test
