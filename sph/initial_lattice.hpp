// The liquid at rest: a lattice half a cell off the walls and the still surface, with the density
// of the hydrostatic pressure (Li et al. 2010, eq. 15) and the mass that fills the lattice cell at
// that density. The cells are squares of the particle spacing, stretched a little where that does
// not divide the tank's length or the depth: Li's 2 cm in 0.35 m of water makes 18 rows, and the
// paper's 900 particles.
#pragma once

#include "sph/equation_of_state.hpp"
#include "sph/particles.hpp"
#include "sph/simulation.hpp"

namespace slosh::sph {

// With two spacings the finer lattice fills the uppermost layer, at least this many particles deep.
inline constexpr int fine_layers = 10;

// Beyond it the lattice's own stiffness shows in the waves.
inline constexpr double largest_stretch = 0.05;

// Throws std::invalid_argument where the lattice cell would be stretched by more than
// largest_stretch, or where the two spacings leave no room for a layer of each.
Particles initial_lattice(const Scene& scene, const Tait& state);

// Height over width of the lattice's flattest cell, at most 1.
double flattest_cell(const Particles& lattice);

}  // namespace slosh::sph
