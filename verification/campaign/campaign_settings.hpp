// How a campaign is to be run.
#pragma once

#include <filesystem>

#include "verification/campaign/run_selection.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/engine/launcher.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

struct CampaignSettings {
  std::filesystem::path output;  // <output>/runs/<case>/<run>.h5 (links), .log; <output>/jobs/
  ResultStore store{{}};
  std::filesystem::path campaign_file;       // whose sweeps add runs to the cases
  std::filesystem::path executable;          // this tool, which runs one run as `slosh run`
  std::filesystem::path builds;              // as run_key() and problem_key() take it
  std::filesystem::path openfoam_templates;  // openfoam_cases/sloshing_tank
  std::filesystem::path experiments;         // of the user's records; empty: none is named
  RunSelection selection = {};               // what is run and judged; the rest is not selected
  bool solve = true;                         // false: only read what is there
  Engine engine = Engine::ninja;
  int at_once = 1;            // cores
  TimingDefinition timing{};  // which runs are repeated for their timings
};

}  // namespace slosh
