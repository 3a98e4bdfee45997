// A run on one thread whose instructions are counted under valgrind; `recommended` takes about 80
// steps of 900 particles in 0.1 s. It prints lines of KEY|VALUE: the instruction set, the steps,
// particles and terms, the arrays held for the particles [byte], and the total memory held at the
// last sample, counted in operator new [byte].
#include <fmt/format.h>
#include <omp.h>

#include <exception>
#include <string>

#include "sph/counts/counted_memory.hpp"
#include "sph/counts/counted_scenes.hpp"
#include "sph/neighbours/instruction_sets.hpp"

namespace slosh::sph {
namespace {

void print(const RunOutput& output, std::size_t counted_bytes) {
  fmt::print("instruction set|{}\n", instruction_set_name(widest_instruction_set()));
  fmt::print("steps|{}\nparticles|{}\n", output.steps, output.particles);
  for (const std::string& term : output.active_terms) fmt::print("term|{}\n", term);
  for (const HeldArray& array : output.held_arrays)
    fmt::print("held|{}|{}|{}\n", array.purpose, array.name, array.bytes);
  fmt::print("counted|{}\n", counted_bytes);
}

}  // namespace
}  // namespace slosh::sph

int main(int argc, char** argv) try {
  using namespace slosh::sph;
  if (argc != 3) {
    fmt::print(stderr, "usage: {} SCENE DURATION\n", argv[0]);
    return 2;
  }
  omp_set_num_threads(1);
  CountedScene counted = counted_scene(argv[1], std::stod(argv[2]));
  // The run evaluates the displacement in each step and at each sample.
  const std::size_t before = counted_memory().now;
  std::size_t held = 0;
  counted.scene.displacement = [&, place = counted.scene.displacement](double t) {
    held = counted_memory().now - before;
    return place(t);
  };
  const RunOutput output = run(counted.scheme, counted.scene, {});
  print(output, held);
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
