// SPDX-License-Identifier: MIT
#include "rows.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace lichen::bench {

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void Measured::note(double value, const std::string& name) {
  if (values.empty() || value > largest())
    worst = name;
  values.push_back(value);
}

double Measured::largest() const { return *std::max_element(values.begin(), values.end()); }

void Measured::append(std::vector<Row>& rows, const std::string& what, double target,
                      const std::string& unit, const std::string& note) const {
  rows.push_back({what + ", median", median(values), target, unit,
                  std::to_string(values.size()) + " exemplars" + note});
  rows.push_back({"the same, worst", largest(), target, unit, worst});
}

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<std::pair<std::string, std::string>> machineFacts() {
  const auto valueOf = [](const char* file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
      if (line.rfind(key, 0) == 0) {
        const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
        return start == std::string::npos ? std::string() : line.substr(start);
      }
    return std::string("unknown");
  };
  std::string load = "unknown";
  std::getline(std::ifstream("/proc/loadavg"), load);
#ifdef __clang__
  const char* const compiler = __VERSION__;
#else
  const char* const compiler = "GCC " __VERSION__;
#endif
  return {{"processor", valueOf("/proc/cpuinfo", "model name")},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"memory", valueOf("/proc/meminfo", "MemTotal")},
          {"load", load.substr(0, load.find(' '))},
          {"compiler", compiler},
          {"build", LICHEN_BENCH_BUILD}};
}

double peakMemoryMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      double kibibytes = 0.0;
      status >> kibibytes;
      return kibibytes * 1024e-6;
    }
  return 0.0;
}

} // namespace lichen::bench
