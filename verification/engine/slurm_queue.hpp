// What Slurm's controller says of arrays, and what it is told.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace slosh {

// One command of Slurm's that has ended.
struct SlurmAnswer {
  int status;
  std::string out, err;
};

// Runs it without a shell, in this process's environment and what is given beside it. Throws
// EngineError where it is not installed or does not end within a minute.
SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::map<std::string, std::string>& environment = {});

// "12_3" for each task of these arrays that is in the queue, be it waiting, running or ending;
// nothing where the controller does not answer.
std::optional<std::set<std::string>> queued_tasks(const std::vector<std::string>& arrays);

// "CANCELLED", "OUT_OF_MEMORY", ... of a task that has left the queue, as far as the controller
// still knows.
std::string state_of_task(const std::string& task);

}  // namespace slosh
