// A row on the small surge of surge_results.hpp and a record of it.
#pragma once

#include <string>

#include "verification/tests/surge_results.hpp"

namespace slosh {

// "particles" against a record, with a coarser run that is higher by what is told.
struct OfARecord {
  CaseDefinition definition = surge_case();
  CaseRuns runs;

  OfARecord(Metric metric, const std::string& mode, const std::string& unit, double limit,
            double coarse_error) {
    const TimeSeries wave = elevation_of({});
    definition.runs.at(1).solver =
        RecordRun{"eta.csv", surge_quantity, "m", wave.time, wave.value, 1e-6};
    definition.runs.at(1).name = "record";
    RunDefinition coarse = definition.runs.at(2);
    coarse.name = "coarse_particles";
    std::get<SphRun>(coarse.solver).particle_spacing = 0.02;
    definition.runs.resize(3);
    definition.runs.push_back(coarse);
    definition.gate = {surge_row(mode, metric, unit, limit)};
    definition.gate[0].reference = "record";
    definition.refinements = {
        {"spacing", RefinedNumber::particle_spacing, {"coarse_particles", "particles"}}};
    for (const char* name : {"theory", "record", "particles"})
      runs.results[name] = result_of(name, wave);
    runs.results["coarse_particles"] =
        result_of("coarse_particles", scaled(wave, 1 + coarse_error));
    for (const auto& [name, result] : runs.results) runs.status[name] = {RunState::finished, ""};
  }
  GateOutcome judged() const { return assess(definition, runs).gate.at(0); }
  UncertaintyContributions contributions() const { return judged().judgement->contributions; }
};

}  // namespace slosh
