#include "verification/solvers/particles/expected_speed.hpp"

#include "sph/scheme.hpp"
#include "verification/solvers/sph_scene.hpp"

namespace slosh {

double expected_speed(const CaseDefinition& definition) {
  return sph::expected_speed(sph_scene(definition, {}));  // no run changes it
}

}  // namespace slosh
