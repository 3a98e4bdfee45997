#include "verification/files/adopted_processes.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace slosh {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto look_interval = 2ms;
// A process that does not end on SIGKILL waits for a device; nobody is to wait with it.
constexpr auto patience = 5s;

std::set<pid_t> children() {
  std::set<pid_t> found;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream list(thread.path() / "children");
    for (pid_t child; list >> child;) found.insert(child);
  }
  return found;
}

}  // namespace

void adopt_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

std::set<pid_t> adopted_processes(const std::set<pid_t>& own) {
  std::set<pid_t> adopted;
  for (const pid_t child : children())
    if (!own.contains(child) && ::getpgid(child) != ::getpgrp() &&
        ::waitpid(child, nullptr, WNOHANG) == 0)
      adopted.insert(child);
  return adopted;
}

void end_adopted_processes(const std::set<pid_t>& own) {
  const auto begin = Clock::now();
  for (std::set<pid_t> left = adopted_processes(own);
       !left.empty() && Clock::now() - begin < patience; left = adopted_processes(own)) {
    for (const pid_t process : left) ::kill(process, SIGKILL);
    std::this_thread::sleep_for(look_interval);
  }
}

}  // namespace slosh
