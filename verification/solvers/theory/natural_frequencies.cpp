#include "verification/solvers/theory/natural_frequencies.hpp"

#include <cstddef>

#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/solvers/reference_tank.hpp"

namespace slosh {
namespace {

std::vector<double> frequencies_of_outline(const CaseDefinition&, int) { return {}; }

}  // namespace

std::vector<double> natural_frequencies(const CaseDefinition& definition, int count) {
  if (definition.gravity == 0) return {};
  if (!is_rectangle(definition.tank)) return frequencies_of_outline(definition, count);
  const reference::Tank tank = tank_of(definition);
  std::vector<double> frequencies;
  for (int mode = 1; mode <= count; ++mode)
    frequencies.push_back(reference::natural_frequency(tank, mode));
  return frequencies;
}

std::vector<double> excited_frequencies(const CaseDefinition& definition, int count) {
  const std::vector<int> modes = natural_modes(definition, count);
  const std::vector<double> all = natural_frequencies(definition, modes.empty() ? 0 : modes.back());
  std::vector<double> excited;
  for (const int mode : modes)
    if (static_cast<std::size_t>(mode) <= all.size())
      excited.push_back(all[static_cast<std::size_t>(mode) - 1]);
  return excited;
}

}  // namespace slosh
