// One child process in a process group of its own, so that what it starts in turn can be ended with
// it.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace slosh {

class ChildProcess {
 public:
  // No shell, empty standard input, output and error to the log; started in the directory, in this
  // process's own where that is empty. Throws std::runtime_error where it cannot start.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log_file,
               const std::filesystem::path& directory = {});
  ChildProcess(ChildProcess&&) noexcept;
  ChildProcess& operator=(ChildProcess&&) noexcept;
  ~ChildProcess();  // ends with SIGKILL what still runs of the group

  // Once: SIGTERM to the group. Three seconds later is_over() follows it up with SIGKILL.
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
