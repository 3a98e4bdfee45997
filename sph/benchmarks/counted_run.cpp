// A short run whose instructions are counted (instruction_count_test.sh): some 100 steps of 900
// particles of the named scheme, on one thread. Prints the instruction set that it used.
#include <fmt/format.h>
#include <omp.h>

#include <exception>

#include "sph/neighbours/instruction_sets.hpp"
#include "sph/tests/surging_scene.hpp"

int main(int argc, char** argv) try {
  using namespace slosh::sph;
  if (argc != 2) {
    fmt::print(stderr, "usage: {} SCHEME\n", argv[0]);
    return 2;
  }
  omp_set_num_threads(1);
  const double particle_spacing = 0.02, duration = 0.13;
  Scene scene = surging_scene(particle_spacing, duration);
  scene.initial_state = InitialState::lattice;  // steps, and no projection
  run(argv[1], scene, {});
  fmt::print("{}\n", instruction_set_name(widest_instruction_set()));
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
