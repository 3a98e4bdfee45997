// A row on the small surge of surge_results.hpp and a record of it.
#pragma once

#include <string>

#include "verification/tests/surge_results.hpp"

namespace slosh {

// The small surge and its runs, some of them replaced or added.
struct JudgedRuns {
  CaseDefinition definition = surge_case();
  CaseRuns runs = {};

  void set(const std::string& run, const TimeSeries& series) {
    runs.results[run] = result_of(run, series);
    runs.status[run] = {RunState::finished, ""};
  }
  void leave_out(const std::string& run) {  // as the quick form may do
    runs.results.erase(run);
    runs.status[run] = {RunState::not_selected, ""};
  }
  // Adds a run like another, whose wave is too high by this factor.
  RunDefinition& add(const std::string& name, const std::string& like, double factor) {
    RunDefinition run = run_named(definition, like);
    run.name = name;
    definition.runs.push_back(run);
    set(name, scaled(elevation_of({}), factor));
    return definition.runs.back();
  }
  GateOutcome judged() const { return assess(definition, runs).gate.at(0); }
  UncertaintyContributions contributions() const {
    return judged().judgement.value().contributions;
  }
};

// "particles" against a record, with a coarser run that is higher by what is told.
struct OfARecord : JudgedRuns {
  OfARecord(Metric metric, const std::string& mode, const std::string& unit, double limit,
            double coarse_error) {
    const TimeSeries wave = elevation_of({});
    definition.runs.at(1).solver =
        RecordRun{"eta.csv", surge_quantity, "m", wave.time, wave.value, 1e-6};
    definition.runs.at(1).name = "record";
    definition.runs.resize(3);
    std::get<SphRun>(add("coarse_particles", "particles", 1 + coarse_error).solver)
        .particle_spacing = 0.02;
    definition.gate = {surge_row(mode, metric, unit, limit)};
    definition.gate[0].reference = "record";
    definition.refinements = {
        {"spacing", RefinedNumber::particle_spacing, {"coarse_particles", "particles"}}};
    for (const char* name : {"theory", "record"}) set(name, wave);
    set("particles", scaled(wave, 1 + 1e-12));  // no copy of the record
  }
};

}  // namespace slosh
