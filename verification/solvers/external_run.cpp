// Runs an external program without a shell in a fresh directory, keeps its output in a log beside
// that, and reads the files of series that it leaves. The program and its child processes are ended
// when its time limit is over or this process is told to end. A missing or unreadable series is a
// failure of the run.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <thread>

#include "verification/files/child_process.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/table_reader.hpp"
#include "verification/solvers/external_command.hpp"
#include "verification/solvers/external_facts.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto poll_interval = 50ms;
// From the signal that ends this process to the kill of the program's process group: less than the
// time that a campaign leaves its runs before it kills them.
constexpr auto grace = 1s;

// While an object of this class lives, the signals that would end this process are held back, so
// that the program, which has a process group of its own, is ended first.
class AwaitedEnd {
 public:
  AwaitedEnd() {
    for (std::size_t i = 0; i < std::size(signals); ++i)
      former_[i] = std::signal(signals[i], [](int signal) { asked = signal; });
  }
  AwaitedEnd(const AwaitedEnd&) = delete;
  AwaitedEnd& operator=(const AwaitedEnd&) = delete;
  ~AwaitedEnd() {
    for (std::size_t i = 0; i < std::size(signals); ++i) std::signal(signals[i], former_[i]);
    if (const int signal = asked.exchange(0)) std::raise(signal);
  }
  static bool is_asked() { return asked != 0; }

 private:
  static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
  static inline std::atomic<int> asked{0};
  void (*former_[std::size(signals)])(int);
};

// Returns the error with one line that says what went wrong, as reports show it, and the end of the
// program's log.
SolverError failure(const std::string& what, const fs::path& log) {
  constexpr std::size_t shown = 10;
  std::deque<std::string> lines;
  std::ifstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    if (!trimmed(line).empty()) lines.push_back(line);
    if (lines.size() > shown) lines.pop_front();
  }
  const std::string last = lines.empty() ? "it said nothing" : "its last words: " + lines.back();
  return SolverError({"solver failed", fmt::format("{}; {}", what, last),
                      fmt::format("{}", fmt::join(lines, "\n")), log.string()});
}

// Returns how the program ended; empty for exit status 0.
std::string bad_end(int wait_status) {
  if (WIFSIGNALED(wait_status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(wait_status),
                       strsignal(WTERMSIG(wait_status)));
  const int status = WEXITSTATUS(wait_status);
  return status == 0 ? "" : fmt::format("exit status {}", status);
}

// Throws SolverError unless the program ends by itself, in time and with status 0.
void run_program(const std::vector<std::string>& command, const ExternalRun& external,
                 const fs::path& directory, const fs::path& log) {
  const AwaitedEnd end;
  const auto fail = [&](const std::string& how) {
    throw failure(command.front() + ": " + how, log);
  };
  try {
    ChildProcess child(command, {.log_file = log, .directory = directory});
    while (!child.is_over()) {
      if (AwaitedEnd::is_asked()) {
        child.terminate();
        for (auto waited = 0ms; waited < grace && !child.is_over(); waited += poll_interval)
          std::this_thread::sleep_for(poll_interval);
        fail("interrupted");
      }
      if (external.time_limit && child.wall_time() > *external.time_limit) {
        child.terminate();
        while (!child.is_over()) std::this_thread::sleep_for(poll_interval);
        fail(fmt::format("did not end within its time_limit_s = {}", *external.time_limit));
      }
      std::this_thread::sleep_for(poll_interval);
    }
    if (const std::string how = bad_end(child.wait_status()); !how.empty()) fail(how);
  } catch (const std::system_error& error) {
    fail(std::string("cannot be started: ") + error.what());
  }
}

TimeSeries series_left(const SeriesSource& declared, const fs::path& work_directory,
                       const fs::path& log) {
  SeriesSource source = declared;
  source.file = work_directory / declared.file;
  try {
    return import_series(source);
  } catch (const CaseFileError& error) {
    throw failure(source.quantity + ": " + error.what(), log);
  } catch (const ResultError& error) {
    throw failure(source.quantity + ": " + error.what(), log);
  }
}

void take_facts(const ExternalRun& external, const fs::path& work_directory, const fs::path& log,
                RunResult& result) {
  if (external.facts.empty()) return;
  try {
    add_external_facts(work_directory / external.facts, result);
  } catch (const CaseFileError& error) {
    throw failure(error.what(), log);
  }
}

}  // namespace

void require_scene(const ExternalRun& external, const CaseDefinition& definition,
                   const RunDefinition& run) {
  try {
    for (const SeriesSource& source : external.series) require_known_form(source);
    external_command(external, definition, "");
  } catch (const CaseFileError& error) {
    throw refused(run, error.what());
  } catch (const std::invalid_argument& error) {
    throw refused(run, error.what());
  }
}

RunResult run_solver(const ExternalRun& external, const RunRequest& request) {
  require_scene(external, request.definition, request.run);
  // The program is looked for only now, since a report on a stored result needs no program.
  if (external_program(external, request.definition).empty())
    throw SolverError(
        fmt::format("command: {}: expected a program relative to the case file or on "
                    "the PATH; there is none",
                    external.command.front()));
  const fs::path work = fs::absolute(request.settings.work_directory);
  const fs::path directory = work / (request.run.name + ".external");
  const fs::path log = work / (request.run.name + ".external.log");
  fs::remove_all(directory);  // an earlier run may have left files
  fs::create_directories(directory);
  const std::vector<std::string> command =
      external_command(external, request.definition, directory);
  run_program(command, external, external.directory.empty() ? directory : external.directory, log);

  RunResult result;
  for (const SeriesSource& source : external.series)
    result.series.push_back(series_left(source, directory, log));
  take_facts(external, directory, log, result);
  result.active_terms = {"external program " + fs::path(command.front()).filename().string()};
  result.provenance["external_command"] = fmt::format("{}", fmt::join(command, " "));
  result.provenance["external_program_hash"] = content_hash(read_bytes(command.front()));
  request.progress(request.definition.duration, 0);
  return result;
}

}  // namespace slosh
