// The liquid's particles, and the sources that the pair loops read: each a structure of arrays,
// aligned for vector loads. A source is a liquid particle or one of its mirror images
// (mirror_particles.hpp); sources are sorted by cell, so that a particle's neighbours lie in a
// few contiguous runs (cell_grid.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace slosh::sph {

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  bool operator==(const CacheLineAllocator&) const { return true; }
};

template <class T>
using Array = std::vector<T, CacheLineAllocator<T>>;

// The pair loops read sources in vectors of this many and give no weight to what lies past a run's
// end, so that they need no remainder loop.
inline constexpr std::size_t vector_length = 8;

// The state that is carried from step to step; positions and velocities in the earth's frame.
struct Particles {
  Array<double> x, z;                    // [m]
  Array<double> velocity_x, velocity_z;  // [m/s]
  Array<double> density;                 // [kg/m3]
  Array<double> mass;                    // [kg/m]
  Array<double> spacing;                 // [m], the width of the lattice cell that it was laid in

  std::size_t size() const { return x.size(); }

  template <class Visit>
  void for_each_field(const Visit& visit) {
    for (auto* field : {&x, &z, &velocity_x, &velocity_z, &density, &mass, &spacing}) visit(*field);
  }
};

// Rates of change of the particles, in the order of Particles.
struct Rates {
  Array<double> acceleration_x, acceleration_z;  // [m/s2]
  Array<double> density_rate;                    // [kg/m3/s]

  void resize(std::size_t n) {
    for (auto* field : {&acceleration_x, &acceleration_z, &density_rate}) field->resize(n);
  }
};

// What the pair loops read of each source. What `strength` and `weight` are is the formulation's
// choice (formulation.hpp). The last three exist only where a scheme's policies read them.
struct Sources {
  Array<double> x, z, velocity_x, velocity_z;
  Array<double> strength, weight;
  Array<double> density;          // [kg/m3]
  Array<double> dynamic_density;  // [kg/m3], density above the hydrostatic one
  Array<double> spacing;          // [m]

  std::size_t size() const { return x.size(); }
};

}  // namespace slosh::sph
