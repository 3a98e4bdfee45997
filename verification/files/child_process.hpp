// One child process in a process group of its own, so that everything it starts can be ended with
// it. Processes that have left the group (setsid) are adopted and ended too. The child gets SIGTERM
// when this process dies.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slosh {

struct ChildSettings {
  // Gets its output and errors; the directory is made if needed. Empty: a file without a name,
  // which output() reads.
  std::filesystem::path log_file = {};
  bool splits_errors = false;                           // errors() then has the errors alone
  std::filesystem::path directory = {};                 // its work directory; empty: this process's
  std::map<std::string, std::string> environment = {};  // in addition to this process's
  // From SIGTERM to SIGKILL: long enough for mpirun to end its ranks.
  std::chrono::seconds grace{3};
  // It and all that it starts may use this many of this process's cores; 0: all of them.
  int cores = 0;
};

class ChildProcess {
 public:
  // Starts the command without a shell and with empty standard input. Throws std::runtime_error
  // where it cannot start.
  ChildProcess(const std::vector<std::string>& command, const ChildSettings& settings);
  ChildProcess(ChildProcess&&) noexcept;
  ChildProcess& operator=(ChildProcess&&) noexcept;
  ~ChildProcess();  // ends the rest of the group, and what has left it, with SIGKILL

  // Sends SIGTERM to the group, at the first call only. After the grace, is_over() sends SIGKILL.
  void terminate();

  // Whether the child has ended and, once terminate() was called, its group with it. Does not wait.
  bool is_over();

  // Waits until it is over, and calls terminate() at the limit, counted from the start. Returns
  // whether it has ended by itself.
  bool ends_within(std::chrono::duration<double> limit);

  // Valid once is_over().
  std::string output() const, errors() const;
  int exit_status() const, wait_status() const;  // the latter as from waitpid(2)
  double wall_time() const;                      // [s] since the start

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Returns the program of this name on the PATH, or an empty path.
std::filesystem::path program_on_path(const std::string& name);

// The cores to which processes are bound (sched_setaffinity(2)).

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
