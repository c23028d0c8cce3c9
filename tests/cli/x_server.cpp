// SPDX-License-Identifier: MIT
// Events go directly to the window: no window manager gives it the focus.
#include "x_server.h"

#include <catch2/catch.hpp>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>
#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
// Xlib defines macros that collide with names of Catch2.
#undef None
#undef True

namespace lichen::cli_test {
namespace {

constexpr std::chrono::seconds kPatience{100}; // enough for a sanitizer build on a loaded machine
constexpr std::chrono::milliseconds kBetweenLooks{20};

Display* displayOf(void* display) { return static_cast<Display*>(display); }

/// Returns the first window below `parent` whose title starts with `title`, or 0.
Window findWindow(Display* display, Window parent, const std::string& title) {
  Window root = 0;
  Window itsParent = 0;
  Window* children = nullptr;
  unsigned count = 0;
  if (XQueryTree(display, parent, &root, &itsParent, &children, &count) == 0)
    return 0;
  Window found = 0;
  for (unsigned i = 0; i < count && found == 0; ++i) {
    char* name = nullptr;
    if (XFetchName(display, children[i], &name) != 0 && name != nullptr) {
      if (std::string(name).starts_with(title))
        found = children[i];
      XFree(name);
    }
  }
  if (children != nullptr)
    XFree(children);
  return found;
}

int statusOf(pid_t process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

bool eventually(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end)
      return false;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return true;
}

RunningProgram::RunningProgram(const std::string& program,
                               const std::vector<std::string>& arguments,
                               const std::string& display, const std::string& output,
                               const std::string& errors) {
  process_ = ::fork();
  REQUIRE(process_ >= 0);
  if (process_ > 0)
    return;
  ::setenv("DISPLAY", display.c_str(), 1);
  const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  ::_exit(127);
}

RunningProgram::~RunningProgram() {
  if (process_ < 0)
    return;
  ::kill(process_, SIGKILL);
  statusOf(process_);
}

int RunningProgram::wait() { return statusOf(std::exchange(process_, -1)); }

XServer::XServer() {
  std::array<int, 2> pipe{};
  REQUIRE(::pipe(pipe.data()) == 0);
  process_ = ::fork();
  REQUIRE(process_ >= 0);
  if (process_ == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDERR_FILENO);
    const std::string number = std::to_string(pipe[1]);
    ::execl(LICHEN_XVFB, LICHEN_XVFB, "-displayfd", number.c_str(), "-screen", "0", "640x480x24",
            "-nolisten", "tcp", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(pipe[1]);
  name_ = ":";
  for (char digit = 0; ::read(pipe[0], &digit, 1) == 1 && digit != '\n';)
    name_ += digit;
  ::close(pipe[0]);
  REQUIRE(name_.size() > 1);
  display_ = XOpenDisplay(name_.c_str());
  REQUIRE(display_ != nullptr);
}

XServer::~XServer() {
  if (display_ != nullptr)
    XCloseDisplay(displayOf(display_));
  ::kill(process_, SIGTERM);
  statusOf(process_);
}

void XServer::awaitWindow(const std::string& title) {
  Display* display = displayOf(display_);
  REQUIRE(eventually([&] {
    window_ = findWindow(display, DefaultRootWindow(display), title);
    return window_ != 0;
  }));
}

void XServer::send(long mask, void* event) {
  REQUIRE(XSendEvent(displayOf(display_), window_, 0, mask, static_cast<XEvent*>(event)) != 0);
  XSync(displayOf(display_), 0);
}

void XServer::pressKey(char letter, bool shift) {
  Display* display = displayOf(display_);
  XEvent event{};
  event.xkey.display = display;
  event.xkey.window = window_;
  event.xkey.root = DefaultRootWindow(display);
  event.xkey.same_screen = 1;
  event.xkey.state = shift ? unsigned(ShiftMask) : 0u;
  event.xkey.keycode = XKeysymToKeycode(display, XK_a + KeySym(letter - 'a'));
  for (const int type : {KeyPress, KeyRelease}) {
    event.type = type;
    event.xkey.time = ++time_;
    send(type == KeyPress ? KeyPressMask : KeyReleaseMask, &event);
  }
}

void XServer::drag(int right, int down) {
  constexpr int kStart = 30;
  XEvent event{};
  event.xbutton.display = displayOf(display_);
  event.xbutton.window = window_;
  event.xbutton.root = DefaultRootWindow(displayOf(display_));
  event.xbutton.same_screen = 1;
  const auto move = [&](int x, int y) {
    XEvent motion = event;
    motion.type = MotionNotify;
    motion.xmotion.time = ++time_;
    motion.xmotion.x = x;
    motion.xmotion.y = y;
    send(PointerMotionMask, &motion);
  };
  const auto click = [&](int type, int x, int y) {
    event.type = type;
    event.xbutton.time = ++time_;
    event.xbutton.button = Button1;
    event.xbutton.x = x;
    event.xbutton.y = y;
    send(type == ButtonPress ? ButtonPressMask : ButtonReleaseMask, &event);
  };
  move(kStart, kStart);
  click(ButtonPress, kStart, kStart);
  move(kStart + right, kStart + down);
  click(ButtonRelease, kStart + right, kStart + down);
}

std::vector<unsigned char> XServer::pixels(unsigned width, unsigned height) {
  constexpr unsigned long kAllPlanes = ~0ul;
  XImage* image = XGetImage(displayOf(display_), window_, 0, 0, width, height, kAllPlanes, ZPixmap);
  REQUIRE(image != nullptr);
  std::vector<unsigned char> codes;
  for (unsigned y = 0; y < height; ++y)
    for (unsigned x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, int(x), int(y));
      for (const int shift : {16, 8, 0})
        codes.push_back(static_cast<unsigned char>(pixel >> shift));
    }
  XDestroyImage(image);
  return codes;
}

void XServer::resizeWindow(unsigned width, unsigned height) {
  XResizeWindow(displayOf(display_), window_, width, height);
  XSync(displayOf(display_), 0);
}

void XServer::closeWindow() {
  Display* display = displayOf(display_);
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window_;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", 0);
  event.xclient.format = 32; // bits, as the protocol requires
  event.xclient.data.l[0] = long(XInternAtom(display, "WM_DELETE_WINDOW", 0));
  event.xclient.data.l[1] = long(++time_);
  send(NoEventMask, &event);
}

} // namespace lichen::cli_test
