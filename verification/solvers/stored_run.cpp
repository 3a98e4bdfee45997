// Reads the series and the facts of a result that another code left elsewhere.
#include "verification/import/import_series.hpp"
#include "verification/input/tables/series_files.hpp"
#include "verification/solvers/external_facts.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {

void require_scene(const StoredRun& stored, const CaseDefinition&, const RunDefinition& run) try {
  for (const SeriesSource& source : stored.series) require_known_form(source);
} catch (const CaseFileError& error) {
  throw refused(run, error.what());
}

RunResult run_solver(const StoredRun& stored, const RunRequest& request) try {
  require_scene(stored, request.definition, request.run);
  RunResult result;
  for (const SeriesSource& source : stored.series) add_imported(import_with_seams(source), result);
  if (stored.facts.empty())
    result.provenance = {{"stored_software", stored.series.front().file.filename().string()},
                         {"stored_date", "date not given"},
                         {"stored_machine", "machine not given"}};
  else
    add_stored_facts(stored.facts, request.definition.duration, result);
  result.active_terms = {"stored result of " + result.provenance.at("stored_software")};
  request.progress(request.definition.duration, result.cost.steps);
  return result;
} catch (const ResultError& error) {
  throw SolverError(error.what());
}

std::vector<std::filesystem::path> stored_files(const StoredRun& stored) {
  std::vector<std::filesystem::path> files;
  if (!stored.facts.empty()) files.push_back(stored.facts);
  for (const SeriesSource& source : stored.series)
    for (const std::filesystem::path& file : series_files(source.file)) files.push_back(file);
  return files;
}

}  // namespace slosh
