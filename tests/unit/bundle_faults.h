// SPDX-License-Identifier: MIT
// A valid file that is broken in one place: the checker must report the fault by its code, and the
// reader must reject the file with a message of one line.
#pragma once

#include "bundle_surgery.h"

#include <lichen/bundle.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace lichen::example {

inline void checkFault(const std::string& what, const std::string& code, const GlbParts& parts) {
  INFO(what);
  const std::vector<std::byte> file = parts.join();
  const std::vector<Finding> findings = checkBundle(file);
  std::string found;
  for (const Finding& finding : findings)
    found += finding.code + " " + finding.pointer + ": " + finding.message + "\n";
  INFO(found);
  CHECK(std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
    return finding.severity == Finding::Severity::error && finding.code == code;
  }));
  const auto bundle = parseBundle(file, "broken.glb");
  REQUIRE_FALSE(bundle.ok());
  CHECK(bundle.error().kind == ErrorKind::badInput);
  CHECK(bundle.error().message.rfind("broken.glb: ", 0) == 0);
  CHECK(bundle.error().message.find('\n') == std::string::npos);
}

} // namespace lichen::example
