// Runs an external program in a fresh directory, keeps its output in a log beside that, and reads
// the files of series that it leaves. A missing or unreadable series is a failure of the run.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/tables/series_files.hpp"
#include "verification/input/tables/table_reader.hpp"
#include "verification/peers/tank_file.hpp"
#include "verification/results/provenance.hpp"
#include "verification/solvers/external_command.hpp"
#include "verification/solvers/external_facts.hpp"
#include "verification/solvers/external_program.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Throws CaseFileError for what the program left in the place of a file that is read: a pipe, which
// would never end, or a link to a file of another place.
void require_left_in(const fs::path& directory, const fs::path& file) {
  std::error_code lost;
  if (!fs::exists(fs::symlink_status(file, lost))) return;  // the reader says so
  const fs::path home = fs::canonical(directory), real = fs::canonical(file, lost);
  if (lost || !lies_below(real, home) || fs::is_symlink(directory) || !is_plain_file(real))
    throw CaseFileError(file.string() +
                        ": expected a regular file in the work directory; it is a link that leads "
                        "out of it, or a pipe, a socket or a device");
}

ImportedSeries series_left(const SeriesSource& declared, const fs::path& work_directory,
                           const fs::path& log) {
  SeriesSource source = declared;
  source.file = work_directory / declared.file;
  try {
    if (!fs::is_directory(source.file)) require_left_in(work_directory, source.file);
    for (const fs::path& part : series_files(source.file)) require_left_in(work_directory, part);
    return import_with_seams(source);
  } catch (const CaseFileError& error) {
    throw program_failure(source.quantity + ": " + error.what(), log);
  } catch (const ResultError& error) {
    throw program_failure(source.quantity + ": " + error.what(), log);
  }
}

void take_facts(const ExternalRun& external, const fs::path& work_directory, const fs::path& log,
                const RunCost& taken, RunResult& result) {
  if (external.facts.empty()) return;
  try {
    require_left_in(work_directory, work_directory / external.facts);
    add_external_facts(work_directory / external.facts, taken, result);
  } catch (const CaseFileError& error) {
    throw program_failure(error.what(), log);
  }
}

void write_tank_file(const CaseDefinition& definition, const fs::path& directory) {
  const fs::path file = directory / tank_file_name;
  std::ofstream stream(file);
  if (!(stream << tank_file(definition)).flush())
    throw SolverError(file.string() + ": expected a file that can be written");
}

// The first line that the version command prints; empty where the run has none.
std::string program_version(const ExternalRun& external, const CaseDefinition& definition,
                            const fs::path& work_directory, const fs::path& log) {
  constexpr double longest = 60;  // [s]
  const std::vector<std::string> command = version_command(external, definition, work_directory);
  if (command.empty()) return "";
  if (command.front().empty())
    throw SolverError(
        fmt::format("version_command: {}: expected a program relative to the case file or on the "
                    "PATH; there is none",
                    external.version_command.front()));
  run_program({.command = command,
               .directory = external.directory.empty() ? work_directory : external.directory,
               .log = log,
               .time_limit = longest});
  std::string head(10'000, '\0');
  std::ifstream file(log);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  std::istringstream stream(head);
  for (std::string line; std::getline(stream, line);)
    if (!trimmed(line).empty()) return legible_message(trimmed(line));
  throw program_failure("version_command: expected a line of output", log);
}

}  // namespace

void require_scene(const ExternalRun& external, const CaseDefinition& definition,
                   const RunDefinition& run) {
  try {
    for (const SeriesSource& source : external.series) require_known_form(source);
    external_command(external, definition, "");
    if (asks_for_tank_file(external)) tank_file(definition);
    version_command(external, definition, "");
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
  const fs::path version_log = work / (request.run.name + ".version.log");
  // What an earlier run may have left and nobody has touched; all else is set aside (run_case.cpp).
  for (const fs::path& left : {directory, log, version_log}) fs::remove_all(left);
  fs::create_directories(directory);
  const std::vector<std::string> command =
      external_command(external, request.definition, directory);
  // Before any program runs, which could leave a pipe or a link in its place.
  if (asks_for_tank_file(external)) write_tank_file(request.definition, directory);
  // Before the run, so that a version that cannot be told costs no run.
  const CostMeter apart;
  const std::string version = program_version(external, request.definition, directory, version_log);
  RunResult result;
  result.cost = apart.cost();
  const CostMeter meter;
  run_program({.command = command,
               .directory = external.directory.empty() ? directory : external.directory,
               .log = log,
               .time_limit = external.time_limit,
               .cores = external.cores});
  const RunCost taken = meter.cost();
  require_no_match(external.fail_on, log);

  for (const SeriesSource& source : external.series)
    add_imported(series_left(source, directory, log), result);
  take_facts(external, directory, log, taken, result);
  result.active_terms = {"external program " + fs::path(command.front()).filename().string()};
  if (!version.empty()) result.provenance["external_version"] = version;
  result.provenance["external_command"] = fmt::format("{}", fmt::join(command, " "));
  result.provenance["external_program_hash"] = content_hash(read_bytes(command.front()));
  request.progress(request.definition.duration, 0);
  return result;
}

}  // namespace slosh
