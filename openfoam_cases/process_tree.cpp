#include "openfoam_cases/process_tree.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <thread>
#include <vector>

namespace slosh::openfoam {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto grace = 3s;
constexpr auto look_interval = 20ms;

// Those of its main thread, which is the one that starts processes in the programs here.
void append_descendants(pid_t process, std::vector<pid_t>& list) {
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process));
  for (pid_t child; children >> child;) {
    list.push_back(child);
    append_descendants(child, list);
  }
}

}  // namespace

void end_process_tree(pid_t child, const std::function<bool()>& runs) {
  std::vector<pid_t> tree{child};
  append_descendants(child, tree);  // before any is orphaned and found no more
  ::kill(child, SIGTERM);
  for (const auto end = Clock::now() + grace; runs() && Clock::now() < end;)
    std::this_thread::sleep_for(look_interval);
  const std::size_t first = runs() ? 0 : 1;  // a process that was reaped has lost its number
  for (std::size_t i = first; i < tree.size(); ++i) ::kill(tree[i], SIGKILL);
  while (runs()) std::this_thread::sleep_for(look_interval);
}

}  // namespace slosh::openfoam
