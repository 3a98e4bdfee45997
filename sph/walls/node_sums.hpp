// The liquid's state at the nodes of solid particles, by a linear least-squares fit over the
// kernel's support (moving least squares, as in Marrone et al. 2011, eq. 12). The fit's value at
// the node follows from the moments sum_b V_b W_ab (1, dx, dz)(1, dx, dz)^T over liquid and images.
// Where the particles do not determine a linear fit (a splash), the weighted mean is used. A node
// without liquid in its support has no state. The sums are over the liquid and its images, which
// come before the solids in every list.
#pragma once

#include <vector>

#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

struct Nodes {
  Array<double> x, z;  // in the tank [m]
  // What the sums find: the kernel sum of the liquid, without the kernel's normalisation and 1/h^2,
  // the liquid's velocity, and one of its fields. Without liquid all are 0.
  Array<double> liquid, velocity_x, velocity_z, value;

  std::size_t size() const { return x.size(); }
  bool found(std::size_t i) const { return liquid[i] > 0; }

  // The places must have their final order.
  void place(const std::vector<SolidPlace>& places) {
    for_each_named_field(
        [&](const char*, Array<double>& field) { field.assign(places.size(), 0.0); });
    for (std::size_t i = 0; i < places.size(); ++i) {
      x[i] = places[i].node_x;
      z[i] = places[i].node_z;
    }
  }
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    for (auto* field : {&x, &z, &liquid, &velocity_x, &velocity_z, &value}) visit("nodes", *field);
  }
};

// The field of the sources that the sums evaluate besides the velocity.
enum class NodeValue { strength, density };

// Evaluates the velocity and this field at the nodes. It is compiled in node_sums.cpp for every
// kernel; schemes share it.
template <class Kernel>
void sum_at_nodes(NodeValue value, double smoothing_length, const NeighbourSources& neighbours,
                  const TankWalls& walls, Nodes& nodes, InstructionSet set);

}  // namespace slosh::sph
