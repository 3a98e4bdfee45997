#include "verification/engine/job_list.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <thread>

#include "verification/files/atomic_file.hpp"
#include "verification/files/child_process.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Job, name, command, log_file, progress_file, time_limit, cores,
                                   expected_time, expected_memory, alone)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// The list is CBOR (RFC 8949), for JSON cannot hold paths that are not UTF-8.
constexpr const char* list_name = "jobs.cbor";
constexpr const char *started = ".started", *ended = ".ended.json";

// Returns the state with the end that the file tells; nullopt where it is absent, cannot be read
// yet or is none, as of a program that has written there: it is read again later.
std::optional<JobState> ended_state(const fs::path& file, JobState state) try {
  if (!fs::exists(file)) return std::nullopt;
  const json entry = parsed_json<json>(read_bytes(file));
  state.phase = static_cast<JobPhase>(entry.at("phase").get<int>());
  state.status = entry.at("status");
  state.message = entry.at("message");
  state.wall_time = entry.at("wall_time_s");
  return state;
} catch (const fs::filesystem_error&) {
  return std::nullopt;
} catch (const json::exception&) {
  return std::nullopt;
}

double seconds_since(fs::file_time_type begin) {
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - begin).count();
}

}  // namespace

JobList JobList::create(const fs::path& directory, const std::vector<Job>& jobs) {
  fs::create_directories(directory);
  const std::vector<std::uint8_t> bytes = json::to_cbor(jobs);
  replace_file(directory / list_name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
               Durability::process_crash);
  return {directory, jobs};
}

JobList JobList::open(const fs::path& directory) {
  const fs::path file = directory / list_name;
  try {
    return {directory, json::from_cbor(read_bytes(file)).get<std::vector<Job>>()};
  } catch (const json::exception& error) {
    throw std::runtime_error(
        fmt::format("{}: expected a list of jobs: {}", file.string(), error.what()));
  }
}

fs::path JobList::file(std::size_t index, const char* suffix) const {
  return directory_ / (std::to_string(index) + suffix);
}

void JobList::mark_started(std::size_t index) const {
  replace_file(file(index, started), "", Durability::process_crash);
}

void JobList::mark_ended(std::size_t index, const JobState& state) const {
  const json entry{{"phase", static_cast<int>(state.phase)},
                   {"status", state.status},
                   {"message", state.message},
                   {"wall_time_s", state.wall_time}};
  replace_file(file(index, ended), entry.dump(1, ' ', false, json::error_handler_t::replace),
               Durability::process_crash);
}

bool JobList::update(std::size_t index, JobState& state) const {
  const JobPhase before = state.phase;
  std::error_code none;
  if (auto end = ended_state(file(index, ended), state)) {
    state = std::move(*end);
  } else if (const auto begin = fs::last_write_time(file(index, started), none); !none) {
    state.phase = JobPhase::running;
    state.wall_time = seconds_since(begin);
  }
  if (state.phase != JobPhase::waiting && !state.job.progress_file.empty())
    if (const auto progress = read_progress(state.job.progress_file)) state.progress = progress;
  return state.phase != before;
}

bool JobList::update(std::vector<JobState>& states) const {
  bool changed = false;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (!has_ended(states[i])) changed |= update(i, states[i]);
  return changed;
}

std::vector<JobState> JobList::initial_states() const {
  std::vector<JobState> states;
  for (const Job& job : jobs_) states.push_back({.job = job});
  return states;
}

namespace {

// Far below the time of any run.
constexpr std::chrono::milliseconds look_interval{10};

void wait_for(ChildProcess& child, JobState& state, const std::atomic<bool>& stop) {
  JobPhase end = JobPhase::running;
  while (!child.is_over()) {
    const bool too_long = state.job.time_limit > 0 && child.wall_time() > state.job.time_limit;
    if (end == JobPhase::running && (stop || too_long)) {
      end = stop ? JobPhase::interrupted : JobPhase::timed_out;
      child.terminate();
    }
    std::this_thread::sleep_for(look_interval);
  }
  state.wall_time = child.wall_time();
  const int status = child.wait_status();
  state.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  const JobPhase own_end = WIFSIGNALED(status) ? JobPhase::signalled : JobPhase::exited;
  state.phase = end == JobPhase::running ? own_end : end;
}

}  // namespace

JobState run_job(const JobList& list, std::size_t index, const std::atomic<bool>& stop) {
  JobState state{.job = list.jobs().at(index)};
  try {
    std::filesystem::remove(state.job.progress_file);  // from an earlier run
    list.mark_started(index);
    ChildProcess child(state.job.command, {.log_file = state.job.log_file});
    wait_for(child, state, stop);
  } catch (const std::runtime_error& error) {
    state.phase = JobPhase::not_started;
    state.message = error.what();
  }
  list.mark_ended(index, state);
  return state;
}

namespace {

constexpr std::chrono::milliseconds observe_interval{200};

}  // namespace

Watch::Watch(const JobList& list, const ObserveJobs& observe)
    : list_(list), observe_(observe), states_(list.initial_states()) {}

void Watch::look() {
  if (list_.update(states_) || Clock::now() - told_ >= observe_interval) tell();
}

void Watch::lose(std::size_t index, const std::string& what_is_known) {
  JobPhase& phase = states_[index].phase;
  phase = phase == JobPhase::waiting ? JobPhase::not_started : JobPhase::lost;
  states_[index].message = what_is_known;
}

std::vector<JobState> Watch::finish(bool stopped, const std::string& what_is_known) {
  list_.update(states_);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (has_ended(states_[i])) continue;
    if (stopped)
      states_[i].phase = JobPhase::interrupted;
    else
      lose(i, what_is_known);
  }
  tell();
  return states_;
}

void Watch::tell() {
  observe_(states_);
  told_ = Clock::now();
}

}  // namespace slosh
