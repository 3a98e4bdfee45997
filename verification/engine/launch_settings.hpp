// How a list of jobs is to be started: the settings that the launcher and its engines share.
#pragma once

#include <filesystem>
#include <stdexcept>

namespace slosh {

enum class Engine { ninja, slurm };

struct LaunchSettings {
  // Only one start at a time works in this directory, which the caller sees to; it is made if need
  // be. The lists of earlier starts are removed from it: what is left of such a start writes into
  // its own list.
  std::filesystem::path directory;
  std::filesystem::path tool;  // its command `job N`, in the directory, runs job N of the list
  Engine engine = Engine::ninja;
  int at_once = 1;  // cores to fill on this machine; a cluster fills its own
};

// The engine cannot be used: what() says why.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Its program is not installed.
struct MissingEngine : EngineError {
  using EngineError::EngineError;
};

}  // namespace slosh
