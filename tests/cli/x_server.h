// SPDX-License-Identifier: MIT
// An X server without a screen, programs that show themselves there, and a user at its keyboard.
#pragma once

#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace lichen::cli_test {

/// Whether the condition comes to hold, within a time that no machine should need.
[[nodiscard]] bool eventually(const std::function<bool()>& condition);

/// Ended with its object, if it has not ended by itself.
class RunningProgram {
public:
  RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& display, const std::string& output, const std::string& errors);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  /// The exit status; -1 where a signal ended it.
  int wait();

private:
  pid_t process_ = -1;
};

/// Each function acts on the window that was awaited, and fails the test where it cannot.
class XServer {
public:
  XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;
  ~XServer();

  [[nodiscard]] const std::string& name() const { return name_; } ///< such as ":1"
  /// A window whose title begins so.
  void awaitWindow(const std::string& title);
  void pressKey(char letter, bool shift);
  /// With the left button, from the middle.
  void drag(int right, int down);
  /// What the window shows, which has this size: red, green and blue, row by row.
  [[nodiscard]] std::vector<unsigned char> pixels(unsigned width, unsigned height);
  void resizeWindow(unsigned width, unsigned height);
  /// As the close button of its frame does.
  void closeWindow();

private:
  void send(long mask, void* event);

  pid_t process_ = -1;
  std::string name_;
  void* display_ = nullptr;
  unsigned long window_ = 0;
  unsigned long time_ = 1; ///< of events, in milliseconds: GLFW drops those of one time
};

} // namespace lichen::cli_test
