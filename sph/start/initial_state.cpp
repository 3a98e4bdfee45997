#include "sph/start/initial_state.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sph/scheme_terms.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/start/projection.hpp"
#include "sph/start/settled.hpp"

namespace slosh::sph {
namespace {

void require_initial_state(const Scene& scene, const Method& method) {
  const InitialState wanted = chosen_state(scene, method);
  if (wanted == InitialState::projected &&
      (method.terms->solids_have_density || method.terms->reads_spacing))
    throw std::invalid_argument(
        "initial_state = projected: expected lattice | settled, because this scheme has walls with "
        "a density of their own or two spacings");
  if (wanted == InitialState::settled && (scene.column_width || scene.initial_wave))
    throw std::invalid_argument(
        "initial_state = settled: expected lattice | projected, because a dam would break and a "
        "wave would run while the particles settle");
  if (scene.start_rotation != 0 &&
      (wanted != InitialState::settled || !scene.obstacles.empty() || !scene.outline.empty() ||
       scene.surface_particle_spacing != scene.particle_spacing))
    throw std::invalid_argument(fmt::format(
        "start_rotation = {} rad: expected 0 unless the initial state is settled, in a rectangular "
        "tank without obstacles and with one spacing, because rotated rows do not fit the walls",
        scene.start_rotation));
}

}  // namespace

const char* start_name(InitialState state) {
  if (state == InitialState::lattice) return "start from the hydrostatic lattice";
  return state == InitialState::settled ? "start from settled particles"
                                        : "start from the incompressible liquid's state";
}

InitialState chosen_state(const Scene& scene, const Method& method) {
  return scene.initial_state.value_or(method.initial_state);
}

Particles start_lattice(const Scene& scene, const Method& method) {
  require_initial_state(scene, method);
  Particles lattice =
      initial_lattice(scene, [&](double pressure) { return method.terms->density(pressure); });
  perturb_randomly(lattice, scene.start_disorder, scene.start_seed);
  enter(method.frame, scene, lattice);
  return lattice;
}

Particles initial_state(const Scene& scene, const Method& method) {
  Particles lattice = start_lattice(scene, method);
  const InitialState wanted = chosen_state(scene, method);
  if (scene.duration == 0 || wanted == InitialState::lattice) return lattice;
  return wanted == InitialState::settled ? settled(scene, method, lattice)
                                         : projected(scene, method, lattice);
}

}  // namespace slosh::sph
