#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

// Trough and crest are equally high: the one must leave the bottom covered, the other stay below
// the roof.
Rule<double> inside_tank(const TankDefinition& tank, double fill_depth) {
  const double most = std::min(fill_depth, tank.height - fill_depth);
  return {fmt::format("a number other than 0 of a magnitude below {:.6g}, in m: shallower than the "
                      "liquid ({}) and below the roof ({} above it)",
                      most, fill_depth, tank.height - fill_depth),
          [most](double amplitude) { return amplitude != 0 && std::abs(amplitude) < most; }};
}

}  // namespace

InitialWaveDefinition read_initial_wave(const TomlTable& wave, const CaseDefinition& definition) {
  wave.allow_only(keys_of("initial_wave"));
  if (definition.liquid.column_width)
    wave.refuse_table("a wave on a dam about to break",
                      "liquid without column_width_m, which stands from wall to wall");
  if (!definition.obstacles.empty())
    wave.refuse_table("a wave over an [[obstacle]]",
                      "a tank without one, whose modes are cosines from wall to wall");
  return {.mode = wave.get("mode", at_least(1)),
          .amplitude =
              wave.get("amplitude_m", inside_tank(definition.tank, definition.liquid.fill_depth))};
}

}  // namespace slosh
