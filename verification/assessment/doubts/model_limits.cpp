#include "verification/assessment/doubts/model_limits.hpp"

#include "verification/assessment/doubts/compression_limits.hpp"
#include "verification/assessment/doubts/damping_limits.hpp"
#include "verification/assessment/doubts/gap_limits.hpp"
#include "verification/assessment/doubts/gas_limits.hpp"
#include "verification/assessment/doubts/motion_noise.hpp"
#include "verification/assessment/doubts/surface_tension_limits.hpp"

namespace slosh {

std::vector<ModelLimit> model_limits(const CaseDefinition& definition, const CaseRuns& runs) {
  std::vector<ModelLimit> limits;
  for (const auto& some : {damping_limits(definition), gap_limits(definition),
                           gas_limits(definition, runs), surface_tension_limits(definition),
                           compression_limits(definition, runs), motion_noise(definition)})
    limits.insert(limits.end(), some.begin(), some.end());
  return limits;
}

}  // namespace slosh
