// Commands to Slurm's controller, and what it answers about job arrays.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slosh {

// The outcome of one of Slurm's commands.
struct SlurmAnswer {
  int status;
  std::string out, err;
};

// Runs the command without a shell, in this process's environment with the given variables added.
// Throws EngineError where it is not installed or does not end within a minute.
SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::map<std::string, std::string>& environment = {});

// Returns "12_3" for each task of these arrays that is in the queue, be it waiting, running or
// ending, and nullopt where the controller does not answer.
std::optional<std::set<std::string>> queued_tasks(const std::vector<std::string>& arrays);

// Returns "CANCELLED", "OUT_OF_MEMORY", ... for a task that has left the queue, as far as the
// controller still knows.
std::string state_of_task(const std::string& task);

}  // namespace slosh
