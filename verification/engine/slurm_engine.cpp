#include "verification/engine/slurm_engine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "verification/engine/job.hpp"
#include "verification/engine/job_list.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/child_process.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {
namespace {

constexpr std::size_t places_of_array = 1000;  // MaxArraySize is 1001 unless a site changes it
constexpr double mebibyte = 1024 * 1024;
// A run's peak memory varies little between machines; Slurm kills a job that exceeds its request.
constexpr double memory_margin = 2;
constexpr double unknown_memory = 1024 * mebibyte;
constexpr double unknown_time = 3600;  // [s]

int power_of_two_above(double value) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(std::max(value, 1.0)))));
}

int memory_of(const Job& job) {
  const double expected = job.expected_memory > 0 ? job.expected_memory : unknown_memory;
  return power_of_two_above(memory_margin * expected / mebibyte + 64);
}

// The job keeps its own limit. Slurm's is a minute longer, so that the job can report its time-out.
int minutes_of(const Job& job) {
  const double limit = job.time_limit > 0 ? job.time_limit : unknown_time;
  return power_of_two_above(limit / 60 + 1);
}

// Commands to Slurm's controller, and what it answers about job arrays.

// The outcome of one of Slurm's commands.
struct SlurmAnswer {
  int status;
  std::string out, err;
};

// Runs the command without a shell, in this process's environment with the given variables added.
// Throws EngineError where it is not installed or does not end within a minute.
SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::map<std::string, std::string>& environment = {});

SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::map<std::string, std::string>& more) {
  constexpr std::chrono::seconds time_limit{60};
  const std::filesystem::path path = program_on_path(program);
  if (path.empty())
    throw MissingEngine(program + " is not installed: --launcher slurm needs Slurm's commands");
  std::vector<std::string> command{path.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  ChildProcess child(command, {.splits_errors = true, .environment = more});
  if (!child.ends_within(time_limit))
    throw EngineError(fmt::format("{} has not ended within {} s", program, time_limit.count()));
  return {child.exit_status(), child.output(), child.errors()};
}

// Returns "12_3" for each task of these arrays that is in the queue, be it waiting, running or
// ending, and nullopt where the controller does not answer.
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

// Returns "CANCELLED", "OUT_OF_MEMORY", ... for a task that has left the queue, as far as the
// controller still knows.
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

std::vector<SlurmArray> slurm_arrays(const std::vector<Job>& jobs) {
  std::map<std::tuple<bool, int, int, int, std::size_t>, SlurmArray> arrays;
  std::map<std::tuple<bool, int, int, int>, std::size_t> first;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    const auto needs = std::make_tuple(job.alone, job.cores, memory_of(job), minutes_of(job));
    const std::size_t begin = first.try_emplace(needs, i).first->second;
    const auto place = std::tuple_cat(needs, std::make_tuple((i - begin) / places_of_array));
    SlurmArray& array =
        arrays
            .try_emplace(place,
                         SlurmArray{{}, job.cores, memory_of(job), minutes_of(job), job.alone})
            .first->second;
    array.jobs.push_back(i);
  }
  std::vector<SlurmArray> ordered;
  for (auto& [place, array] : arrays) ordered.push_back(std::move(array));
  return ordered;
}

std::vector<std::string> sbatch_arguments(const SlurmArray& array, const std::string& directory,
                                          const std::vector<std::string>& after) {
  std::vector<std::size_t> places;
  for (const std::size_t job : array.jobs) places.push_back(job - array.jobs.front());
  // Of jobs that run alone one is started at a time (%1).
  std::vector<std::string> arguments{
      "--parsable",
      "--job-name=slosh",
      fmt::format("--array={}{}", fmt::join(places, ","), array.alone ? "%1" : ""),
      "--chdir=" + directory,
      "--output=slurm-%A_%a.log",
      fmt::format("--cpus-per-task={}", array.cores),
      fmt::format("--mem={}M", array.memory),
      fmt::format("--time={}", array.minutes)};
  if (array.alone) arguments.push_back("--exclusive");
  if (!after.empty())
    arguments.push_back(fmt::format("--dependency=afterany:{}", fmt::join(after, ":")));
  return arguments;
}

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
  const auto tell = telling_once("has jobs in the queue of Slurm");
  // A controller that has just been started knows of no job yet.
  for (int empty = 0; empty < 3 && !stop;) {
    const auto queued = queued_tasks(ids);
    if (queued && !queued->empty()) tell();
    empty = queued && queued->empty() ? empty + 1 : 0;
    std::this_thread::sleep_for(queue_interval);
  }
  if (!stop) fs::remove(file);
}

}  // namespace slosh
