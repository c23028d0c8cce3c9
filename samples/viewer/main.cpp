// SPDX-License-Identifier: MIT
// lichen-view: a glTF scene -> a window.
#include "program.h"
#include "viewer.h"

#include <cstdio>

int main(int argc, char** argv) {
  using namespace lichen::renderer;
  return runProgram("lichen-view", [&]() -> lichen::Result<void> {
    lichen::Result<std::variant<ViewCommand, std::string>> parsed = parseViewCommand(argc, argv);
    if (!parsed)
      return parsed.error();
    if (const auto* text = std::get_if<std::string>(&parsed.value())) {
      std::fputs(text->c_str(), stdout);
      return {};
    }
    return view(std::get<ViewCommand>(parsed.value()));
  });
}
