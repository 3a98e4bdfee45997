// The initial lattice: liquid at rest in a tank at rest, with positions from the tank's bottom left
// corner. The liquid fills the tank's length or a column at its left wall, except for obstacles.
// The particles stand half a cell off the walls and the still surface. Their density is that of the
// hydrostatic pressure (Li et al. 2010, eq. 15), and their mass fills the lattice cell at that
// density. The cells are squares of the particle spacing, stretched a little where the spacing does
// not divide the tank's length or the depth: Li's 2 cm in 0.35 m of water give 18 rows and the
// paper's 900 particles.
#pragma once

#include <functional>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"

namespace slosh::sph {

// With two spacings, the finer lattice fills a layer below the surface that is at least this many
// particles deep.
inline constexpr int fine_layers = 10;

// Cells that are stretched more make the lattice stiff enough to change the waves.
inline constexpr double largest_stretch = 0.05;

// Throws std::invalid_argument where the lattice cell would be stretched by more than
// largest_stretch, or where the two spacings leave no room for a layer of each.
// `density_at` is the equation of state: density [kg/m3] at a pressure [Pa].
Particles initial_lattice(const Scene& scene, const std::function<double(double)>& density_at);

// Moves every particle by up to `distance` [m], symmetrically about x = middle.
void perturb_symmetrically(Particles& lattice, double middle, double distance);

// Neighbours that move towards each other by this share of the spacing stay half a spacing apart.
inline constexpr double largest_disorder = 0.25;

// Moves every particle along x and z by up to `share` of its spacing, the same way for the same
// seed. Throws std::invalid_argument for a share that is not between 0 and largest_disorder.
void perturb_randomly(Particles& lattice, double share, unsigned seed);

// Returns the initial lattice of a liquid of density 1, whose masses are the volumes of its cells.
Particles lattice_of_volumes(const Scene& scene);

// Returns the height over the width of the flattest cell of lattice_of_volumes, at most 1.
double flattest_cell(const Particles& volumes);

// Returns the depth below the surface of the scene, averaged over the liquid's volume [m].
double mean_depth(const Particles& volumes, const Scene& scene);

}  // namespace slosh::sph
