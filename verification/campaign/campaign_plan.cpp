#include "verification/campaign/campaign_plan.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <string_view>
#include <utility>

#include "verification/case/solver_kinds.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/own_files.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_store.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/results/timings.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

constexpr std::string_view mark = "slosh: ";  // main.cpp puts it before every error

// More of a log than anyone reads in a report.
constexpr std::size_t most_lines = 100;

// Returns the tool's message from its first line on, or nullopt where the log has none.
struct Complaint {
  std::string message, details;
};

Complaint read_complaint(const std::filesystem::path& log) {
  std::ifstream stream;
  if (is_plain_file(log)) stream.open(log);
  Complaint found;
  std::string last;
  std::size_t lines = 0;
  for (std::string line; std::getline(stream, line);) {
    if (!found.message.empty() && lines < most_lines) {
      found.details += (lines++ > 0 ? "\n" : "") + line;
    } else if (line.starts_with(mark)) {
      found.message = line.substr(mark.size());
    } else if (!line.empty()) {
      last = line;
    }
  }
  if (found.message.empty())
    found.message = last.empty() ? "nothing is in its log " + log.string() : last;
  return found;
}

std::string kind_of(JobPhase phase) {
  switch (phase) {
    case JobPhase::signalled:
      return "killed";
    case JobPhase::timed_out:
      return "time limit";
    case JobPhase::interrupted:
      return "interrupted";
    case JobPhase::lost:
      return "lost";
    case JobPhase::not_started:
    case JobPhase::exited:
    case JobPhase::waiting:
    case JobPhase::running:
      break;
  }
  return "error";
}

RunFailure failure_of(const JobState& state) {
  const Complaint complaint = read_complaint(state.job.log_file);
  return {kind_of(state.phase), complaint.message, complaint.details, state.job.log_file.string()};
}

}  // namespace

RunFailure legible(const RunFailure& failure) {
  return {legible_message(failure.kind), legible_message(failure.message),
          legible_message(failure.details), legible_message(failure.log)};
}

std::string first_error_line(const std::filesystem::path& log) {
  return legible_message(read_complaint(log).message);
}

std::string awaited(const Job& job) {
  std::ifstream stream;
  if (is_plain_file(job.log_file)) stream.open(job.log_file);
  std::size_t lines = 0;
  for (std::string line; lines < most_lines && std::getline(stream, line); ++lines)
    if (line.ends_with(waiting_words)) return legible_message(job.name + ": " + line);
  return "";
}

RunStatus status_without_result(const JobState& state, const std::filesystem::path& failure_file) {
  if (state.phase == JobPhase::not_started) return {RunState::missing, description(state)};
  if (state.phase == JobPhase::exited && state.status == exit_not_compared)
    return {RunState::missing, description(state) + ": " + first_error_line(state.job.log_file)};
  const bool has_told = state.phase == JobPhase::exited && state.status == exit_solver_failed;
  std::optional<RunFailure> failure = has_told ? read_failure(failure_file) : std::nullopt;
  if (!failure) {
    failure = failure_of(state);
    try {
      write_failure(*failure, failure_file);
    } catch (const ResultError&) {  // the failure is reported even where the disk is full
    }
  }
  const RunFailure shown = legible(*failure);
  return {RunState::failed, description(state) + ": " + shown.message, shown};
}

namespace {

namespace fs = std::filesystem;

PlannedRun planned_run(const CaseDefinition& definition, const RunDefinition& run,
                       const CampaignSettings& settings) {
  PlannedRun planned{&definition, &run, {}, {RunState::not_selected, ""}, {}};
  if (!is_selected(settings.selection, definition, run)) return planned;
  const auto* record = std::get_if<RecordRun>(&run.solver);
  if (record && !record->supplied) {
    planned.status = {RunState::not_supplied, where_to_get(*record, definition)};
    return planned;
  }
  planned.key = run_key(definition, run, settings.builds, settings.openfoam_templates);
  StandingResult standing = standing_result(planned.key, ".h5", settings);
  planned.file = std::move(standing.file);
  planned.status = std::move(standing.status);
  return planned;
}

// Returns the start of the command `slosh run` for the run.
std::vector<std::string> run_command(const PlannedRun& planned, const CampaignSettings& settings) {
  std::vector<std::string> command{
      settings.executable.string(),
      "run",
      fs::absolute(planned.definition->file).lexically_normal().string(),
      planned.run->name,
      "--store",
      settings.store.root().string()};
  const bool swept = planned.run->where.file != planned.definition->file.string();
  if (swept) command.insert(command.end(), {"--campaign", settings.campaign_file.string()});
  if (!settings.experiments.empty())
    command.insert(command.end(), {"--experiments", settings.experiments.string()});
  return command;
}

fs::path link_to_result(const CampaignSettings& settings, const ProblemDefinition& problem) {
  return settings.output / "problems" / (problem.name + ".json");
}

Job job_of(const PlannedRun& planned, const CampaignSettings& settings, const ExpectedCost& cost) {
  fs::path log = link_to_result(settings, *planned.definition, *planned.run);
  log.replace_extension(".log");
  return {.name = planned.definition->name + "/" + planned.run->name,
          .command = run_command(planned, settings),
          .log_file = log,
          .time_limit = time_limit(cost),
          .cores = cost.cores,
          .expected_time = cost.wall_time,
          .expected_memory = cost.memory};
}

bool is_timed(const PlannedRun& planned, const TimingDefinition& timing) {
  return !is_record(*planned.run) && !is_stored(*planned.run) &&
         names_run({.only = timing.only}, *planned.definition, *planned.run);
}

}  // namespace

std::string key_of(const ProblemDefinition& problem, const CampaignSettings& settings) {
  return problem_key(find_problem(problem.name), settings.selection.quick, settings.builds);
}

ProblemRun standing_problem(const ProblemDefinition& problem, const CampaignSettings& settings) {
  if (!names_problem(settings.selection, problem.name)) return {{RunState::not_selected, ""}, {}};
  const StandingResult standing = standing_result(key_of(problem, settings), ".json", settings);
  if (standing.status.state == RunState::failed) hide_result(link_to_result(settings, problem));
  if (standing.status.state != RunState::finished) return {standing.status, {}};
  try {
    ProblemResult result = read_stored(standing.file, read_problem_result);
    show_result(standing.file, link_to_result(settings, problem));
    return {standing.status, std::move(result)};
  } catch (const ResultError& error) {
    return {{RunState::missing, error.what()}, {}};
  }
}

Job job_for(const ProblemDefinition& problem, const CampaignSettings& settings) {
  Job job;
  job.name = problem.name;
  job.log_file = settings.output / "problems" / (problem.name + ".log");
  job.command = {settings.executable.string(), "run", problem.name, "--store",
                 settings.store.root().string()};
  if (settings.selection.quick) job.command.push_back("--quick");
  job.expected_time = find_problem(problem.name).expected_time;
  job.time_limit =
      time_limit({.processor_time = job.expected_time, .wall_time = job.expected_time});
  return job;
}

ProblemRun ended_problem(const JobState& state, const ProblemDefinition& problem,
                         const CampaignSettings& settings) {
  if (!has_succeeded(state)) {
    hide_result(link_to_result(settings, problem));
    return {status_without_result(
                state, settings.store.file(key_of(problem, settings), failure_extension)),
            {}};
  }
  return standing_problem(problem, settings);
}

std::vector<PlannedRun> plan_runs(const std::vector<CaseDefinition>& cases,
                                  const CampaignSettings& settings) {
  std::vector<PlannedRun> plan;
  for (const CaseDefinition& definition : cases)
    for (const RunDefinition& run : definition.runs)
      plan.push_back(planned_run(definition, run, settings));
  return plan;
}

StandingResult standing_result(const std::string& key, const char* extension,
                               const CampaignSettings& settings) {
  const fs::path own = settings.store.file(key, extension);
  if (const auto told = read_failure(settings.store.file(key, failure_extension))) {
    const RunFailure failure = legible(*told);
    return {own, settings.solve
                     ? RunStatus{RunState::missing, own.string() + " failed when it was last tried"}
                     : RunStatus{RunState::failed, failure.kind + ": " + failure.message, failure}};
  }
  if (fs::exists(own)) return {own, {RunState::finished, ""}};
  const auto other = settings.store.newest_file(key, extension);
  if (!other)
    return {own,
            {RunState::missing, fmt::format("no result in {}: none was made, or for another state "
                                            "of the case file",
                                            settings.store.root().string())}};
  constexpr const char* made_by_another_build = "made by another build or version";
  if (settings.solve)
    return {own,
            {RunState::missing, fmt::format("{} was {}", other->string(), made_by_another_build)}};
  return {*other, {RunState::finished, made_by_another_build}};
}

bool is_pending(const PlannedRun& planned) { return planned.status.state == RunState::missing; }

Job job_for(const PlannedRun& planned, const CampaignSettings& settings) {
  Job job = job_of(planned, settings,
                   expected_cost(*planned.definition, *planned.run, planned.key, settings.store));
  job.progress_file =
      settings.output / "jobs" / (planned.definition->name + "." + planned.run->name + ".progress");
  job.command.insert(job.command.end(), {"--progress-file", job.progress_file.string()});
  return job;
}

std::vector<Job> timing_jobs(const PlannedRun& planned, const CampaignSettings& settings) {
  std::vector<Job> jobs;
  const bool computed = is_pending(planned) || planned.status.state == RunState::finished;
  if (!computed || !is_timed(planned, settings.timing)) return jobs;
  const std::size_t made = read_timings(settings.store.file(planned.key, ".timings.json")).size(),
                    wanted = static_cast<std::size_t>(settings.timing.repeats);
  if (made >= wanted) return jobs;
  const ExpectedCost cost =
      expected_cost(*planned.definition, *planned.run, planned.key, settings.store);
  if (cost.measured && cost.processor_time > settings.timing.longest_run) return jobs;
  for (std::size_t i = made; i < wanted; ++i) {
    Job job = job_of(planned, settings, cost);
    job.name += fmt::format(", timing {}", i + 1);
    job.log_file.replace_extension(fmt::format(".timing_{}.log", i + 1));
    job.command.insert(job.command.end(),
                       {"--timing", "--longest", fmt::format("{}", settings.timing.longest_run)});
    job.alone = true;
    jobs.push_back(std::move(job));
  }
  return jobs;
}

void show_result(const fs::path& result, const fs::path& link) {
  std::error_code none;
  if (fs::read_symlink(link, none) == result) return;
  if (!foreign_at(link)) return link_own(result, link);
  std::cerr << fmt::format("{} is kept, as no campaign has made it: it is no link to {}\n",
                           link.string(), result.string());
}

void hide_result(const fs::path& link) {
  std::error_code none;
  if (!fs::is_symlink(link, none) || foreign_at(link)) return;
  require_own(link);
  fs::remove(link);
}

fs::path link_to_result(const CampaignSettings& settings, const CaseDefinition& definition,
                        const RunDefinition& run) {
  return settings.output / "runs" / definition.name / (run.name + ".h5");
}

}  // namespace slosh
