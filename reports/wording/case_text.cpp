#include "reports/wording/case_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "verification/case/case_definition.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

std::string history_text(const SineMotion& sine, double si_per_unit, const char* unit) {
  const double degrees = sine.phase / radians_per_degree;
  const std::string phase =
      degrees == 0 ? "" : fmt::format(" {} {:.6g} deg", degrees < 0 ? '-' : '+', std::abs(degrees));
  return fmt::format("{:.6g} {} sin({:.6g} rad/s t{}){}", sine.amplitude / si_per_unit, unit,
                     sine.angular_frequency, phase,
                     sine.ramp_periods > 0
                         ? fmt::format(", ramped over {} {}", sine.ramp_periods,
                                       sine.ramp_periods == 1 ? "period" : "periods")
                         : "");
}

std::string history_text(const SumOfSines& sum, double si_per_unit, const char* unit) {
  std::vector<std::string> sines;
  for (const SineMotion& sine : sum.sines) sines.push_back(history_text(sine, si_per_unit, unit));
  return fmt::format("{}", fmt::join(sines, " + "));
}

std::string history_text(const TableMotion& table, double, const char*) {
  return "the table " + table.file.filename().string();
}

// What a reader must know of a forcing frequency that nobody gave.
std::string found_forcing_text(const CaseDefinition& definition) {
  if (!definition.found_forcing) return "";
  return fmt::format(
      "; its forcing frequency, {:.6g} ± {:.1g} rad/s, was found from the table's spectrum from "
      "{:g} to {:g} s, where the rest of the motion is {:.2g} % of that sine (rms)",
      definition.declared_forcing_frequency.value(), definition.found_forcing->half_width,
      definition.window_begin, definition.window_end, 100 * definition.found_forcing->rest);
}

// By how much the curve through a table goes beyond its largest value, where it does.
std::string overshoot_text(const MotionHistory& history, double position, double acceleration,
                           double si_per_unit, const std::string& unit) {
  const auto* table = std::get_if<TableMotion>(&history);
  if (!table || table->largest == 0) return "";
  const double reached = std::abs(table->of_accelerations ? acceleration : position),
               beyond = reached / table->largest - 1;
  if (beyond < 0.001) return "";
  return fmt::format(
      ", where the curve through the table goes {:.2g} % beyond its largest {}, {:.3g} {}{}",
      100 * beyond, table->of_accelerations ? "acceleration" : "position",
      table->largest / si_per_unit, unit, table->of_accelerations ? "/s2" : "");
}

}  // namespace

MotionPeak peak_of(const CaseDefinition& definition, const std::function<double(double)>& motion) {
  MotionPeak found{0, 0};
  for (const double time : motion_times(definition, definition.sample_interval))
    if (const double value = motion(time); std::abs(value) > std::abs(found.value))
      found = {time, value};
  return found;
}

std::string motion_peaks(const CaseDefinition& definition) {
  std::string text;
  const auto add = [&](const MotionHistory& history, const std::function<double(double)>& position,
                       const std::function<double(double)>& speed,
                       const std::function<double(double)>& acceleration, double si_per_unit,
                       const char* unit) {
    const auto largest = [&](const auto& motion) { return peak_of(definition, motion).value; };
    const double x = largest(position), a = largest(acceleration);
    text += fmt::format("; at most {0:.3g} {3}, {1:.3g} {3}/s and {2:.3g} {3}/s2{4}",
                        std::abs(x) / si_per_unit, std::abs(largest(speed)) / si_per_unit,
                        std::abs(a) / si_per_unit, unit,
                        overshoot_text(history, x, a, si_per_unit, unit));
  };
  const SurgeMotion surge = surge_motion(definition);
  if (definition.motion.surge)
    add(*definition.motion.surge, surge.displacement, surge.velocity, surge.acceleration, 1, "m");
  if (const auto roll = roll_motion(definition))
    add(definition.motion.roll->angle, roll->angle, roll->rate, roll->acceleration,
        radians_per_degree, "deg");
  return text;
}

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
  if (parts.empty()) return "at rest";
  return fmt::format("{}{}", fmt::join(parts, " and "), found_forcing_text(definition));
}

std::string tank_text(const TankDefinition& tank) {
  const std::string size = fmt::format("{:.6g} m long, {:.6g} m high", tank.length, tank.height);
  if (tank.diameter)
    return fmt::format("a lying cylinder of {:g} m diameter, as a polygon of {} corners",
                       *tank.diameter, tank.outline.size());
  if (tank.outline.empty()) return size;
  return fmt::format("a polygon of {} corners, {}", tank.outline.size(), size);
}

std::string liquid_text(const CaseDefinition& definition) {
  std::string text = fmt::format("{} m deep", definition.liquid.fill_depth);
  if (definition.liquid.column_width)
    text +=
        fmt::format(" and {} m wide, released as a breaking dam", *definition.liquid.column_width);
  if (const auto& wave = definition.initial_wave)
    text += fmt::format(
        ", released from rest with a surface wave of {} half wavelengths and {} m at the left wall",
        wave->mode, wave->amplitude);
  for (const ObstacleDefinition& one : definition.obstacles)
    text += fmt::format(", obstacle {} from x = {} to {} m and from z = {} to {} m", one.name,
                        one.left, one.right, one.bottom, one.top);
  return text;
}

std::string short_text(const RunDefinition& run) {
  const auto at_spacing = [&](const std::string& code) {
    const std::optional<double> spacing = particle_spacing(run);
    return spacing ? fmt::format("{} at {:.4g} mm", code, 1000 * *spacing) : code;
  };
  if (const auto* sph = std::get_if<SphRun>(&run.solver))
    return at_spacing(sph->scheme == "recommended" ? "SPH" : "SPH " + sph->scheme);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return fmt::format("{} at {} x {} cells", family(run), mesh->cells_x, mesh->cells_z);
  if (const auto* linear = std::get_if<LinearRun>(&run.solver))
    return linear->two_layer ? "linear theory with the gas" : "linear theory";
  if (std::holds_alternative<ViscousWaveRun>(run.solver)) return "viscous theory";
  if (std::holds_alternative<PotentialRun>(run.solver)) return "potential flow";
  if (const auto* record = std::get_if<RecordRun>(&run.solver))
    return (record->earlier_run ? "the earlier record " : "the record ") + run.name;
  return at_spacing(method_of(run).empty() ? run.name : method_of(run));
}

std::string limit_reason(const std::string& reason, const std::string& source) {
  const auto sentence = [](const std::string& text) {
    return text.ends_with('.') ? text : text + ".";
  };
  return source.empty() ? sentence(reason) : sentence(reason) + " Source: " + sentence(source);
}

std::string name_id(const std::string& name) {
  std::string id;
  for (const char c : name) id += c == '-' ? "--" : std::string(1, c);
  return id;
}

std::string case_id(const std::string& case_name) {
  constexpr std::string_view taken[] = {
      "index", problems_page, across_page, "gate", "worst",  "bias",
      "walls", "problem",     "matrix",    "case", "li2010", "zhao2021",
  };
  const bool is_taken = std::ranges::find(taken, case_name) != std::end(taken);
  return is_taken ? "case-" + case_name : name_id(case_name);
}

std::string appendix_of_case(const std::string& case_name) {
  return case_id(case_name) + "-appendix";
}

std::string case_row_id(const std::string& case_name, std::size_t row) {
  return fmt::format("{}-{}", case_id(case_name), row + 1);
}

std::string problem_row_id(const std::string& problem_name, std::size_t row) {
  return fmt::format("problem-{}-{}", problem_name, row + 1);
}

}  // namespace slosh
