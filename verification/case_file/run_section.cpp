#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/quantities.hpp"
#include "verification/case_file/time_table.hpp"

namespace slosh {
namespace {

// Fewer layers of particles than this hold no wave; far below any spacing worth running.
constexpr double least_particles_per_depth = 3;

const std::vector<std::string> keys_of_all{"name", "solver", "quick"};
const std::vector<std::string> keys_of_sph{"scheme",
                                           "particle_spacing_m",
                                           "surface_particle_spacing_m",
                                           "variant",
                                           "initial_state",
                                           "smoothing_length_ratio",
                                           "sound_speed_ratio",
                                           "courant_number",
                                           "artificial_viscosity",
                                           "density_diffusion"};
const std::vector<std::string> keys_of_interfoam{"cells_x", "cells_z", "processes"};
const std::vector<std::string> keys_of_linear{"modes", "two_layer", "valid_elevation_over_depth"};
const std::vector<std::string> keys_of_record{"file", "uncertainty_m"};

std::vector<std::string> together(const std::vector<std::vector<std::string>>& lists) {
  std::vector<std::string> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

// A ratio must be positive, what damps may be switched off.
SphNumbers read_numbers(const TomlTable& run) {
  return {.smoothing_length_ratio = run.find("smoothing_length_ratio", positive("1")),
          .sound_speed_ratio = run.find("sound_speed_ratio", positive("1")),
          .courant_number = run.find("courant_number", positive("1")),
          .artificial_viscosity = run.find("artificial_viscosity", not_negative("1")),
          .density_diffusion = run.find("density_diffusion", not_negative("1"))};
}

const Rule<std::string> an_initial_state{
    "one of lattice | settled | projected", [](const std::string& state) {
      return state == "lattice" || state == "settled" || state == "projected";
    }};

SphRun read_sph(const TomlTable& run, const LiquidDefinition& liquid) {
  run.allow_only(together({keys_of_all, keys_of_sph}));
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
          .surface_particle_spacing = surface_spacing.value_or(spacing),
          .variant = run.find("variant", any_text()).value_or(""),
          .initial_state = run.find("initial_state", an_initial_state).value_or(""),
          .numbers = read_numbers(run)};
}

InterFoamRun read_interfoam(const TomlTable& run) {
  run.allow_only(together({keys_of_all, keys_of_interfoam}));
  const int cells_x = run.get("cells_x", at_least(2));
  const int cells_z = run.get("cells_z", at_least(2));
  const auto processes =
      run.find<int>("processes", {fmt::format("an integer from 1 to cells_x ({})", cells_x),
                                  [cells_x](int value) { return value >= 1 && value <= cells_x; }});
  return {.cells_x = cells_x, .cells_z = cells_z, .processes = processes.value_or(1)};
}

LinearRun read_linear(const TomlTable& run) {
  run.allow_only(together({keys_of_all, keys_of_linear}));
  return {
      .modes = run.get("modes", at_least(1)),
      .two_layer = run.flag("two_layer"),
      .valid_elevation_over_depth = run.get("valid_elevation_over_depth", positive("fill depths"))};
}

RecordRun read_record(const TomlTable& run, const CaseDefinition& definition) {
  run.allow_only(together({keys_of_all, keys_of_record}));
  const std::filesystem::path file = definition.file.parent_path() / run.get("file", any_text());
  if (!std::filesystem::is_regular_file(file)) {
    run.refuse("file", "a CSV file's path relative to the case file; there is no " + file.string());
  }
  const std::string unit = compared_unit, ending = "_" + unit;
  std::vector<std::string> columns = compared_quantities(definition);
  for (std::string& column : columns) column += ending;
  TimeTable table = read_time_table(file, columns);
  return {.file = file,
          .quantity = table.column.substr(0, table.column.size() - ending.size()),
          .unit = unit,
          .time = std::move(table.time),
          .value = std::move(table.value),
          .uncertainty = run.find("uncertainty_m", positive(unit))};
}

}  // namespace

RunDefinition read_run(const TomlTable& run, const CaseDefinition& definition) {
  run.allow_only(
      together({keys_of_all, keys_of_sph, keys_of_interfoam, keys_of_linear, keys_of_record}));
  RunDefinition read{.name = run.get("name", file_safe_name()),
                     .solver = {},
                     .quick = run.flag("quick"),
                     .where = run.where()};
  const std::string solver =
      run.choice("solver", "a solver", {"sph", "interfoam", "linear", "record"});
  if (solver == "sph") read.solver = read_sph(run, definition.liquid);
  if (solver == "interfoam") read.solver = read_interfoam(run);
  if (solver == "linear") read.solver = read_linear(run);
  if (solver == "record") read.solver = read_record(run, definition);
  return read;
}

}  // namespace slosh
