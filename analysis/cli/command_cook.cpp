// SPDX-License-Identifier: MIT
// lichen cook: writes a bundle as one flat file, which the engine plugin uses where it is mapped.
#include "command.h"
#include "options.h"

#include <lichen/bundle_writer.h>
#include <lichen/counted.h>
#include <lichen/files.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string input;
  std::string output;
};

Result<Bundle> readComplete(const std::string& path) {
  Result<Bundle> bundle = readBundle(path);
  if (!bundle)
    return bundle;
  if (!bundle.value().ignoredNoises.empty()) {
    const IgnoredNoise& ignored = bundle.value().ignoredNoises.front();
    return Error{ErrorKind::badInput, fmt::format("{}: noise '{}': {}; expected noises that this "
                                                  "version can evaluate",
                                                  path, ignored.name, ignored.reason())};
  }
  if (bundle.value().noises.empty())
    return Error{ErrorKind::badInput, fmt::format("{}: has no noise to cook", path)};
  return bundle;
}

Result<int> run(const Arguments& arguments) {
  if (Result<void> checked = checkOutput(arguments.output, {".lichen"}); !checked)
    return checked.error();
  const Result<Bundle> bundle = readComplete(arguments.input);
  if (!bundle)
    return bundle.error();
  const std::vector<std::byte> cooked = cookBundle(bundle.value());
  if (Result<void> written = replaceFile(arguments.output, cooked); !written)
    return written.error();
  std::vector<std::string> names;
  for (const Noise& noise : bundle.value().noises)
    names.push_back(noise.name);
  if (arguments.shared.json)
    printLine(toText({{"output", arguments.output},
                      {"noises", names},
                      {"materials", bundle.value().materials.size()},
                      {"tables", bundle.value().tables.size()},
                      {"bytes", cooked.size()}}));
  else
    say(arguments.shared,
        fmt::format("{}: {}; {}, {:.1f} KB", arguments.output, fmt::join(names, ", "),
                    counted(bundle.value().tables.size(), "table"),
                    double(cooked.size()) / 1000.0));
  return kDone;
}

} // namespace

Runner addCook(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "BUNDLE", arguments->input, "", "The bundle to cook, .glb or .gltf").required();
  addText(verb, "-o,--output", arguments->output, "OUT.lichen",
          "The file for lichenParseBundle; 'lichen inspect' and 'lichen check' read it too")
      .required();
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
