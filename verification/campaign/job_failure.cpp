#include "verification/campaign/job_failure.hpp"

#include <fstream>
#include <string_view>

#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/results/result_file.hpp"

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

}  // namespace slosh
