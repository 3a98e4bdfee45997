#include "sph/benchmarks/answer_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/benchmarks/flows.hpp"
#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/tests/all_pairs_oracle.hpp"
#include "sph/tests/formulas_of_choice.hpp"

namespace slosh::sph {
namespace {

double difference(const Array<double>& a, const Array<double>& b) {
  double largest_difference = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i])) return a[i];
    largest_difference = std::max(largest_difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return largest_difference / largest;
}

// Throws std::runtime_error for a difference above round-off, and for NaN.
void require_round_off(const char* name, InstructionSet set, const char* rate, double found) {
  constexpr double round_off = 1e-11;
  if (!(found <= round_off))
    throw std::runtime_error(fmt::format(
        "{}, {}: the {} differs from that over all pairs by {} of the largest, expected {}", name,
        instruction_set_name(set), rate, found, round_off));
}

template <class Choice>
void check(const char* name) {
  const Scene scene = benchmark_scene(16, {});
  const Scheme<Choice> scheme(scene);
  Liquid liquid(scene, method_of(scheme), flowing(scene, scheme, Flow::violent));
  const Rates expected =
      AllPairs(scheme.setting, formulas_of<Choice>(), liquid.particles, liquid.tank_at(0).walls)
          .rates();
  for (const InstructionSet set : instruction_sets) {
    if (!has(set)) continue;
    liquid.use(set);
    liquid.accelerate(0);
    liquid.compress(0);
    require_round_off(name, set, "horizontal acceleration",
                      difference(liquid.rates.acceleration_x, expected.acceleration_x));
    require_round_off(name, set, "vertical acceleration",
                      difference(liquid.rates.acceleration_z, expected.acceleration_z));
    require_round_off(name, set, "density rate",
                      difference(liquid.rates.density_rate, expected.density_rate));
  }
}

}  // namespace

void check_pair_sums() {
  check<Recommended>("recommended");
  check<WithWendlandC2>("recommended with Wendland C2");
  check<Li2010>("li2010");
}

}  // namespace slosh::sph
