// The positions of the particles of solid walls and obstacles, in layers as deep as the kernel's
// support, fixed in the tank. Each has a node, its mirror image in the nearest face, at which the
// liquid's state is evaluated (Marrone et al. 2011, section 3; English et al. 2022, modified
// dynamic boundary conditions).
#pragma once

#include <cstdint>
#include <vector>

#include "sph/scene.hpp"
#include "sph/walls/solid_place.hpp"

namespace slosh::sph {

// Returns the particles of the scene's obstacles and, where `tank_walls`, of the tank's bottom,
// sides and roof, or of its outline (outline_layers.hpp). They fill layers `depth` [m] deep, a
// particle spacing apart, from half a spacing inside the faces. Along the tank's walls each cell
// holds `along_walls` of them beside one another, of equal shares of its volume, and each cell of a
// corner the square of that number. An obstacle that touches a wall is continued behind it, in
// place of the wall's own layers. An obstacle thinner than `depth` has places behind each of its
// faces (thin_obstacles.hpp).
std::vector<SolidPlace> solid_places(const Scene& scene, bool tank_walls, double depth,
                                     int along_walls);

// Returns the obstacles with their edges moved to the nearest border between cells of the lattice.
// An obstacle that touches a wall is continued behind it by as many whole layers as reach `depth`.
// Throws std::invalid_argument for one with liquid on two sides that is thinner than a particle
// spacing, and for one that covers no cell.
std::vector<Rectangle> obstacles_on_lattice(const Scene& scene, double depth);

}  // namespace slosh::sph
