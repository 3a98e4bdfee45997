// The costs and errors of a case's runs, by family. The runs of a family differ in resolution
// alone. A cost is the mean over the repeats on a core of their own, with the 95 % interval of
// Student's t; without such repeats it is the cost of the campaign's own run, beside which other
// runs ran. core-seconds = user + system time of all threads and processes.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/convergence/work_precision.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/gate_evidence.hpp"

namespace slosh {

struct MeasuredCost {
  // Half widths of NaN where there are fewer than two timings.
  Estimate core_seconds;   // [s]
  Estimate memory;         // the largest process at its peak [byte]
  std::size_t timings;     // repeats alone on a core; 0: the run ran beside others
  bool elsewhere = false;  // of a stored result: measured on another machine

  bool has_interval() const { return timings >= 2; }
};

// The cost of a run that left a result.
MeasuredCost cost_of(const CaseRuns& runs, const std::string& run);

// Says in the status of each run where its cost does not compare with the others': a stored
// result's was measured on another machine, and an external run that is bound to cores may have
// taken more processor time than these cores have in its wall time, by more than 5 %.
void mark_other_costs(const CaseDefinition& definition, CaseRuns& runs);

struct WorkRun {
  std::string run;
  double resolution;
  MeasuredCost cost;
  Estimate error;  // normalised rms
};

// The cost and error of a run that left a result.
WorkRun work_run(const RunDefinition& run, const CaseRuns& runs, const Estimate& error);

struct WorkFamily {
  std::string name;           // "recommended", "recommended, antuono", "interFoam"
  std::string reference;      // of the errors
  bool changed;               // an SPH scheme with something changed
  std::vector<WorkRun> runs;  // coarse to fine
};

void sort_by_resolution(WorkFamily& family);

std::vector<WorkPoint> by_core_seconds(const WorkFamily& family);
// Without the runs whose memory is not known.
std::vector<WorkPoint> by_memory(const WorkFamily& family);

// The cost at which the candidate's family reaches the row's error, from those runs of the family
// that `comparison` can compare with the row's reference. Throws as MeasureCost (gate_evidence.hpp)
// says.
CostAtError cost_to_reach(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const FindComparison& comparison);

// "; mine_20mm says itself that 8.2 s were compiling, 2 % of what it took; they do not count", of
// the run of the candidate's family that has the largest share of it, which is doubtful above one
// half; empty where the results have none.
RowDoubts left_out_as_compiling(const CaseDefinition& definition, const CaseRuns& runs,
                                const GateRow& row);

}  // namespace slosh
