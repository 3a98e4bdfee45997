// How linear theory samples a motion without a closed form: one by a table at its points, between
// which Duhamel's integral is exact (motion_times.hpp), a ramped sine at steps.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/surge_response.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"

namespace slosh {

// Samples in each sample interval. Duhamel's integral takes X'' as linear between them; its
// relative error (omega step)^2 / 12 is below 1e-4 where a forcing period has 50 samples.
inline constexpr int motion_samples_per_sample = 4;
// [s] The error is the same up to 14 rad/s, and a case that is finely sampled for its impacts needs
// no more memory.
inline constexpr double shortest_motion_step = 2.5e-3;

inline double motion_step(const CaseDefinition& definition) {
  return std::max(shortest_motion_step, definition.sample_interval / motion_samples_per_sample);
}

// Returns the sines of the surge where it has a closed form, as sines without a ramp have, else
// none.
inline std::vector<SineMotion> closed_form_sines(const CaseDefinition& definition) {
  if (!definition.motion.surge) return {};
  std::vector<SineMotion> sines = sines_of(*definition.motion.surge);
  const bool ramped = std::any_of(sines.begin(), sines.end(),
                                  [](const SineMotion& sine) { return sine.ramp_periods > 0; });
  return ramped ? std::vector<SineMotion>{} : sines;
}

// Returns the solutions whose sum is the surge: one for each sine, or one for the whole motion.
// `solve` makes a solution of a reference::SineSurge or a reference::AnySurge.
template <class Solution, class Solve>
std::vector<Solution> surges_of(const CaseDefinition& definition, const Solve& solve) {
  std::vector<Solution> surges;
  if (!definition.motion.surge) return surges;
  for (const SineMotion& sine : closed_form_sines(definition))
    surges.push_back(
        solve(reference::SineSurge{sine.amplitude, sine.angular_frequency, sine.phase}));
  if (!surges.empty()) return surges;
  const SurgeMotion motion = surge_motion(definition);
  surges.push_back(solve(reference::AnySurge{
      motion.velocity(0), motion.acceleration, definition.duration, motion_step(definition),
      motion_knots(*definition.motion.surge, definition.duration)}));
  return surges;
}

}  // namespace slosh
