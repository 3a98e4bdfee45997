// One child process in a process group of its own, so that what it starts in turn can be ended with
// it. What has left that group (setsid) is adopted and ended too (adopted_processes.hpp). The child
// gets SIGTERM where this process dies without a word.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slosh {

struct ChildSettings {
  std::filesystem::path log_file;  // of its output and errors; its directory is made if need be
  std::filesystem::path directory = {};                 // that it works in; empty: this process's
  std::map<std::string, std::string> environment = {};  // beside this process's
  // From SIGTERM to SIGKILL: long enough for mpirun to end its ranks.
  std::chrono::seconds grace{3};
};

class ChildProcess {
 public:
  // No shell, and empty standard input. Throws std::runtime_error where it cannot start.
  ChildProcess(const std::vector<std::string>& command, const ChildSettings& settings);
  ChildProcess(ChildProcess&&) noexcept;
  ChildProcess& operator=(ChildProcess&&) noexcept;
  ~ChildProcess();  // ends with SIGKILL what still runs of the group, and what has left it

  // Once: SIGTERM to the group. After the grace is_over() follows it up with SIGKILL.
  void terminate();

  // Whether the child has ended and, once terminate() was called, its group with it. Does not wait.
  bool is_over();

  int wait_status() const;   // as waitpid(2) gives it; valid once is_over()
  double wall_time() const;  // [s] since it was started

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slosh
