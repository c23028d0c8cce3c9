// SPDX-License-Identifier: MIT
// Breaks a valid file in one place at a time: the checker must report the fault by its code, and
// the reader must reject the file with a message of one line.
#pragma once

#include "bundle_surgery.h"

#include <lichen/bundle.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>

namespace lichen::example {

struct Fault {
  const char* what;
  const char* code;
  std::function<void(GlbParts&)> make;
};

inline void checkFaults(const std::vector<std::byte>& sound, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    INFO(fault.what);
    GlbParts parts(sound);
    fault.make(parts);
    const std::vector<std::byte> file = parts.join();
    const std::vector<Finding> findings = checkBundle(file);
    std::string found;
    for (const Finding& finding : findings)
      found += finding.code + " " + finding.pointer + ": " + finding.message + "\n";
    INFO(found);
    CHECK(std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
      return finding.severity == Finding::Severity::error && finding.code == fault.code;
    }));
    const auto bundle = parseBundle(file, "broken.glb");
    REQUIRE_FALSE(bundle.ok());
    CHECK(bundle.error().kind == ErrorKind::badInput);
    CHECK(bundle.error().message.rfind("broken.glb: ", 0) == 0);
    CHECK(bundle.error().message.find('\n') == std::string::npos);
  }
}

} // namespace lichen::example
