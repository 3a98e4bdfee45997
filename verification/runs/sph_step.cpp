#include "verification/runs/sph_step.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "sph/simulation.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/solvers/sph_scene.hpp"

namespace slosh {

std::optional<SphStep> sph_step(const CaseDefinition& definition, const RunDefinition& run,
                                std::optional<double> measured_speed) try {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  if (!sph) return {};
  const CaseDefinition solved = definition_solved_by(run, definition);
  sph::Scene scene = sph_scene(solved, *sph);
  if (measured_speed) scene.coarse_run = {0, *measured_speed};
  const double stable = sph::stable_time_step(sph->scheme, scene),
               interval = solved.sample_interval;
  return SphStep{stable, interval / std::max(std::ceil(interval / stable - 1e-9), 1.0)};
} catch (const std::invalid_argument&) {  // the solver refuses the run when it starts
  return {};
}

}  // namespace slosh
