#include "verification/case/natural_modes.hpp"

#include <algorithm>

namespace slosh {

std::vector<int> natural_modes(const CaseDefinition& definition, int count) {
  std::vector<int> modes;
  if (definition.gravity == 0) return modes;
  if (definition.initial_wave) modes.push_back(definition.initial_wave->mode);
  const bool wave_alone = definition.motion.still() && definition.initial_wave;
  for (int n = 0; n < count && !wave_alone; ++n) modes.push_back(2 * n + 1);
  std::sort(modes.begin(), modes.end());
  modes.erase(std::unique(modes.begin(), modes.end()), modes.end());
  modes.resize(std::min<std::size_t>(modes.size(), count));
  return modes;
}

}  // namespace slosh
