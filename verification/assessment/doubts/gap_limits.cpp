#include "verification/assessment/doubts/gap_limits.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/case/gap_friction.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

bool is_plane(const RunDefinition& run) {
  const auto* mesh = std::get_if<InterFoamRun>(&run.solver);
  return mesh && !mesh->cells_y;
}

ModelLimit undeclared_breadth(const CaseDefinition& definition, double layer) {
  const double length = definition.tank.length;
  return {fmt::format("the friction of the gap walls, for which the breadth is taken "
                      "to be the length, {:.3g} m, as the case declares no breadth_m; a tank "
                      "narrower than {:.2g} m is beyond the limit and must declare it",
                      length, pi * layer / seen_share),
          pi * layer / length, seen_share, of_amplitude, "Landau & Lifshitz 1987, section 24"};
}

}  // namespace

std::vector<ModelLimit> gap_limits(const CaseDefinition& definition) {
  const std::optional<double> frequency = flow_frequency(definition);
  if (!frequency) return {};
  const std::optional<double> gap = definition.tank.breadth;
  if (!gap) return {undeclared_breadth(definition, stokes_layer(definition, *frequency))};
  const std::vector<std::string> runs = runs_with(definition, is_plane);
  if (runs.empty()) return {};
  const double mass =
      layers_between_walls(*gap, definition.liquid.kinematic_viscosity, *frequency).added_mass;
  return {{fmt::format("the added mass of the layers on the gap walls, which lowers a "
                       "natural frequency by {:.2g} %, in {}",
                       100 * mass / 2, few_of(runs)),
           mass, seen_share / pi, "of the liquid's inertia",
           "Landau & Lifshitz 1987, section 24, problem 6"}};
}

}  // namespace slosh
