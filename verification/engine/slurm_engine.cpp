#include "verification/engine/slurm_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "verification/engine/slurm_array.hpp"
#include "verification/engine/slurm_queue.hpp"
#include "verification/engine/watch.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// The script of a task: only numbers come in from outside, and the tool's path as one word.
constexpr const char* script = R"sh(#!/bin/sh
exec "$SLOSH_TOOL" job "$((SLOSH_FIRST_JOB + SLURM_ARRAY_TASK_ID))"
)sh";
constexpr const char* arrays_name = "slurm.json";

constexpr std::chrono::seconds queue_interval{2};
// As often as observers are told, for the list may lie on a network file system.
constexpr std::chrono::milliseconds list_interval{200};
// The time that a task's files may take to appear here after it has left the queue: network file
// systems have a delay.
constexpr std::chrono::seconds file_delay{10};

struct Task {
  std::string id;  // "12_3"
  std::optional<Clock::time_point> gone;
};

class Arrays {
 public:
  Arrays(const JobList& list, const LaunchSettings& settings)
      : list_(list), ids_file_(settings.directory / arrays_name), tasks_(list.jobs().size()) {
    const fs::path file = list.directory() / "task.sh";
    replace_file(file, script, Durability::process_crash);

    for (const SlurmArray& array : slurm_arrays(list.jobs())) {
      std::string id =
          submit(array, file, settings.tool, array.alone ? ids_ : std::vector<std::string>{});
      for (const std::size_t job : array.jobs)
        tasks_[job].id = fmt::format("{}_{}", id, job - array.jobs.front());
    }
  }

  void cancel() const { ask_slurm("scancel", ids_); }

  // Returns the jobs that left the queue some time ago without a record of their end.
  std::vector<std::size_t> silent(const std::vector<JobState>& states) {
    const auto queued = queued_tasks(ids_);
    if (!queued) return {};  // the controller is asked again
    std::vector<std::size_t> silent;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (has_ended(states[i])) continue;
      if (queued->contains(tasks_[i].id)) {
        tasks_[i].gone.reset();
      } else if (!tasks_[i].gone) {
        tasks_[i].gone = Clock::now();
      } else if (Clock::now() - *tasks_[i].gone > file_delay) {
        silent.push_back(i);
      }
    }
    return silent;
  }

  const std::string& task(std::size_t job) const { return tasks_[job].id; }

 private:
  std::string submit(const SlurmArray& array, const fs::path& file, const fs::path& tool,
                     const std::vector<std::string>& after) {
    std::vector<std::string> arguments = sbatch_arguments(array, list_.directory().string(), after);
    arguments.push_back(file.string());
    const SlurmAnswer answer = ask_slurm(
        "sbatch", arguments,
        {{"SLOSH_TOOL", tool.string()}, {"SLOSH_FIRST_JOB", std::to_string(array.jobs.front())}});
    if (answer.status != 0) {
      if (!ids_.empty()) cancel();
      throw EngineError("sbatch: " + answer.err);
    }
    // "ID" or "ID;CLUSTER"
    std::string id = answer.out.substr(0, answer.out.find_first_of(";\n"));
    ids_.push_back(id);
    replace_file(ids_file_, nlohmann::json(ids_).dump(), Durability::process_crash);
    return id;
  }

  const JobList& list_;
  fs::path ids_file_;
  std::vector<std::string> ids_;
  std::vector<Task> tasks_;
};

}  // namespace

std::vector<JobState> run_by_slurm(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe) {
  Arrays arrays(list, settings);
  Watch watch(list, observe);
  Clock::time_point asked = Clock::now();
  const auto all_ended = [&] {
    return std::all_of(watch.states().begin(), watch.states().end(), has_ended);
  };
  for (watch.look(); !all_ended(); watch.look()) {
    if (stop) {
      arrays.cancel();
      break;
    }
    if (Clock::now() - asked > queue_interval) {
      for (const std::size_t job : arrays.silent(watch.states()))
        watch.lose(job, state_of_task(arrays.task(job)));
      asked = Clock::now();
    }
    std::this_thread::sleep_for(list_interval);
  }
  // Cancelled tasks take some time to end: the next start waits for them.
  if (!stop) fs::remove(settings.directory / arrays_name);
  return watch.finish(stop, "");
}

void wait_for_earlier_arrays(const fs::path& directory, const std::atomic<bool>& stop) {
  const fs::path file = directory / arrays_name;
  if (!fs::exists(file)) return;
  const std::vector<std::string> ids = parsed_json<nlohmann::json>(read_bytes(file));
  // A controller that has just been started knows of no job yet.
  for (int empty = 0; empty < 3 && !stop;) {
    const auto queued = queued_tasks(ids);
    empty = queued && queued->empty() ? empty + 1 : 0;
    std::this_thread::sleep_for(queue_interval);
  }
  if (!stop) fs::remove(file);
}

}  // namespace slosh
