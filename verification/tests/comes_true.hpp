// Waiting for what another process does.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace slosh {

// How long a test waits for what a busy machine delays.
inline constexpr std::chrono::seconds patience{200};

// Whether it does within that time; looked at every ten milliseconds.
inline bool comes_true(const std::function<bool()>& condition, std::chrono::seconds within) {
  const auto begin = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - begin < within) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace slosh
