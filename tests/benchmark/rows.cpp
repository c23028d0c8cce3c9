// SPDX-License-Identifier: MIT
#include "rows.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

namespace lichen::bench {

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
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
