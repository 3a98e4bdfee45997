#include "verification/runs/sph_step.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sph/scheme.hpp"
#include "sph/scheme_runs.hpp"
#include "verification/case_file/changed_input.hpp"
#include "verification/case_file/motion.hpp"

namespace slosh {
namespace {

// What of the scene the step rests on. The solver's own translation (sph_run.cpp) is part of the
// key of every result, so that it is left as it is and not shared with this one.
sph::Scene step_scene(const CaseDefinition& definition, const SphRun& run) {
  const SurgeMotion motion = surge_motion(definition);
  sph::Scene scene{.tank_length = definition.tank.length,
                   .tank_height = definition.tank.height,
                   .fill_depth = definition.liquid.fill_depth,
                   .gravity = definition.gravity,
                   .rest_density = definition.liquid.density,
                   .kinematic_viscosity = definition.liquid.kinematic_viscosity,
                   .displacement = motion.displacement,
                   .velocity = motion.velocity,
                   .acceleration = motion.acceleration,
                   .duration = definition.duration,
                   .sample_interval = definition.sample_interval,
                   .particle_spacing = run.particle_spacing,
                   .surface_particle_spacing = run.surface_particle_spacing,
                   .column_width = definition.liquid.column_width,
                   .numbers = {.smoothing_length_ratio = run.numbers.smoothing_length_ratio,
                               .sound_speed_ratio = run.numbers.sound_speed_ratio,
                               .courant_number = run.numbers.courant_number,
                               .artificial_viscosity = run.numbers.artificial_viscosity,
                               .density_diffusion = run.numbers.density_diffusion},
                   .gauges = {},
                   .record_snapshot = {}};
  if (const std::optional<RollMotion> roll = roll_motion(definition))
    scene.roll = sph::Roll{roll->angle, roll->rate, roll->acceleration, roll->axis_x, roll->axis_z};
  return scene;
}

template <class Choice>
double stable_step(const sph::Scene& scene) {
  return sph::Scheme<Choice>(scene).time_step(scene.gravity);
}

template <class... Choices>
double step_of_variant(const std::string& name, const sph::Scene& scene,
                       sph::ChoiceList<Choices...>) {
  double step = 0;
  (void)((name == Choices::variant && (step = stable_step<Choices>(scene), true)) || ...);
  return step;
}

// 0 of no known scheme.
double step_of(const SphRun& run, const sph::Scene& scene) {
  if (!run.variant.empty()) return step_of_variant(run.variant, scene, sph::Variants{});
  if (run.scheme == "recommended") return stable_step<sph::Recommended>(scene);
  if (run.scheme == "li2010") return stable_step<sph::Li2010>(scene);
  if (run.scheme == "delta_sph") return stable_step<sph::DeltaSph>(scene);
  if (run.scheme == "zhao2021_moving") return stable_step<sph::Zhao2021Moving>(scene);
  return run.scheme == "zhao2021_fixed" ? stable_step<sph::Zhao2021Fixed>(scene) : 0;
}

}  // namespace

std::optional<SphStep> sph_step(const CaseDefinition& definition, const RunDefinition& run) try {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  if (!sph) return {};
  const CaseDefinition solved = definition_solved_by(run, definition);
  const double stable = step_of(*sph, step_scene(solved, *sph)), interval = solved.sample_interval;
  if (!(stable > 0)) return {};
  return SphStep{stable, interval / std::max(std::ceil(interval / stable - 1e-9), 1.0)};
} catch (const std::invalid_argument&) {  // the solver refuses the run in its own words
  return {};
}

}  // namespace slosh
