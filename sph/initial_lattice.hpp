// The liquid at rest in a tank at rest, at places from the tank's bottom left corner, filling the
// tank's length or standing as a column at its left wall, but for what obstacles take of it: a
// lattice half a cell off the walls and the still surface, with the
// density of the hydrostatic pressure (Li et al. 2010, eq. 15) and the mass that fills the lattice
// cell at that density. The cells are squares of the particle spacing, stretched a little where
// that does not divide the tank's length or the depth: Li's 2 cm in 0.35 m of water makes 18 rows,
// and the paper's 900 particles.
#pragma once

#include <functional>

#include "sph/neighbours/particles.hpp"
#include "sph/simulation.hpp"

namespace slosh::sph {

// With two spacings the finer lattice fills the uppermost layer, at least this many particles deep.
inline constexpr int fine_layers = 10;

// Beyond it the lattice's own stiffness shows in the waves.
inline constexpr double largest_stretch = 0.05;

// Throws std::invalid_argument where the lattice cell would be stretched by more than
// largest_stretch, or where the two spacings leave no room for a layer of each.
// `density_at` is the equation of state: density [kg/m3] at a pressure [Pa].
Particles initial_lattice(const Scene& scene, const std::function<double(double)>& density_at);

// Moves every particle by up to `distance` [m], alike on both sides of x = middle.
void perturb_symmetrically(Particles& lattice, double middle, double distance);

// Moves every particle along x and z by up to `share` of its spacing, the same way for the same
// seed. Throws std::invalid_argument for a share that is not within 0 and largest_disorder.
void perturb_randomly(Particles& lattice, double share, unsigned seed);

// Neighbours that meet it stay half a spacing apart.
inline constexpr double largest_disorder = 0.25;

// Height over width of the lattice's flattest cell, at most 1.
double flattest_cell(const Scene& scene);

}  // namespace slosh::sph
