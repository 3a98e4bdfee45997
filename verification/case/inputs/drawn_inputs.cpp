#include "verification/case/inputs/drawn_inputs.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <random>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"

namespace slosh {
namespace {

constexpr double half_widths_per_deviation = 1 / 1.959963984540054;  // of the 95 % interval
constexpr double roundings = 1e6;  // in a half width: more than any measurement has

// In half widths. The standard fixes the numbers of the generator and of its seeding to the bit
// ([rand.predef], [rand.util.seedseq]), not those of its distributions.
double drawn_share(int seed, Input input) {
  std::seed_seq seeding{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(input)};
  std::mt19937_64 generator(seeding);
  const double uniform = (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53;  // 0 < u < 1
  const double z = boost::math::quantile(boost::math::normal(), uniform);
  return std::round(z * half_widths_per_deviation * roundings) / roundings;
}

}  // namespace

std::vector<InputChange> drawn_inputs(const std::vector<InputUncertainty>& inputs, int seed) {
  std::vector<InputChange> drawn;
  for (const InputUncertainty& one : inputs)
    drawn.push_back({one.input, one.half_width * drawn_share(seed, one.input)});
  return drawn;
}

void draw_inputs(CaseDefinition& definition) {
  for (RunDefinition& run : definition.runs)
    if (run.varies_inputs) run.drawn_inputs = drawn_inputs(definition.inputs, start_seed(run));
}

std::string drawn_inputs_text(const RunDefinition& run, const MotionDefinition& motion) {
  std::string text;
  for (const auto& [input, change] : run.drawn_inputs)
    text += fmt::format("{}{} {:+.4g} {}", text.empty() ? "" : ", ", input_name(input), change,
                        input_unit(input, motion));
  return text;
}

}  // namespace slosh
