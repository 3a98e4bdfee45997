#include "verification/case/ensemble.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>

#include "verification/case/changed_input.hpp"

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

int& seed_of(RunDefinition& run) {
  return std::visit(
      [](auto& solver) -> int& {
        if constexpr (requires { solver.start_seed; })
          return solver.start_seed;
        else
          throw std::bad_variant_access();  // the case parser gives such a run no repeats
      },
      run.solver);
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

std::vector<RunDefinition> ensemble_of(const RunDefinition& first, int repeats, int quick_repeats) {
  std::vector<RunDefinition> members;
  for (int k = 0; k < repeats; ++k) {
    RunDefinition member = first;
    member.ensemble = first.name;
    member.quick = first.quick && k < quick_repeats;
    seed_of(member) += k;
    if (k > 0) member.name = fmt::format("{}_{}", first.name, k + 1);
    members.push_back(std::move(member));
  }
  return members;
}

bool may_repeat(const RunDefinition& run) {
  return std::holds_alternative<SphRun>(run.solver) ||
         std::holds_alternative<InterFoamRun>(run.solver);
}

int start_seed(const RunDefinition& run) {
  RunDefinition copy = run;
  return seed_of(copy);
}

bool is_later_member(const RunDefinition& run) {
  return !run.ensemble.empty() && run.ensemble != run.name;
}

std::vector<std::string> members_of(const CaseDefinition& definition, const std::string& run) {
  std::vector<std::string> members;
  for (const RunDefinition& one : definition.runs)
    if (one.name == run || one.ensemble == run) members.push_back(one.name);
  return members;
}

void keep_quick_members(CaseDefinition& definition) {
  std::set<std::string> quick;
  for (const RunDefinition& run : definition.runs)
    if (run.quick) quick.insert(run.ensemble);
  std::erase_if(definition.runs, [&](const RunDefinition& run) {
    return is_later_member(run) && !run.quick && quick.contains(run.ensemble);
  });
}

}  // namespace slosh
