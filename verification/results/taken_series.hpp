// Moves the histories that SPH and interFoam both record into the series of a result.
#pragma once

#include <string>
#include <utility>

#include "verification/results/result_file.hpp"

namespace slosh {

// Adds the history as a series unless it is empty: the solver did not record it then.
template <class History>
void take_series(const std::string& name, const std::string& unit, History& history,
                 RunResult& result) {
  if (!history.time.empty())
    result.series.push_back({name, unit, std::move(history.time), std::move(history.value)});
}

// Adds the series that both solvers have; `output` is that of either.
template <class Output>
void take_common_series(Output& output, RunResult& result) {
  for (auto& [gauge, history] : output.elevation)
    take_series("elevation@" + gauge, "m", history, result);
  for (auto& [gauge, history] : output.highest_surface)
    take_series("highest_surface@" + gauge, "m", history, result);
  for (auto& [gauge, history] : output.wall_pressure)
    take_series("wall_pressure@" + gauge, "Pa", history, result);
  for (auto& [probe, history] : output.velocity_x)
    take_series("velocity_x@" + probe, "m/s", history, result);
  for (auto& [probe, history] : output.velocity_z)
    take_series("velocity_z@" + probe, "m/s", history, result);
  for (auto& [probe, history] : output.pressure)
    take_series("pressure@" + probe, "Pa", history, result);
  for (auto& [wall, history] : output.wall_force_x)
    take_series("force_x@" + wall, "N/m", history, result);
  for (auto& [wall, history] : output.wall_force_z)
    take_series("force_z@" + wall, "N/m", history, result);
  take_series("front_position", "m", output.front_position, result);
  take_series("force_x", "N/m", output.force_x, result);
  take_series("force_z", "N/m", output.force_z, result);
  take_series("moment", "N", output.moment, result);
  take_series("momentum_x", "kg/s", output.momentum_x, result);
  take_series("momentum_z", "kg/s", output.momentum_z, result);
}

}  // namespace slosh
