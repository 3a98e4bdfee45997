// The liquid's particles as a structure of arrays, and the sources that the pair loops read. A
// source is a liquid particle, one of its mirror images (walls/mirror_particles.hpp) or a particle
// of a solid (walls/solid_particles.hpp).
#pragma once

#include <cstddef>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "sph/neighbours/lanes.hpp"
#include "sph/terms/gap_layers.hpp"

namespace slosh::sph {

// Memory is aligned for vector loads and has room past the end for a vector that begins at the last
// element.
template <class T>
struct VectorAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{sizeof(Lanes)};
  VectorAllocator() = default;
  template <class U>
  VectorAllocator(const VectorAllocator<U>&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new(n * sizeof(T) + sizeof(Lanes), alignment));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  bool operator==(const VectorAllocator&) const { return true; }
};

template <class T>
using Array = std::vector<T, VectorAllocator<T>>;

// "layer_1_velocity_x", "layer_1_velocity_z", "layer_2_velocity_x", ...
inline const char* layer_velocity_name(std::size_t n) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (int layer = 1; layer <= most_gap_layers; ++layer)
      for (const char* axis : {"x", "z"})
        all.push_back("layer_" + std::to_string(layer) + "_velocity_" + axis);
    return all;
  }();
  return names.at(n).c_str();
}

// The state that is integrated in time; positions and velocities are in the scheme's frame.
struct Particles {
  Array<double> x, z;                    // [m]
  Array<double> velocity_x, velocity_z;  // [m/s]
  Array<double> density;                 // [kg/m3]
  Array<double> mass;                    // [kg/m]
  Array<double> spacing;                 // [m], the width of the lattice cell that it was laid in;
                                         // empty where all have lattice_spacing
  double lattice_spacing = 0;            // [m]
  // The values a step earlier; empty except with an integrator that carries them.
  Array<double> earlier_velocity_x, earlier_velocity_z, earlier_density;
  // The velocities of the layers on the gap walls [m/s], x and z in turn
  // (terms/gap_friction.hpp); empty without these walls.
  std::vector<Array<double>> layer_velocity;

  std::size_t size() const { return x.size(); }
  double spacing_of(std::size_t i) const { return spacing.empty() ? lattice_spacing : spacing[i]; }

  // Changes the velocity component v along a wall's unit normal to 2 v_wall - v, now and a step
  // earlier.
  void turn_velocity(std::size_t i, double normal_x, double normal_z, double wall_velocity) {
    const auto turn = [=](double& u, double& w) {
      const double excess = 2 * (u * normal_x + w * normal_z - wall_velocity);
      u -= excess * normal_x;
      w -= excess * normal_z;
    };
    turn(velocity_x[i], velocity_z[i]);
    if (!earlier_velocity_x.empty()) turn(earlier_velocity_x[i], earlier_velocity_z[i]);
  }

  // Sets the earlier state to the present one.
  void make_earlier_state() {
    earlier_velocity_x = velocity_x;
    earlier_velocity_z = velocity_z;
    earlier_density = density;
  }

  // Calls visit(name, field) for every field that is not empty.
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    const std::pair<const char*, Array<double>*> fields[]{
        {"x", &x},
        {"z", &z},
        {"velocity_x", &velocity_x},
        {"velocity_z", &velocity_z},
        {"density", &density},
        {"mass", &mass},
        {"spacing", &spacing},
        {"earlier_velocity_x", &earlier_velocity_x},
        {"earlier_velocity_z", &earlier_velocity_z},
        {"earlier_density", &earlier_density}};
    for (const auto& [name, field] : fields)
      if (!field->empty()) visit(name, *field);
    for (std::size_t n = 0; n < layer_velocity.size(); ++n)
      visit(layer_velocity_name(n), layer_velocity[n]);
  }
  template <class Visit>
  void for_each_field(const Visit& visit) {
    for_each_named_field([&](const char*, Array<double>& field) { visit(field); });
  }
};

// Returns the kinetic energy in the frame of the velocities [J/m].
inline double kinetic_energy(const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum +=
        0.5 * p.mass[i] * (p.velocity_x[i] * p.velocity_x[i] + p.velocity_z[i] * p.velocity_z[i]);
  return sum;
}

// Rates of change of the particles, in the order of Particles.
struct Rates {
  Array<double> acceleration_x, acceleration_z;  // [m/s2]
  Array<double> density_rate;                    // [kg/m3/s]

  void resize(std::size_t n) {
    for (auto* field : {&acceleration_x, &acceleration_z, &density_rate}) field->resize(n);
  }
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("acceleration_x", acceleration_x);
    visit("acceleration_z", acceleration_z);
    visit("density_rate", density_rate);
  }
};

// Everything that a pair loop reads of one source, in one cache line. The formulation
// (terms/formulation.hpp) defines `weight` and `strength`.
struct alignas(64) Source {
  double x, z, velocity_x, velocity_z;
  double weight;
  double strength;
  double density;  // [kg/m3]; in the continuity sum of a scheme with diffusion, the diffused one
  double spacing;  // [m]
};

}  // namespace slosh::sph
