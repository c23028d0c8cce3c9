// SPDX-License-Identifier: MIT
// The writers of the methods, in the order of Method.
#include "method_writer.h"

#include <array>

namespace lichen {

extern const MethodWriter kTilingWriter, kTextonWriter, kLocalRandomPhaseWriter,
    kMultipleKernelsWriter, kQuiltingWriter;

const MethodWriter& writerOf(Method method) {
  static constexpr std::array kWriters{&kTilingWriter, &kTextonWriter, &kLocalRandomPhaseWriter,
                                       &kMultipleKernelsWriter, &kQuiltingWriter};
  static_assert(kWriters.size() == std::variant_size_v<MethodMap>);
  return *kWriters[std::size_t(method)];
}

} // namespace lichen
