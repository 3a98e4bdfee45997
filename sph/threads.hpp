// How many threads a run takes. OpenMP's threads wait for each other several times a step: where
// they have little to do, or no core of their own, they only wait.
#pragma once

#include <cstddef>
#include <filesystem>

namespace slosh::sph {

// Cores that the process may keep busy, at least 1: the processors of its affinity mask, or fewer
// where a control group above it limits its processor time (cgroups(7), version 2, cpu.max; parts
// of a core count as one).
int usable_cores();

// The limit of the control groups alone, of the process whose /proc/PID/cgroup and whose root of
// the control groups are given; 0 where there is none.
int cores_of_control_groups(const std::filesystem::path& membership,
                            const std::filesystem::path& root);

// One thread for every 500 particles, never more than OpenMP would take (OMP_NUM_THREADS) or than
// there are usable cores, at least 1. Measured on 2 cores: 450 particles take 1.3 times as long
// with two threads as with one, 900 take 0.7 times as long.
int threads_for(std::size_t particles);

// The number of threads of the OpenMP regions that this thread starts, until the scope ends.
class ThreadScope {
 public:
  explicit ThreadScope(int threads);
  ~ThreadScope();
  ThreadScope(const ThreadScope&) = delete;
  ThreadScope& operator=(const ThreadScope&) = delete;

 private:
  int before_;
};

}  // namespace slosh::sph
