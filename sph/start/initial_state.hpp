// The liquid's initial state, one of:
//   lattice    the hydrostatic lattice with the initial velocity (initial_lattice.hpp)
//   settled    the same after a relaxation (settled.hpp)
//   projected  the lattice in the incompressible liquid's state at 0+ (projection.hpp)
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/scheme.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/start/projection.hpp"
#include "sph/start/settled.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

inline const char* start_name(InitialState state) {
  if (state == InitialState::lattice) return "start from the hydrostatic lattice";
  return state == InitialState::settled ? "start from settled particles"
                                        : "start from the incompressible liquid's state";
}

template <class Choice>
InitialState chosen_state(const Scene& scene) {
  return scene.initial_state.value_or(Choice::initial_state);
}

// Throws std::invalid_argument for an initial state that is impossible with the scheme or the
// scene.
template <class Choice>
void require_initial_state(const Scene& scene) {
  const InitialState wanted = chosen_state<Choice>(scene);
  if (wanted == InitialState::projected &&
      (Choice::Solids::has_density || Choice::Smoothing::reads_spacing))
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

// Returns the lattice in the scheme's frame, before any preparation.
template <class Choice>
Particles start_lattice(const Scene& scene, const Scheme<Choice>& scheme) {
  require_initial_state<Choice>(scene);
  Particles lattice =
      initial_lattice(scene, [&](double pressure) { return scheme.state.density(pressure); });
  perturb_randomly(lattice, scene.start_disorder, scene.start_seed);
  enter<typename Choice::Frame>(scene, lattice);
  return lattice;
}

template <class Choice>
Particles initial_state(const Scene& scene, const Scheme<Choice>& scheme) {
  const auto density_at = [&](double pressure) { return scheme.state.density(pressure); };
  Particles lattice = start_lattice(scene, scheme);
  if (scene.duration == 0) return lattice;
  const InitialState wanted = chosen_state<Choice>(scene);
  if (wanted == InitialState::settled) return settled<Choice>(scene, scheme, lattice);
  if constexpr (!Choice::Solids::has_density && !Choice::Smoothing::reads_spacing)
    if (wanted == InitialState::projected)
      return Projection<Choice>(scene, lattice)
          .state(scene.velocity(0), scene.acceleration(0), density_at);
  return lattice;
}

}  // namespace slosh::sph
