// SPDX-License-Identifier: MIT
// The methods on the command line, in the order of Method.
#include "method_command.h"

#include <array>

namespace lichen::cli {

const MethodCommand& tilingCommand();
const MethodCommand& textonCommand();
const MethodCommand& localRandomPhaseCommand();
const MethodCommand& multipleKernelsCommand();
const MethodCommand& quiltingCommand();

const MethodCommand& commandOf(Method method) {
  static const std::array<const MethodCommand*, 5> kCommands{
      &tilingCommand(), &textonCommand(), &localRandomPhaseCommand(), &multipleKernelsCommand(),
      &quiltingCommand()};
  static_assert(kCommands.size() == std::variant_size_v<MethodMap>);
  return *kCommands[std::size_t(method)];
}

std::optional<ForeignOption> foreignOption(const CLI::App& verb, Method method) {
  for (const Method other : allMethods())
    if (std::optional<std::string> given = givenOf(verb, commandOf(other).heading());
        given && other != method)
      return ForeignOption{std::move(*given), other};
  return std::nullopt;
}

} // namespace lichen::cli
