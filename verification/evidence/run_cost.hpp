// Costs and errors of a case's runs, by family: runs that differ in resolution alone. A cost is the
// mean over the repeats that had a core for themselves, with the 95 % interval of Student's t, or
// that of the campaign's own run, which others ran beside. core-seconds = user + system time, of
// all threads and processes.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/convergence/work_precision.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

struct MeasuredCost {
  // Half widths of NaN where there are fewer than two timings.
  Estimate core_seconds;  // [s]
  Estimate memory;        // the largest process at its peak [byte]
  std::size_t timings;    // alone on a core; 0: beside other runs

  // With what scatter others are to be compared.
  bool has_interval() const { return timings >= 2; }
};

// Of a run that left a result.
MeasuredCost cost_of(const CaseRuns& runs, const std::string& run);

struct WorkRun {
  std::string run;
  double resolution;
  MeasuredCost cost;
  Estimate error;  // normalised rms
};

// Of a run that left a result.
WorkRun work_run(const RunDefinition& run, const CaseRuns& runs, const Estimate& error);

struct WorkFamily {
  std::string name;           // "recommended", "recommended, shifting", "interFoam"
  std::string reference;      // of the errors
  bool changed;               // something of an SPH scheme
  std::vector<WorkRun> runs;  // coarse to fine
};

void sort_by_resolution(WorkFamily& family);

std::vector<WorkPoint> by_core_seconds(const WorkFamily& family);
std::vector<WorkPoint> by_memory(const WorkFamily& family);

// What a gate row's cost_to_reach is judged by (gate.hpp, MeasureCost): of the candidate's family
// what `comparison` can compare with the row's reference.
CostAtError cost_to_reach(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const FindComparison& comparison);

}  // namespace slosh
