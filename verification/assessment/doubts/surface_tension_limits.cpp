#include "verification/assessment/doubts/surface_tension_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/solvers/particles/expected_speed.hpp"

namespace slosh {
namespace {

using std::numbers::pi;
constexpr double surface_tension = 0.073;  // [N/m], clean water in air

// Returns the spacing of a run's particles or the size of its cells [m].
std::optional<double> smallest_length(const RunDefinition& run, const TankDefinition& tank) {
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return std::min(tank.length / mesh->cells_x, tank.height / mesh->cells_z);
  return particle_spacing(run);
}

void limit_wave(const CaseDefinition& definition, std::vector<ModelLimit>& limits) {
  const double k = pi / still_surface(definition).length();
  limits.push_back(
      {"surface tension, of 0.073 N/m",
       0.5 * k * k * surface_tension / (definition.liquid.density * definition.gravity), 0.001,
       "of the first natural frequency", "Lamb, Hydrodynamics, article 267"});
}

void limit_gap(const CaseDefinition& definition, std::vector<ModelLimit>& limits) {
  if (!definition.tank.breadth) return;
  const double height = wave_height(definition);
  if (height == 0) return;
  const double pressure = 2 * surface_tension / *definition.tank.breadth;
  limits.push_back({fmt::format("the capillary pressure between the gap walls, of at "
                                "most {:.2g} Pa in waves about {:.2g} m high",
                                pressure, height),
                    pressure / (definition.liquid.density * definition.gravity * height),
                    seen_share * pi / 8, "of the wave's pressure",
                    "Viola, Brun & Gallaire 2018, J. Fluid Mech. 837:788"});
}

void limit_impact(const CaseDefinition& definition, std::vector<ModelLimit>& limits) {
  if (!may_strike_a_gauge(definition)) return;
  const double speed = expected_speed(definition);
  const double pressure = definition.liquid.density * speed * speed;
  std::optional<double> finest;
  std::string of;
  for (const RunDefinition& run : definition.runs)
    if (const auto length = smallest_length(run, definition.tank);
        length && !(finest && *finest <= *length)) {
      finest = length;
      of = run.name;
    }
  if (!finest || pressure == 0) return;
  // A tenth of a pressure makes it doubtful, as with the trapped air of compression_limits.cpp.
  limits.push_back(
      {fmt::format("surface tension on the smallest drops that {} has, of {:.3g} mm, which at "
                   "{:.2g} m/s have the Weber number {:.0f}",
                   of, 1e3 * *finest, speed, pressure * *finest / surface_tension),
       surface_tension / (*finest * pressure), 0.1, "of the impact's rho V^2",
       "Heller 2011, J. Hydraul. Res. 49:293"});
}

}  // namespace

std::vector<ModelLimit> surface_tension_limits(const CaseDefinition& definition) {
  std::vector<ModelLimit> limits;
  if (definition.gravity > 0) {
    limit_wave(definition, limits);
    limit_gap(definition, limits);
  }
  limit_impact(definition, limits);
  return limits;
}

}  // namespace slosh
