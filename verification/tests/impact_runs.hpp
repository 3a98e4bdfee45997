// The case of impact_results.hpp with runs whose pressures are made by hand.
#pragma once

#include <map>
#include <string>

#include "verification/assessment/case_assessment.hpp"
#include "verification/tests/impact_results.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh {

inline RunResult result_with(const std::string& run, const std::vector<TimeSeries>& series) {
  RunResult result;
  result.case_name = "impacts";
  result.run_name = run;
  result.solver = "made by hand";
  result.provenance = {{"slosh_version", "0"},
                       {"compiler", "none"},
                       {"date_utc", "2000-01-01T00:00:00Z"},
                       {"processor", "none"},
                       {"command", "./slosh run impacts " + run}};
  result.cost = {.wall_time = 1, .user_time = 1, .steps = 10, .elements = 100};
  result.series = series;
  return result;
}

// Adds a run to an assessed case.
inline void add_run(CaseAssessment& assessment, const std::string& name,
                    const decltype(RunDefinition::solver)& solver,
                    const std::vector<TimeSeries>& series) {
  assessment.definition.runs.push_back(sample_run(solver));
  assessment.definition.runs.back().name = name;
  assessment.runs.results[name] = result_with(name, series);
  assessment.runs.status[name] = {RunState::finished, ""};
}

// Declared, but without a result.
inline void add_absent_run(CaseAssessment& assessment, const std::string& name,
                           const decltype(RunDefinition::solver)& solver, RunState why) {
  add_run(assessment, name, solver, {});
  assessment.runs.results.erase(name);
  assessment.runs.status[name] = {why, "so it goes"};
}

inline CaseAssessment no_runs_of(const CaseDefinition& definition) {
  return {definition, {}, {}, {}, {}};
}

}  // namespace slosh
