#include "verification/runs/filtered_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "verification/case/changed_input.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

std::optional<TimeSeries> find_series(const RunResult& result, const std::string& name) {
  for (const TimeSeries& one : result.series)
    if (one.name == name) return one;
  return std::nullopt;
}

void replace_series(RunResult& result, TimeSeries series) {
  std::erase_if(result.series, [&](const TimeSeries& one) { return one.name == series.name; });
  result.series.push_back(std::move(series));
}

// The lowest of the section at x [m].
double floor_at(const TankDefinition& tank, double x) {
  double lowest = tank.height;
  const Outline corners = corners_of(tank);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
    if (x < std::min(from.x, to.x) || x > std::max(from.x, to.x)) continue;
    lowest =
        std::min(lowest, from.x == to.x ? std::min(from.z, to.z)
                                        : std::lerp(from.z, to.z, (x - from.x) / (to.x - from.x)));
  }
  return lowest;
}

}  // namespace

std::vector<std::string> add_filtered_pressures(const CaseDefinition& definition,
                                                RunResult& result) {
  std::vector<std::string> failures;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    if (!gauge.filter_cutoff) continue;
    const std::string quantity = wall_pressure(gauge.name);
    for (const std::string suffix : {"", lower_edge, upper_edge, coarser, finer, nonlinear}) {
      const std::optional<TimeSeries> series = find_series(result, quantity + suffix);
      if (!series) continue;
      try {
        TimeSeries filtered = low_pass(*series, *gauge.filter_cutoff);
        filtered.name = quantity + through_filter + suffix;
        replace_series(result, std::move(filtered));
      } catch (const ComparisonError& error) {
        failures.push_back(error.what());
      }
    }
  }
  return failures;
}

void raise_dry_gauges(const CaseDefinition& definition, const RunDefinition& run,
                      RunResult& result) {
  if (!solver_kind(run).solves_flow) return;
  const double depth = definition_solved_by(run, definition).liquid.fill_depth;
  for (const GaugeDefinition& gauge : definition.gauges) {
    const double floor = floor_at(definition.tank, gauge.x) - depth;
    for (TimeSeries& series : result.series) {
      const Quantity* quantity = find_quantity(series.name);
      if (!quantity || quantity->at != MeasuredAt::surface_gauge ||
          !series.name.ends_with("@" + gauge.name))
        continue;
      for (double& value : series.value)
        if (value < floor) value = floor;  // NaN stays
    }
  }
}

}  // namespace slosh
