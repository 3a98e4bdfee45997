// A small-amplitude surge (Li et al. 2010, section 4.1, coarse and short) for the tests of runs and
// gates.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

inline CaseDefinition sample_case() {
  CaseDefinition definition{};
  definition.name = "small_surge";
  definition.gravity = 9.81;
  definition.tank = {1, 1};
  definition.liquid = {0.35, 1000, 1e-6};
  definition.gas = {1.2, 1.5e-5};
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 0.3 * 4.94488};
  definition.start = Start::earth;
  definition.duration = 2;
  definition.sample_interval = 0.02;
  definition.gauges = {{"left", 0.05}, {"right", 0.95}};
  definition.window_begin = 0;
  definition.window_end = 2;
  definition.natural_modes = 1;
  definition.text = "name = \"small_surge\"\n";
  return definition;
}

inline RunDefinition sample_run(const decltype(RunDefinition::solver)& solver) {
  return {.name = "a_run", .solver = solver, .where = {"small_surge.toml", 42}};
}

}  // namespace slosh
