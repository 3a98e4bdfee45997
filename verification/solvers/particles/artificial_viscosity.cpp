#include "verification/solvers/particles/artificial_viscosity.hpp"

#include "sph/scheme.hpp"
#include "verification/solvers/sph_scene.hpp"

namespace slosh {

double artificial_viscosity(const CaseDefinition& definition, const SphRun& run) {
  if (!run.numbers.artificial_viscosity) return 0;
  const sph::Scene scene = sph_scene(definition, run);
  const double h = run.numbers.smoothing_length_ratio.value_or(1.5) * run.particle_spacing,
               c0 = run.numbers.sound_speed_ratio.value_or(10) * sph::expected_speed(scene);
  return *run.numbers.artificial_viscosity * h * c0 / 8;
}

}  // namespace slosh
