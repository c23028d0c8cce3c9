// SPDX-License-Identifier: MIT
// A race in the body of a parallel loop, which ThreadSanitizer must report in spite of
// tests/tsan.supp: two tasks write one variable, at the same time.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <cstdio>

int main() {
  using namespace std::chrono_literals;
  if (tbb::this_task_arena::max_concurrency() < 2) {
    std::puts("SKIPPED: oneTBB runs one task at a time here, so that none can race");
    return 0;
  }
  int shared = 0;
  std::atomic<int> running = 0;
  const auto end = std::chrono::steady_clock::now() + 10s;
  tbb::parallel_for(0, 2, [&](int i) {
    // Relaxed: this must not order the tasks.
    running.fetch_add(1, std::memory_order_relaxed);
    while (running.load(std::memory_order_relaxed) < 2 && std::chrono::steady_clock::now() < end) {
    }
    shared += i;
  });
  std::printf("%d, of tasks that ran %s\n", shared,
              running.load() == 2 ? "together" : "one by one");
  return 0;
}
