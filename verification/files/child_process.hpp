// One child process in a process group of its own, so that everything it starts can be ended with
// it. Processes that have left the group (setsid) are adopted and ended too. The child gets SIGTERM
// when this process dies.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slosh {

struct ChildSettings {
  std::filesystem::path log_file;  // gets its output and errors; the directory is made if needed
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

  int wait_status() const;   // as from waitpid(2); valid once is_over()
  double wall_time() const;  // [s] since the start

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slosh
