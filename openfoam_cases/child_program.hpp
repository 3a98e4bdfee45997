// Starts a program of OpenFOAM without a shell and ends it with every process that it started.
#pragma once

#include <boost/filesystem/path.hpp>
#include <boost/process/child.hpp>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace slosh::openfoam {

// OpenFOAM takes its case's path from PWD and refuses one with a space or a quote in it. Under
// Linux this name stands for any process's working directory.
inline constexpr const char* plain_path = "/proc/self/cwd";

// Throws RunError where the PATH has no such program.
boost::filesystem::path find_program(const std::string& name);

// Returns the library of dictionary_digest.cpp in the build tree of this program, or an empty path
// where the program is not in one: runs then use OpenFOAM's own function.
std::filesystem::path preloaded_library();

// A running program, which the destructor ends. It stays in the caller's process group, so that a
// signal to the group, such as the user's Ctrl-C, ends it too.
class ChildProgram {
 public:
  // Starts command[0] with the other elements as arguments; its output goes to `log`. Throws
  // RunError where the program is not found.
  ChildProgram(const std::vector<std::string>& command, const std::filesystem::path& directory,
               const std::filesystem::path& log);
  ~ChildProgram();

  bool running();

  // Sends SIGTERM to the program, so that mpirun ends its ranks. Three seconds later the program
  // and its descendants get SIGKILL where they still run.
  void end();

  double wall_time() const;  // [s] since the start

  // Describes how a finished program failed; empty for a normal exit with status 0.
  std::string bad_exit() const;

 private:
  boost::process::child process_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace slosh::openfoam
