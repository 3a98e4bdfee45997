#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"

namespace slosh {
namespace {

// Fewer layers of particles than this hold no wave; far below any spacing worth running.
constexpr double least_particles_per_depth = 3;

SphRun read_sph(const TomlTable& run, const LiquidDefinition& liquid) {
  run.allow_only(
      {"name", "solver", "quick", "scheme", "particle_spacing_m", "surface_particle_spacing_m"});
  const double coarsest = liquid.fill_depth / least_particles_per_depth;
  const double spacing = run.get<double>(
      "particle_spacing_m",
      {fmt::format("a number > 0 and <= a third of the fill depth ({:.4g}), in m", coarsest),
       [coarsest](double value) { return value > 0 && value <= coarsest; }});
  const auto surface_spacing =
      run.find<double>("surface_particle_spacing_m",
                       {fmt::format("a number > 0 and <= particle_spacing_m ({}), in m", spacing),
                        [spacing](double value) { return value > 0 && value <= spacing; }});
  return {.scheme = run.get("scheme", any_text()),
          .particle_spacing = spacing,
          .surface_particle_spacing = surface_spacing.value_or(spacing)};
}

InterFoamRun read_interfoam(const TomlTable& run) {
  run.allow_only({"name", "solver", "quick", "cells_x", "cells_z", "processes"});
  const int cells_x = run.get("cells_x", at_least(2));
  const int cells_z = run.get("cells_z", at_least(2));
  const auto processes =
      run.find<int>("processes", {fmt::format("an integer from 1 to cells_x ({})", cells_x),
                                  [cells_x](int value) { return value >= 1 && value <= cells_x; }});
  return {.cells_x = cells_x, .cells_z = cells_z, .processes = processes.value_or(1)};
}

LinearRun read_linear(const TomlTable& run) {
  run.allow_only({"name", "solver", "quick", "modes", "two_layer", "valid_elevation_over_depth"});
  return {
      .modes = run.get("modes", at_least(1)),
      .two_layer = run.flag("two_layer"),
      .valid_elevation_over_depth = run.get("valid_elevation_over_depth", positive("fill depths"))};
}

}  // namespace

RunDefinition read_run(const TomlTable& run, const LiquidDefinition& liquid) {
  run.allow_only({"name", "solver", "quick", "scheme", "particle_spacing_m",
                  "surface_particle_spacing_m", "cells_x", "cells_z", "processes", "modes",
                  "two_layer", "valid_elevation_over_depth"});
  RunDefinition definition{.name = run.get("name", file_safe_name()),
                           .solver = {},
                           .quick = run.flag("quick"),
                           .where = run.where()};
  const std::string solver = run.choice("solver", "a solver", {"sph", "interfoam", "linear"});
  if (solver == "sph") definition.solver = read_sph(run, liquid);
  if (solver == "interfoam") definition.solver = read_interfoam(run);
  if (solver == "linear") definition.solver = read_linear(run);
  return definition;
}

}  // namespace slosh
