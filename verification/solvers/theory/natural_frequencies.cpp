#include "verification/solvers/theory/natural_frequencies.hpp"

#include <cstddef>
#include <map>
#include <mutex>
#include <stdexcept>

#include "reference/section/section_modes.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/solvers/reference_tank.hpp"

namespace slosh {
namespace {

std::vector<double> frequencies_of_outline(const CaseDefinition& definition, int count) {
  if (count == 0) return {};
  // A report asks for the modes of the same few tanks again and again.
  static std::mutex one_at_a_time;
  static std::map<std::vector<double>, std::vector<double>> found;
  const std::lock_guard lock(one_at_a_time);
  std::vector<double> question{definition.gravity, definition.liquid.fill_depth,
                               static_cast<double>(count)};
  for (const Corner& corner : definition.tank.outline)
    question.insert(question.end(), {corner.x, corner.z});
  std::vector<double>& frequencies = found[question];
  if (!frequencies.empty()) return frequencies;
  try {
    const reference::SectionModes modes(section_of(definition), count);
    for (int mode = 1; mode <= count; ++mode) frequencies.push_back(modes.angular_frequency(mode));
  } catch (const std::invalid_argument&) {
    // The theory knows no ledge under the still surface. A run of it says so in its own words.
  }
  return frequencies;
}

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

std::vector<double> two_layer_frequencies(const CaseDefinition& definition, int count) {
  std::vector<double> frequencies;
  for (int mode = 1; mode <= count; ++mode)
    frequencies.push_back(
        reference::natural_frequency(tank_of(definition), gas_of(definition), mode));
  return frequencies;
}

double share_lost_to_gas(const CaseDefinition& definition) {
  reference::Tank tank = tank_of(definition);
  tank.length = still_surface(definition).length();
  return 1 - reference::natural_frequency(tank, gas_of(definition), 1) /
                 reference::natural_frequency(tank, 1);
}

std::map<int, double> excited_frequencies(const CaseDefinition& definition, int count) {
  const std::vector<int> modes = natural_modes(definition, count);
  const std::vector<double> all = natural_frequencies(definition, modes.empty() ? 0 : modes.back());
  std::map<int, double> excited;
  for (const int mode : modes)
    if (static_cast<std::size_t>(mode) <= all.size())
      excited[mode] = all[static_cast<std::size_t>(mode) - 1];
  return excited;
}

}  // namespace slosh
