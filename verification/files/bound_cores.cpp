#include "verification/files/bound_cores.hpp"

#include <sched.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

namespace slosh {

Cores allowed_cores(pid_t process) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(process, sizeof set, &set) != 0) return {};
  Cores cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

Cores least_bound(const Cores& cores, const std::vector<Cores>& of_others, int wanted) {
  std::vector<std::pair<int, int>> bound;  // the number of processes, and the core
  for (const int core : cores) bound.emplace_back(0, core);
  for (const Cores& of_other : of_others) {
    Cores shared;
    std::set_intersection(cores.begin(), cores.end(), of_other.begin(), of_other.end(),
                          std::back_inserter(shared));
    if (shared.size() == cores.size()) continue;
    for (auto& [processes, core] : bound)
      processes += std::binary_search(shared.begin(), shared.end(), core);
  }
  std::sort(bound.begin(), bound.end());
  Cores chosen;
  for (const auto& [processes, core] : bound)
    if (static_cast<int>(chosen.size()) < wanted) chosen.push_back(core);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

namespace {

// The kernel's own threads have no command line: most are bound to a core and do not use it.
bool has_command_line(const std::filesystem::path& process) {
  std::ifstream stream(process / "cmdline");
  return stream.peek() != std::ifstream::traits_type::eof();
}

}  // namespace

Cores least_bound_cores(int wanted) {
  std::vector<Cores> of_others;
  std::error_code none;  // without /proc nothing is known of the others
  for (const auto& entry : std::filesystem::directory_iterator("/proc", none)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") == name.npos && has_command_line(entry.path()))
      of_others.push_back(allowed_cores(std::stoi(name)));
  }
  return least_bound(allowed_cores(), of_others, wanted);
}

}  // namespace slosh
