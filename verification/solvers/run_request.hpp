// What a solver is asked for: a run of a case, where its files go, and how it tells how far it is.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct RunSettings {
  std::filesystem::path work_directory;  // for OpenFOAM's case, an external program's files and the
                                         // snapshots; made if need be
  std::filesystem::path openfoam_templates;  // openfoam_cases/sloshing_tank
  // [s], of an SPH run, a multiple of the sample interval; 0: no snapshots
  double snapshot_interval = 0;
  // [s], of an SPH run, a multiple of the sample interval: how often its state is saved in the work
  // directory (state_file.hpp); 0: never
  double state_interval = 0;
  std::filesystem::path resume =
      {};                 // the state that an SPH run goes on from; empty: from the start
  double time_limit = 0;  // [s] of wall time, of an interFoam run; 0: none
  std::string key;        // run_key()'s, recorded
  std::string command;    // repeats this run, recorded
};

// Called now and then with the simulated time [s] and the steps so far.
using Progress = std::function<void(double time, double steps)>;

struct RunRequest {
  const CaseDefinition& definition;
  const RunDefinition& run;
  const RunSettings& settings;
  const Progress& progress;
};

}  // namespace slosh
