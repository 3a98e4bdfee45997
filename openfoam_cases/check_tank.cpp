#include "openfoam_cases/check_tank.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace slosh::openfoam {

void require(bool condition, const char* key, double value, const std::string& expected) {
  if (!condition) {
    throw std::invalid_argument(
        fmt::format("OpenFOAM tank: {} = {}: expected {}", key, value, expected));
  }
}

namespace {

void require_positive(const char* key, double value, const char* unit) {
  require(value > 0 && std::isfinite(value), key, value,
          fmt::format("a positive number of {}", unit));
}

}  // namespace

void check_tank(const SurgingTank& tank) {
  require_positive("length", tank.length, "m");
  require_positive("height", tank.height, "m");
  require_positive("fill_depth", tank.fill_depth, "m");
  require(tank.fill_depth < tank.height, "fill_depth", tank.fill_depth,
          fmt::format("less than the height of {} m", tank.height));
  require_positive("gravity", tank.gravity, "m/s2");
  for (const Fluid& fluid : {tank.liquid, tank.gas}) {
    require_positive("density", fluid.density, "kg/m3");
    require(fluid.kinematic_viscosity >= 0 && std::isfinite(fluid.kinematic_viscosity),
            "kinematic_viscosity", fluid.kinematic_viscosity, "m2/s, zero or above");
  }
  require(std::isfinite(tank.initial_relative_velocity), "initial_relative_velocity",
          tank.initial_relative_velocity, "a finite velocity in m/s");
  require_positive("duration", tank.duration, "s");
  require_positive("sample_interval", tank.sample_interval, "s");
  require(tank.sample_interval <= tank.duration, "sample_interval", tank.sample_interval,
          fmt::format("at most the duration of {} s", tank.duration));
  require(tank.cells_x >= 2, "cells_x", tank.cells_x, "at least 2");
  require(tank.cells_z >= 2, "cells_z", tank.cells_z, "at least 2");
  require(tank.processes >= 1 && tank.processes <= tank.cells_x, "processes", tank.processes,
          "between 1 and cells_x");
  std::set<std::string> names;
  for (const Gauge& gauge : tank.gauges) {
    require(gauge.x >= 0 && gauge.x <= tank.length, "gauge x", gauge.x,
            fmt::format("between the walls, 0 and {} m", tank.length));
    if (!names.insert(gauge.name).second) {
      throw std::invalid_argument("OpenFOAM tank: two gauges are named \"" + gauge.name + "\"");
    }
  }
}

}  // namespace slosh::openfoam
