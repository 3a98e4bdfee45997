#include "verification/assessment/validity_envelope.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/case/motion.hpp"
#include "verification/series/time_series.hpp"
#include "verification/solvers/reference_tank.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// Returns NaN where the result does not record it.
double recorded(const RunResult& result, const char* name) {
  const auto found = result.diagnostics.find(name);
  return found == result.diagnostics.end() ? not_a_number : found->second;
}

double amplitude_of(const MotionHistory& history) {
  if (const auto* sine = std::get_if<SineMotion>(&history)) return sine->amplitude;
  return largest_magnitude(std::get<TableMotion>(history).value);
}

// The amplitude of the motion [m]; a roll counts as the surge of the tank's ends, theta L / 2.
double forcing_amplitude(const CaseDefinition& definition) {
  const auto& [surge, roll] = definition.motion;
  double amplitude = 0;
  if (surge) amplitude += amplitude_of(*surge);
  if (roll) amplitude += amplitude_of(roll->angle) * definition.tank.length / 2;
  return amplitude;
}

// Names a natural mode, of those that surge and roll excite, that is too near to the forcing.
std::optional<std::string> too_near_resonance(const CaseDefinition& definition) {
  const double forcing = forcing_frequency(definition);
  if (!(forcing > 0)) return {};
  const reference::Tank tank = tank_of(definition);
  const double least = std::pow(forcing_amplitude(definition) / tank.length, 2.0 / 3);
  for (int m = 1; m == 1 || reference::natural_frequency(tank, m) < 2 * forcing; m += 2) {
    const double ratio = forcing / reference::natural_frequency(tank, m);
    const double detuning = std::abs(ratio * ratio - 1);
    if (!(detuning >= least))
      return fmt::format(
          "is forced at {:.3g} times its natural mode {}: a detuning of {:.2g} where the response "
          "stays proportional to the motion from {:.2g} on",
          ratio, m, detuning, least);
  }
  return {};
}

// Why a wave is too high for a theory of small waves.
std::optional<std::string> too_high(double valid_elevation_over_depth,
                                    const CaseDefinition& definition, const RunResult& result) {
  const double over_depth = recorded(result, "highest_elevation_over_depth");
  if (!(over_depth <= valid_elevation_over_depth))
    return fmt::format("predicts an elevation of {:.3g} fill depths, valid to {:.3g}", over_depth,
                       valid_elevation_over_depth);
  const double steepness = pi / definition.tank.length * over_depth * definition.liquid.fill_depth;
  if (!(steepness <= steepest_linear_wave))
    return fmt::format("predicts a steepness k A of {:.3g}, valid to {:.3g}", steepness,
                       steepest_linear_wave);
  return {};
}

std::optional<std::string> outside(const LinearRun& linear, const CaseDefinition& definition,
                                   const RunResult& result) {
  if (auto reason = too_high(linear.valid_elevation_over_depth, definition, result)) return reason;
  return too_near_resonance(definition);
}

std::optional<std::string> outside(const ViscousWaveRun& viscous, const CaseDefinition& definition,
                                   const RunResult& result) {
  return too_high(viscous.valid_elevation_over_depth, definition, result);
}

std::optional<std::string> outside(const PotentialRun&, const CaseDefinition& definition,
                                   const RunResult& result) {
  const double valid_until = recorded(result, "valid_until_s");
  if (valid_until >= definition.window_end) return {};
  const auto because = result.provenance.find("left_range_because");
  return fmt::format("leaves its range at {:.4g} s, before the window's end at {:.4g} s{}",
                     valid_until, definition.window_end,
                     because == result.provenance.end() ? "" : ": " + because->second);
}

// Simulations, records and programs of the user's declare no range.
std::optional<std::string> outside(const SphRun&, const CaseDefinition&, const RunResult&) {
  return {};
}
std::optional<std::string> outside(const InterFoamRun&, const CaseDefinition&, const RunResult&) {
  return {};
}
std::optional<std::string> outside(const RecordRun&, const CaseDefinition&, const RunResult&) {
  return {};
}
std::optional<std::string> outside(const ExternalRun&, const CaseDefinition&, const RunResult&) {
  return {};
}

}  // namespace

std::optional<std::string> outside_validity(const CaseDefinition& definition,
                                            const RunDefinition& run, const RunResult& result) {
  return std::visit([&](const auto& solver) { return outside(solver, definition, result); },
                    run.solver);
}

void mark_out_of_range(const CaseDefinition& definition, CaseRuns& runs) {
  for (const auto& [name, result] : runs.results)
    if (const auto reason = outside_validity(definition, run_named(definition, name), result))
      runs.status[name] = {RunState::out_of_range, *reason};
}

}  // namespace slosh
