#include "sph/threads.hpp"

#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

namespace slosh::sph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t particles_per_thread = 500;

// The file cpu.max holds the processor time per period in microseconds, or "max", and the period.
int cores_of_group(const fs::path& group) {
  std::ifstream file(group / "cpu.max");
  double quota, period;
  if (!(file >> quota >> period) || quota <= 0 || period <= 0) return 0;
  return static_cast<int>(std::ceil(quota / period));
}

// Returns the group's name below the root, from the line "0::/NAME" of version 2.
fs::path group_name(const fs::path& membership) {
  std::ifstream file(membership);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("0::/")) return line.substr(4);
  return {};
}

// Returns the size of the calling thread's present affinity mask; some OpenMP implementations read
// the mask only at their start.
int cores_of_affinity() {
  cpu_set_t mask;
  if (sched_getaffinity(0, sizeof mask, &mask) != 0)
    return omp_get_num_procs();  // more than CPU_SETSIZE cores
  return CPU_COUNT(&mask);
}

}  // namespace

int cores_of_control_groups(const fs::path& membership, const fs::path& root) {
  int least = 0;
  const auto take = [&](const fs::path& group) {
    const int cores = cores_of_group(group);
    if (cores > 0) least = least == 0 ? cores : std::min(least, cores);
  };
  fs::path group = root;
  take(group);
  for (const fs::path& part : group_name(membership)) take(group /= part);
  return least;
}

int usable_cores() {
  const int limit = cores_of_control_groups("/proc/self/cgroup", "/sys/fs/cgroup");
  const int cores = cores_of_affinity();
  return limit > 0 ? std::min(limit, cores) : cores;
}

int threads_for(std::size_t particles) {
  const int most = std::min(omp_get_max_threads(), usable_cores());
  const std::size_t busy = std::max<std::size_t>(1, particles / particles_per_thread);
  return static_cast<int>(std::min(busy, static_cast<std::size_t>(most)));
}

ThreadScope::ThreadScope(int threads) : before_(omp_get_max_threads()) {
  omp_set_num_threads(threads);
}

ThreadScope::~ThreadScope() { omp_set_num_threads(before_); }

}  // namespace slosh::sph
