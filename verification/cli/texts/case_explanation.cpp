#include "verification/cli/texts/case_explanation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "reports/wording/case_text.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/cli/texts/result_text.hpp"
#include "verification/gate/gate.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

constexpr std::size_t columns = 80;

// Breaks a text into lines that are indented by `indent` columns.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream stream(text);
  std::string lines, line(indent, ' ');
  for (std::string word; stream >> word;) {
    if (line.size() > indent && line.size() + 1 + word.size() > columns) {
      lines += line + "\n";
      line.assign(indent, ' ');
    }
    line += (line.size() > indent ? " " : "") + word;
  }
  return lines + line + "\n";
}

std::string entry(const std::string& label, const std::string& text) {
  constexpr std::size_t indent = 15;
  std::string lines = wrapped(text, indent);
  return lines.replace(2, label.size(), label);
}

std::string gauges_text(const CaseDefinition& definition) {
  std::vector<std::string> texts;
  for (const GaugeDefinition& gauge : definition.gauges)
    texts.push_back(fmt::format("elevation@{} {:g} m from the left wall", gauge.name, gauge.x));
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    texts.push_back(fmt::format(
        "wall_pressure@{} {}{}", gauge.name, place_on_wall(gauge),
        gauge.filter_cutoff ? fmt::format(", also filtered at {:g} Hz", *gauge.filter_cutoff)
                            : ""));
  for (const ProbeDefinition& probe : definition.probes)
    texts.push_back(fmt::format(
        "velocity_x@{0}, velocity_z@{0} and pressure@{0} {1:g} m from the left wall, {2:g} m above "
        "the bottom",
        probe.name, probe.x, probe.z));
  for (const Wall wall : definition.wall_forces)
    texts.push_back(fmt::format("force_x@{0} and force_z@{0}", name_of(wall, wall_names)));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string frequency_text(double omega) {
  return fmt::format("{:.4g} rad/s ({:.4g} Hz, {:.4g} s)", omega, omega / (2 * std::numbers::pi),
                     2 * std::numbers::pi / omega);
}

std::string frequencies_text(const CaseDefinition& definition) {
  if (definition.gravity == 0) return "none without gravity";
  const std::vector<double> natural = natural_frequencies(definition, 3);
  if (natural.empty()) return "not known of a tank with a ledge under the still surface";
  std::string text;
  for (std::size_t m = 0; m < natural.size(); ++m)
    text += fmt::format("{}{} {}", m == 0 ? "" : "; ", m + 1, frequency_text(natural[m]));
  text += is_rectangle(definition.tank)
              ? " for 1, 2 and 3 half waves between the walls, linear theory of still water"
              : " for the first modes of the section, linear theory of still water";
  std::vector<std::string> ratios;
  for (const ForcedMode& forced : forced_modes(definition))
    ratios.push_back(fmt::format("{:.3g}", forced.angular_frequency / natural.front()));
  if (!ratios.empty())
    text += fmt::format("; the motion has {} times the first", fmt::join(ratios, " and "));
  return text;
}

std::string flow_text(const CaseDefinition& definition) {
  std::string text = "Flow\n";
  text += entry("tank", tank_text(definition.tank));
  text += entry("liquid",
                fmt::format("{}; {:g} kg/m3, {:g} m2/s", liquid_text(definition),
                            definition.liquid.density, definition.liquid.kinematic_viscosity));
  text += entry("motion", motion_text(definition) + motion_peaks(definition));
  text += entry("start",
                fmt::format("at rest in the {}'s frame", name_of(definition.start, start_names)));
  text += entry("time", fmt::format("{:g} s, a sample every {:g} s; compared from {:g} to {:g} s",
                                    definition.duration, definition.sample_interval,
                                    definition.window_begin, definition.window_end));
  text += entry("gauges", gauges_text(definition));
  text += entry("frequencies", frequencies_text(definition));
  return text;
}

std::string number_of_elements(const RunDefinition& run, const KnownRun& known) {
  if (known.start) return fmt::format(", {} particles", known.start->particles);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return fmt::format(" ({})", static_cast<long>(number_of_cells(*mesh)));
  return "";
}

std::string purpose_text(const InputEnd& end, const CaseDefinition& definition) {
  return fmt::format("repeats {} with {} {} by {}, for u_input", end.repeated_run,
                     input_name(end.input), end.change < 0 ? "less" : "more",
                     in_unit(std::abs(end.change), input_unit(end.input, definition.motion)));
}

bool measures_speed(const RunDefinition& run) {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  return sph && sph->speed_from_coarse_run;
}

// The relative loss of a time step from which on it is printed.
constexpr double told_loss = 0.005;

std::string runs_text(const CaseDefinition& definition,
                      const std::map<std::string, KnownRun>& known) {
  std::string text = "Runs and their costs\n";
  std::map<std::string, std::string> told;  // the terms, by the first run that has them
  for (const RunDefinition& run : definition.runs) {
    const auto found = known.find(run.name);
    const KnownRun of_run = found == known.end() ? KnownRun{} : found->second;
    if (is_later_member(run)) continue;
    const std::size_t repeats = members_of(definition, run.name).size();
    text +=
        fmt::format("  {}{}{}\n", run.name,
                    repeats > 1 ? fmt::format("  (an ensemble of {}{}, each:)", repeats,
                                              run.varies_inputs ? ", which draw the inputs" : "")
                                : "",
                    run.quick ? "  (quick form too)" : "");
    if (run.at_input) text += wrapped(purpose_text(*run.at_input, definition), 6);
    text += wrapped(
        solver_text(run) + number_of_elements(run, of_run) + ": " + cost_text(of_run.cost), 6);
    if (of_run.start && measures_speed(run))
      text += wrapped(fmt::format("speed of sound: a coarse run of the same flow measures the "
                                  "expected largest speed first; cost and steps are those of the "
                                  "estimate, {:.4g} m/s",
                                  of_run.start->estimated_speed),
                      6);
    if (of_run.step && of_run.step->lost_to_samples() >= told_loss)
      text += wrapped("steps: " + step_text(*of_run.step, definition.sample_interval), 6);
    if (!of_run.start) continue;
    const std::string terms = fmt::format("{}", fmt::join(of_run.start->active_terms, "; "));
    const auto [first, is_new] = told.try_emplace(terms, run.name);
    text += wrapped(is_new ? "terms: " + terms : "terms: those of " + first->second, 6);
  }
  return text;
}

std::string limits_text(const CaseDefinition& definition) {
  std::string text = "What the models leave out\n";
  for (const ModelLimit& limit : model_limits(definition))
    text += wrapped((limit.exceeded() ? "BEYOND ITS LIMIT: " : "") + limit_text(limit), 2);
  return text;
}

std::string bound_text(const GateRow& row) {
  if (row.improves_on) return "must be nearer to zero than that of " + *row.improves_on;
  if (row.between)
    return fmt::format("must lie between {} and {}", in_unit(row.between->first, row.unit),
                       in_unit(row.between->second, row.unit));
  return "must not exceed " + in_unit(row.limit.value(), row.unit) + " either way";
}

std::string gates_text(const CaseDefinition& definition) {
  if (definition.gate.empty()) return "Gate rows\n  none: the case is only shown\n";
  std::string text = "Gate rows\n";
  for (const GateRow& row : definition.gate) {
    text += wrapped(row_text(row), 2);
    text += wrapped(row.reason + " [" + row.source + "]", 6);
  }
  return text;
}

}  // namespace

std::string row_text(const GateRow& row) {
  const std::string mode = row.mode == "whole" ? "" : fmt::format(" ({})", row.mode);
  const std::string against = row.reference.empty() ? "" : " against " + row.reference;
  const std::string part =
      row.part ? fmt::format(" from {:g} to {:g} s", row.part->first, row.part->second) : "";
  return fmt::format("{}: {} of {}{}{}{} {}.", row.candidate, metric_entry(row.metric).description,
                     row.quantity, mode, part, against, bound_text(row));
}

std::string explanation(const CaseDefinition& definition,
                        const std::map<std::string, KnownRun>& known) {
  std::string text = definition.name + "\n" + wrapped(definition.title, 0);
  text += wrapped("Source: " + definition.source, 0);
  if (!definition.tags.empty())
    text += wrapped(fmt::format("Tags: {}", fmt::join(definition.tags, ", ")), 0);
  return text + "\n" + flow_text(definition) + "\n" + runs_text(definition, known) + "\n" +
         limits_text(definition) + "\n" + gates_text(definition);
}

}  // namespace slosh
