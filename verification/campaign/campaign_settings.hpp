// The settings of a campaign's run.
#pragma once

#include <filesystem>

#include "verification/campaign/run_selection.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/engine/job.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

struct CampaignSettings {
  std::filesystem::path output;  // <output>/runs/<case>/<run>.h5 (links), .log; <output>/jobs/
  ResultStore store{{}};
  std::filesystem::path campaign_file;       // whose sweeps add runs to the cases
  std::filesystem::path executable;          // this tool, which runs one run as `slosh run`
  std::filesystem::path builds;              // as run_key() and problem_key() take it
  std::filesystem::path openfoam_templates;  // openfoam_cases/sloshing_tank
  std::filesystem::path experiments;  // directory of the user's records; empty: none is given
  RunSelection selection = {};        // the runs that are executed and judged
  bool solve = true;                  // false: only stored results are read
  Engine engine = Engine::ninja;
  int at_once = 1;            // cores
  TimingDefinition timing{};  // which runs are repeated for their timings
};

}  // namespace slosh
