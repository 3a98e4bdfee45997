#include "verification/assessment/validity_envelope.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/series/time_series.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// Returns NaN where the result does not record it.
double recorded(const RunResult& result, const char* name) {
  const auto found = result.diagnostics.find(name);
  return found == result.diagnostics.end() ? not_a_number : found->second;
}

double amplitude_of(const MotionHistory& history) {
  if (const auto* table = std::get_if<TableMotion>(&history))
    return largest_magnitude(table->value);
  double amplitude = 0;
  for (const SineMotion& sine : sines_of(history)) amplitude += sine.amplitude;
  return amplitude;
}

// The amplitude of the motion [m]; a roll counts as the surge of the tank's ends, theta L / 2.
double forcing_amplitude(const CaseDefinition& definition) {
  const auto& [surge, roll] = definition.motion;
  double amplitude = 0;
  if (surge) amplitude += amplitude_of(*surge);
  if (roll) amplitude += amplitude_of(roll->angle) * definition.tank.length / 2;
  return amplitude;
}

// The detuning |(omega / omega_n)^2 - 1| from which on the response stays proportional.
double least_detuning(const CaseDefinition& definition) {
  return std::pow(forcing_amplitude(definition) / still_surface(definition).length(), 2.0 / 3);
}

using Reasons = std::vector<std::string>;

constexpr int most_modes = 256;

// The theory's natural frequencies up to the first from `end` [rad/s] on, or as many as there are.
std::vector<double> natural_up_to(double end, const LinearRun& linear,
                                  const CaseDefinition& definition) {
  std::vector<double> natural;
  for (int count = 4; count <= most_modes; count *= 2) {
    natural = linear.two_layer ? two_layer_frequencies(definition, count)
                               : natural_frequencies(definition, count);
    if (std::ssize(natural) < count || !(natural.back() < end)) break;
  }
  return natural;
}

// Names the natural modes, of those that surge and roll excite, that are too near to the forcing.
void add_too_near_resonance(const LinearRun& linear, const CaseDefinition& definition,
                            Reasons& reasons) {
  const double least = least_detuning(definition);
  const auto step = static_cast<std::size_t>(excited_mode_step(definition.tank));
  for (const ForcedMode& forced : forced_modes(definition)) {
    const double forcing = forced.angular_frequency;
    const std::vector<double> natural = natural_up_to(2 * forcing, linear, definition);
    if (std::ssize(natural) == most_modes && natural.back() < forcing)
      reasons.push_back(fmt::format(
          "is forced at {:.3g} rad/s, above the {:.3g} rad/s of its natural mode {}, the last that "
          "is asked for resonance",
          forcing, natural.back(), most_modes));
    for (std::size_t m = 1; m <= natural.size(); m += step) {
      if (m > 1 && !(natural[m - 1] < 2 * forcing)) break;
      const double ratio = forcing / natural[m - 1];
      const double detuning = std::abs(ratio * ratio - 1);
      if (!(detuning >= least))
        reasons.push_back(fmt::format(
            "is forced at {:.3g} times its natural mode {}: a detuning of {:.2g} where the "
            "response stays proportional to the motion from {:.2g} on",
            ratio, m, detuning, least));
    }
  }
}

// [1/m], of the initial wave or else of the first mode.
double wave_number(const CaseDefinition& definition) {
  const int mode = definition.initial_wave ? definition.initial_wave->mode : 1;
  return mode * pi / still_surface(definition).length();
}

// The share of that wave which the liquid damps in its bulk until the window's end, 1 - exp(-2
// nu k^2 t) (Lamb, Hydrodynamics, article 348).
double share_lost_to_viscosity(const CaseDefinition& definition) {
  const double k = wave_number(definition);
  return -std::expm1(-2 * definition.liquid.kinematic_viscosity * k * k * definition.window_end);
}

void add_without_viscosity(const CaseDefinition& definition, Reasons& reasons) {
  const double lost = share_lost_to_viscosity(definition);
  if (!(lost <= most_left_out))
    reasons.push_back(
        fmt::format("has no viscosity, by which the wave loses {:.2g} % until {:.4g} s, "
                    "valid to {:g} %",
                    100 * lost, definition.window_end, 100 * most_left_out));
}

void add_without_gas(const CaseDefinition& definition, Reasons& reasons) {
  const double lost = definition.gravity == 0 ? 0 : share_lost_to_gas(definition);
  if (!(lost <= most_left_out))
    reasons.push_back(
        fmt::format("has no gas, which lowers the first natural frequency by {:.2g} %, valid to "
                    "{:g} %",
                    100 * lost, 100 * most_left_out));
}

// Why a wave is too high for a theory of small waves.
Reasons too_high(double valid_elevation_over_depth, const CaseDefinition& definition,
                 const RunResult& result) {
  Reasons reasons;
  const double over_depth = recorded(result, "highest_elevation_over_depth");
  if (!(over_depth <= valid_elevation_over_depth))
    reasons.push_back(fmt::format("predicts an elevation of {:.3g} fill depths, valid to {:.3g}",
                                  over_depth, valid_elevation_over_depth));
  const double steepness = predicted_steepness(definition, result);
  if (!(steepness <= steepest_linear_wave))
    reasons.push_back(fmt::format("predicts a steepness k A of {:.3g}, valid to {:.3g}", steepness,
                                  steepest_linear_wave));
  const double highest = over_depth * definition.liquid.fill_depth,
               roof = definition.tank.height - definition.liquid.fill_depth;
  if (!(highest < roof))
    reasons.push_back(
        fmt::format("predicts an elevation of {:.3g} m under a roof {:.3g} m above the still level",
                    highest, roof));
  return reasons;
}

std::optional<std::string> joined(const Reasons& reasons) {
  if (reasons.empty()) return {};
  return fmt::format("{}", fmt::join(reasons, "; it "));
}

std::optional<std::string> outside(const LinearRun& linear, const CaseDefinition& definition,
                                   const RunResult& result) {
  Reasons reasons = too_high(linear.valid_elevation_over_depth, definition, result);
  add_too_near_resonance(linear, definition, reasons);
  add_without_viscosity(definition, reasons);
  if (!linear.two_layer) add_without_gas(definition, reasons);
  return joined(reasons);
}

std::optional<std::string> outside(const ViscousWaveRun& viscous, const CaseDefinition& definition,
                                   const RunResult& result) {
  Reasons reasons = too_high(viscous.valid_elevation_over_depth, definition, result);
  add_without_gas(definition, reasons);
  return joined(reasons);
}

std::optional<std::string> outside(const PotentialRun&, const CaseDefinition& definition,
                                   const RunResult& result) {
  Reasons reasons;
  const double valid_until = recorded(result, "valid_until_s");
  const auto because = result.provenance.find("left_range_because");
  if (!(valid_until >= definition.window_end))
    reasons.push_back(fmt::format(
        "leaves its range at {:.4g} s, before the window's end at {:.4g} s{}", valid_until,
        definition.window_end, because == result.provenance.end() ? "" : ": " + because->second));
  add_without_viscosity(definition, reasons);
  add_without_gas(definition, reasons);
  return joined(reasons);
}

std::string small_wave_range(double valid_elevation_over_depth, const CaseDefinition& definition,
                             const RunResult& result) {
  return fmt::format(
      "an elevation of at most {:g} fill depths and below the roof, of which it predicts {:.3g}; a "
      "steepness k A of at most {:g}, of which it predicts {:.3g}",
      valid_elevation_over_depth, recorded(result, "highest_elevation_over_depth"),
      steepest_linear_wave, predicted_steepness(definition, result));
}

std::string viscosity_range(const CaseDefinition& definition) {
  return fmt::format("; a loss of the wave to viscosity of at most {:g} %, here {:.2g} %",
                     100 * most_left_out, 100 * share_lost_to_viscosity(definition));
}

std::string gas_range(const CaseDefinition& definition) {
  if (definition.gravity == 0) return "";
  return fmt::format(
      "; a first natural frequency that the gas lowers by at most {:g} %, here "
      "{:.2g} %",
      100 * most_left_out, 100 * share_lost_to_gas(definition));
}

std::string range_of(const LinearRun& linear, const CaseDefinition& definition,
                     const RunResult& result) {
  std::string text = small_wave_range(linear.valid_elevation_over_depth, definition, result);
  if (!forced_modes(definition).empty())
    text += fmt::format(
        "; a detuning |(omega / omega_n)^2 - 1| of at least {:.2g} from each natural mode n that "
        "the motion excites",
        least_detuning(definition));
  return text + viscosity_range(definition) + (linear.two_layer ? "" : gas_range(definition));
}

std::string range_of(const ViscousWaveRun& viscous, const CaseDefinition& definition,
                     const RunResult& result) {
  return small_wave_range(viscous.valid_elevation_over_depth, definition, result) +
         gas_range(definition);
}

std::string range_of(const PotentialRun&, const CaseDefinition& definition,
                     const RunResult& result) {
  const auto because = result.provenance.find("left_range_because");
  return fmt::format("valid to {:.6g} s{}", recorded(result, "valid_until_s"),
                     because == result.provenance.end() ? "" : ": " + because->second) +
         viscosity_range(definition) + gas_range(definition);
}

std::string range_of(const auto&, const CaseDefinition&, const RunResult&) { return ""; }

// Simulations, records, programs of the user's and stored results declare no range.
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
std::optional<std::string> outside(const StoredRun&, const CaseDefinition&, const RunResult&) {
  return {};
}

}  // namespace

std::string validity_range(const CaseDefinition& definition, const RunDefinition& run,
                           const RunResult& result) {
  return std::visit([&](const auto& solver) { return range_of(solver, definition, result); },
                    run.solver);
}

double predicted_steepness(const CaseDefinition& definition, const RunResult& result) {
  return wave_number(definition) * recorded(result, "highest_elevation_over_depth") *
         definition.liquid.fill_depth;
}

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
