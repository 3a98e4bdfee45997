#include "reports/tables/case_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/tables/ablation_table.hpp"
#include "verification/case_file/motion_table.hpp"

namespace slosh {
namespace {

std::string history_text(const SineMotion& sine, double si_per_unit, const char* unit) {
  return fmt::format(
      "{:.6g} {} sin({:.6g} rad/s t){}", sine.amplitude / si_per_unit, unit, sine.angular_frequency,
      sine.ramp_periods > 0 ? fmt::format(", ramped over {} periods", sine.ramp_periods) : "");
}

std::string history_text(const TableMotion& table, double, const char*) {
  return "the table " + table.file.filename().string();
}

std::string text_of(const SphRun& sph) {
  const std::string changes = changes_of(sph);
  std::string text =
      fmt::format("SPH `{}`{}, spacing {:.4g} mm", sph.scheme,
                  changes.empty() ? "" : " with " + changes, 1000 * sph.particle_spacing);
  if (sph.surface_particle_spacing != sph.particle_spacing)
    text += fmt::format(", {:.4g} mm at the surface", 1000 * sph.surface_particle_spacing);
  return text;
}

std::string text_of(const InterFoamRun& mesh) {
  return fmt::format("interFoam, {} x {} cells{}", mesh.cells_x, mesh.cells_z,
                     mesh.processes > 1 ? fmt::format(", {} processes", mesh.processes) : "");
}

std::string text_of(const LinearRun& linear) {
  return fmt::format("linear potential flow{}{}, up to an elevation of {:g} fill depths",
                     linear.modes > 0 ? fmt::format(", {} modes", linear.modes) : "",
                     linear.two_layer ? ", gas in the dispersion relation" : "",
                     linear.valid_elevation_over_depth);
}

std::string text_of(const PotentialRun& potential) {
  return fmt::format("fully nonlinear potential flow, {} x {} nodes", potential.nodes_x,
                     potential.nodes_z);
}

std::string text_of(const ViscousWaveRun& wave) {
  return fmt::format("linear wave of a viscous liquid, up to an elevation of {:g} fill depths",
                     wave.valid_elevation_over_depth);
}

std::string text_of(const ExternalRun& external) {
  return "your program " + external.command.front();
}

std::string text_of(const RecordRun& record) {
  return fmt::format("{} of {}{}", record.earlier_run ? "earlier run's record" : "published record",
                     record.quantity, record.supplied ? "" : ", which you would have to supply");
}

}  // namespace

std::string motion_text(const CaseDefinition& definition) {
  const auto& [surge, roll] = definition.motion;
  const auto text = [](const MotionHistory& history, double si_per_unit, const char* unit) {
    return std::visit([&](const auto& one) { return history_text(one, si_per_unit, unit); },
                      history);
  };
  std::vector<std::string> parts;
  if (surge) parts.push_back("surge X = " + text(*surge, 1, "m"));
  if (roll)
    parts.push_back(
        fmt::format("roll = {} about the point {} m from the left wall and {} m above the bottom",
                    text(roll->angle, radians_per_degree, "deg"), roll->axis_x, roll->axis_z));
  return parts.empty() ? "at rest" : fmt::format("{}", fmt::join(parts, " and "));
}

std::string liquid_text(const CaseDefinition& definition) {
  std::string text = fmt::format("{} m deep", definition.liquid.fill_depth);
  if (definition.liquid.column_width)
    text += fmt::format(" and {} m wide, about to break", *definition.liquid.column_width);
  if (const auto& wave = definition.initial_wave)
    text +=
        fmt::format(", let go from rest under a wave of {} half waves and {} m at the left wall",
                    wave->mode, wave->amplitude);
  for (const ObstacleDefinition& one : definition.obstacles)
    text += fmt::format(", obstacle {} from {} to {} m along and {} to {} m up", one.name, one.left,
                        one.right, one.bottom, one.top);
  return text;
}

std::string solver_text(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return text_of(solver); }, run.solver);
}

}  // namespace slosh
