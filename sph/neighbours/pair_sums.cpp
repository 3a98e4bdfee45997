#include "sph/neighbours/pair_sums.hpp"

#include <algorithm>

namespace slosh::sph {
namespace {

struct PullOfParticles {
  template <Vector Number>
  static void run(const Tank* tank, double gravity, std::size_t begin, std::size_t end,
                  const Particles* particles, Rates* rates) {
    const Particles& p = *particles;
    if (!tank->forces) {
      // The product is 0; for a constant the compiler would call memset.
      const Number x = Number{} + 0.0 * gravity, z = Number{} - gravity;
      for (std::size_t i = begin; i < end; i += lanes_of<Number>) {
        store(&rates->acceleration_x[i], x, end - i);
        store(&rates->acceleration_z[i], z, end - i);
      }
      return;
    }
    const InertialForces forces = *tank->forces;
    for (std::size_t i = begin; i < end; i += lanes_of<Number>) {
      Number x, z;
      forces.pull(gravity, load<Number>(&p.x[i]), load<Number>(&p.z[i]),
                  load<Number>(&p.velocity_x[i]), load<Number>(&p.velocity_z[i]), x, z);
      store(&rates->acceleration_x[i], x, end - i);
      store(&rates->acceleration_z[i], z, end - i);
    }
  }
};

}  // namespace

void set_to_pull(const Tank& tank, double gravity, const Particles& particles, Rates& rates,
                 InstructionSet set) {
  constexpr std::size_t block = 512;
  const std::size_t n = particles.size();
#pragma omp parallel for schedule(static)
  for (std::size_t begin = 0; begin < n; begin += block)
    call_in_registers<PullOfParticles>(set, &tank, gravity, begin, std::min(n, begin + block),
                                       &particles, &rates);
}

}  // namespace slosh::sph
