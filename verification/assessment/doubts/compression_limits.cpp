#include "verification/assessment/doubts/compression_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/solvers/particles/expected_speed.hpp"

namespace slosh {
namespace {

constexpr double atmospheric_pressure = 101325;  // [Pa]
// The highest mean peak of SPHERIC's benchmark 10, 4816 Pa of water on the side wall, over
// rho V^2 = 1160 Pa.
constexpr double peak_over_rho_v2 = 4;
constexpr double seen_compression = 0.01 * (1 + 1e-9);  // that at the Mach number 0.1
constexpr const char* weakly_compressible = "Monaghan 1994, J. Comput. Phys. 110:399";

struct Impact {
  double pressure;  // [Pa]
  std::string by;
};

std::optional<Impact> declared_impact(const CaseDefinition& definition) {
  if (!definition.impacts || definition.impacts->peak_means.empty()) return {};
  const auto& peaks = definition.impacts->peak_means;
  return Impact{*std::max_element(peaks.begin(), peaks.end()), "the declared impacts"};
}

// Sampled pressures without a filter have the sound of the impacts in them.
std::optional<Impact> recorded_impact(const CaseDefinition& definition, const CaseRuns& runs) {
  std::optional<Impact> highest;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    if (is_under_still_water(definition, gauge)) continue;
    const std::string quantity = smoothest_pressure(gauge);
    for (const auto& [run, result] : runs.results) {
      if (!has_series(runs, run, quantity) || result.at(quantity).value.empty()) continue;
      const auto& values = result.at(quantity).value;
      const double peak = *std::max_element(values.begin(), values.end());
      if (!highest || peak > highest->pressure)
        highest = Impact{peak, fmt::format("the highest {} recorded, {:.3g} kPa of {}", quantity,
                                           1e-3 * peak, run)};
    }
  }
  return highest;
}

std::optional<Impact> expected_impact(const CaseDefinition& definition) {
  if (!may_strike_a_gauge(definition)) return {};
  const double speed = expected_speed(definition);
  return Impact{
      peak_over_rho_v2 * definition.liquid.density * speed * speed,
      fmt::format(
          "impacts of an assumed {:g} rho V^2, the highest of SPHERIC's benchmark 10, at the "
          "expected speed V = {:.2g} m/s, {}sqrt(g h) plus the tank's largest speed",
          peak_over_rho_v2, speed, definition.liquid.column_width ? "2 " : "")};
}

void limit_air(const CaseDefinition& definition, const CaseRuns& runs,
               std::vector<ModelLimit>& limits) {
  std::optional<Impact> impact = declared_impact(definition);
  if (!impact) impact = recorded_impact(definition, runs);
  if (!impact) impact = expected_impact(definition);
  if (impact)
    limits.push_back({"the compression of trapped air by " + impact->by,
                      impact->pressure / atmospheric_pressure, 0.1,
                      "of the pressure of the atmosphere",
                      "Bagnold 1939; Dias & Ghidaglia 2018, Annu. Rev. Fluid Mech. 50:243"});
}

void limit_chosen_sound(const CaseDefinition& definition, const CaseRuns& runs,
                        std::vector<ModelLimit>& limits) {
  const auto soft = runs_with(definition, [&](const RunDefinition& run) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    return sph && sph->numbers.sound_speed_ratio && !runs.results.contains(run.name);
  });
  double lowest = 0;
  for (const std::string& name : soft) {
    const double ratio =
        *std::get<SphRun>(run_named(definition, name).solver).numbers.sound_speed_ratio;
    lowest = lowest == 0 ? ratio : std::min(lowest, ratio);
  }
  if (!soft.empty())
    limits.push_back({"the compressibility of the liquid in " + few_of(soft), 1 / (lowest * lowest),
                      seen_compression, "of the density", weakly_compressible});
}

}  // namespace

std::vector<ModelLimit> compression_limits(const CaseDefinition& definition, const CaseRuns& runs) {
  std::vector<ModelLimit> limits;
  limit_air(definition, runs, limits);
  limit_chosen_sound(definition, runs, limits);
  return limits;
}

}  // namespace slosh
