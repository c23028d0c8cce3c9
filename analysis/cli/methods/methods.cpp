// SPDX-License-Identifier: MIT
// The methods on the command line, in the order of Method.
#include "local_random_phase_command.h"
#include "method_command.h"
#include "multiple_kernels_command.h"
#include "quilting_command.h"
#include "texton_command.h"
#include "tiling_command.h"

#include <array>

namespace lichen::cli {

const MethodCommand& commandOf(Method method) {
  static const TilingCommand kTiling;
  static const TextonCommand kTexton;
  static const LocalRandomPhaseCommand kLocalRandomPhase;
  static const MultipleKernelsCommand kMultipleKernels;
  static const QuiltingCommand kQuilting;
  static const std::array<const MethodCommand*, 5> kCommands{&kTiling, &kTexton, &kLocalRandomPhase,
                                                             &kMultipleKernels, &kQuilting};
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
