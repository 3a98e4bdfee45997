#include "verification/campaign/expected_cost.hpp"

#include <cmath>

namespace slosh {

double expected_cost(const CaseDefinition& definition, const RunDefinition& run) {
  const double area = definition.liquid.column_width.value_or(definition.tank.length) *
                      definition.liquid.fill_depth;
  if (const auto* sph = std::get_if<SphRun>(&run.solver))
    return definition.duration * 2e-6 * area / std::pow(sph->particle_spacing, 3);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return definition.duration * 5e-4 * mesh->cells_x * mesh->cells_z;
  return 0;
}

}  // namespace slosh
