#include "verification/engine/slurm_queue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <sstream>

#include "verification/engine/launch_settings.hpp"
#include "verification/files/child_process.hpp"

namespace slosh {

SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::map<std::string, std::string>& more) {
  constexpr std::chrono::seconds time_limit{60};
  const std::filesystem::path path = program_on_path(program);
  if (path.empty())
    throw EngineError(program + " is not installed: --launcher slurm needs Slurm's commands");
  std::vector<std::string> command{path.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  ChildProcess child(command, {.splits_errors = true, .environment = more});
  if (!child.ends_within(time_limit))
    throw EngineError(fmt::format("{} has not ended within {} s", program, time_limit.count()));
  return {child.exit_status(), child.output(), child.errors()};
}

std::optional<std::set<std::string>> queued_tasks(const std::vector<std::string>& arrays) try {
  const SlurmAnswer answer = ask_slurm(
      "squeue",
      {"--noheader", "--array", "--format=%i", fmt::format("--jobs={}", fmt::join(arrays, ","))});
  // A job that the controller no longer knows has ended.
  if (answer.err.find("Invalid job id") != std::string::npos) return std::set<std::string>{};
  if (answer.status != 0) return std::nullopt;
  std::set<std::string> tasks;
  std::istringstream lines(answer.out);
  for (std::string task; lines >> task;) tasks.insert(task);
  return tasks;
} catch (const EngineError&) {
  return std::nullopt;
}

std::string state_of_task(const std::string& task) try {
  const SlurmAnswer answer = ask_slurm("scontrol", {"--oneliner", "show", "job", task});
  const std::string mark = "JobState=";
  const std::size_t at = answer.out.find(mark);
  if (at == std::string::npos) return "no longer known to Slurm";
  const std::size_t begin = at + mark.size();
  return "Slurm says " + answer.out.substr(begin, answer.out.find(' ', begin) - begin);
} catch (const EngineError&) {
  return "Slurm does not answer";
}

}  // namespace slosh
