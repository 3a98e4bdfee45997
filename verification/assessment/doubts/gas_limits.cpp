#include "verification/assessment/doubts/gas_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

// Programs and stored results of the user may know the gas.
bool leaves_out_gas(const RunDefinition& run) {
  return solver_kind(run).answered_with == AnsweredWith::own_code && !is_record(run) &&
         !sees_gas(run);
}

// Whether the liquid comes to the roof at a gauge, or is expected to where the run has no result.
bool touches_roof(const CaseDefinition& definition, const CaseRuns& runs,
                  const RunDefinition& run) {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  const double roof = definition.tank.height - definition.liquid.fill_depth;
  if (!sph || !runs.results.contains(run.name)) return sph && wave_height(definition) >= roof;
  return std::any_of(
      definition.gauges.begin(), definition.gauges.end(), [&](const GaugeDefinition& gauge) {
        const std::string highest = "highest_surface@" + gauge.name;
        if (!has_series(runs, run.name, highest)) return false;
        const std::vector<double>& found = runs.results.at(run.name).at(highest).value;
        return std::any_of(found.begin(), found.end(),
                           [&](double level) { return level >= roof - sph->particle_spacing; });
      });
}

// Under the gas a liquid leaves a level roof behind a bubble that advances from the end where the
// gas is, at 0.542 sqrt(g H) in a channel of the height H.
void limit_roof(const CaseDefinition& definition, const CaseRuns& runs,
                std::vector<ModelLimit>& limits) {
  const std::optional<double> frequency = flow_frequency(definition);
  const std::vector<std::string> touching =
      runs_with(definition, [&](const auto& run) { return touches_roof(definition, runs, run); });
  if (!frequency || touching.empty()) return;
  const double front = 0.542 * std::sqrt(definition.gravity * definition.tank.height);
  limits.push_back(
      {fmt::format("the gas that must follow where the liquid leaves the roof, at {:.3g} m/s as "
                   "the front of a bubble, 0.542 sqrt(g H), while SPH lets go of the whole roof "
                   "at once, in {}",
                   front, few_of(touching)),
       definition.tank.length / front * *frequency / (2 * std::numbers::pi), 0.1,
       "of the flow's period for the length of the roof", "Benjamin 1968, J. Fluid Mech. 31:209"});
}

}  // namespace

std::vector<ModelLimit> gas_limits(const CaseDefinition& definition, const CaseRuns& case_runs) {
  using std::numbers::pi;
  std::vector<ModelLimit> limits;
  limit_roof(definition, case_runs, limits);
  const std::vector<double> frequencies = natural_frequencies(definition, 1);
  const std::vector<std::string> runs = runs_with(definition, leaves_out_gas);
  if (frequencies.empty() || runs.empty()) return limits;
  const double hertz = frequencies.front() / (2 * pi), lost = share_lost_to_gas(definition);
  limits.push_back(
      {fmt::format("the gas above the liquid, of {:.4g} kg/m3, which lowers the first natural "
                   "frequency from {:.4g} to {:.4g} Hz, in {}",
                   definition.gas.density, hertz, hertz * (1 - lost), few_of(runs)),
       lost, seen_share / (2 * pi), "of the first natural frequency",
       "Lamb, Hydrodynamics, article 231"});
  return limits;
}

}  // namespace slosh
