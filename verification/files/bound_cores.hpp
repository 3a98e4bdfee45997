// The cores to which processes are bound (sched_setaffinity(2)).
#pragma once

#include <sys/types.h>

#include <vector>

namespace slosh {

using Cores = std::vector<int>;  // their numbers, rising

// Returns the cores that a process may use, where 0 stands for this one. Returns none for a process
// that does not exist.
Cores allowed_cores(pid_t process = 0);

// Returns as many of the cores as are wanted, or all where there are fewer: those to which the
// fewest of the other processes are bound. A process that may use all of them is bound to none.
Cores least_bound(const Cores& cores, const std::vector<Cores>& of_others, int wanted);

// Does so for this process's cores and all processes that run now.
Cores least_bound_cores(int wanted);

}  // namespace slosh
