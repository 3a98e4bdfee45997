// Runs independent pieces of work on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <vector>

namespace slosh::reports {

// Calls work(i) once for each i from 0 to count - 1, on the given number of threads. Rethrows what
// a piece of work throws after all threads have ended.
template <class Work>
void side_by_side(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < threads; ++i) workers.push_back(std::async(std::launch::async, take_turns));
  for (std::future<void>& worker : workers) worker.wait();
  for (std::future<void>& worker : workers) worker.get();
}

}  // namespace slosh::reports
