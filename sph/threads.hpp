// The number of threads of a run. OpenMP's threads wait for one another several times in a step. A
// thread with little work, or without a core of its own, mostly waits.
#pragma once

#include <cstddef>
#include <filesystem>

namespace slosh::sph {

// Returns the number of cores that the process may use, at least 1: the processors of its affinity
// mask, or fewer where a control group limits its processor time (cgroups(7), version 2, cpu.max; a
// part of a core counts as one).
int usable_cores();

// Returns the limit of the control groups alone, or 0 where there is none. `membership` is the
// process's /proc/PID/cgroup, `root` the directory of the control groups.
int cores_of_control_groups(const std::filesystem::path& membership,
                            const std::filesystem::path& root);

// Returns one thread for every 500 particles, at least 1 and at most OpenMP's own number
// (OMP_NUM_THREADS) or that of the usable cores. On 2 cores, two threads were measured to take 1.3
// times as long as one for 450 particles, and 0.7 times as long for 900.
int threads_for(std::size_t particles);

// Sets the number of threads of the OpenMP regions that this thread starts, until the scope ends.
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
