#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

constexpr std::size_t fewest_repeats_of_panel = 3;

bool is_one_of(const std::string& text, const std::vector<std::string>& known) {
  return std::find(known.begin(), known.end(), text) != known.end();
}

std::vector<std::string> read_runs_of_panel(const TomlTable& panel,
                                            const CaseDefinition& definition) {
  std::vector<std::string> known, runs;
  for (const RunDefinition& run : definition.runs)
    if (!is_later_member(run)) known.push_back(run.name);
  for (const PlacedText& run : panel.texts("runs", any_text())) {
    const std::size_t place = runs.size();
    if (!is_one_of(run.text, known))
      panel.refuse_element("runs", place, "a run of this case (no later member of an ensemble)");
    if (is_one_of(run.text, runs)) panel.refuse_element("runs", place, "each run once");
    const std::size_t members = members_of(definition, run.text).size();
    if (members < fewest_repeats_of_panel)
      panel.refuse_element(
          "runs", place,
          fmt::format("an ensemble, repeats = {} or more in its [[run]]; it has {}",
                      fewest_repeats_of_panel, members));
    runs.push_back(run.text);
  }
  if (runs.size() < 2) panel.refuse("runs", "two runs or more");
  return runs;
}

std::string read_quantity_of_panel(const TomlTable& panel, const CaseDefinition& definition) {
  const std::vector<std::string> known = compared_quantities(definition);
  if (!panel.has("quantity")) return known.front();
  return panel.choice("quantity", "a compared quantity of this case", known);
}

// Why the metric cannot be measured; empty where it can.
std::string missing_for(PanelMetric metric, const std::string& quantity,
                        const CaseDefinition& definition) {
  if (!panel_metric_entry(metric).of_impact_pressure) return "";
  if (!definition.impacts) return "a case with [impacts]";
  const std::vector<std::string> pressures = impact_pressures(definition);
  if (!is_one_of(quantity, pressures))
    return fmt::format("the quantity {}, the pressure at the gauge of [impacts]",
                       fmt::join(pressures, " or "));
  const bool of_arrival = metric == PanelMetric::impact_arrival || metric == PanelMetric::impulse;
  if (of_arrival && !definition.impacts->arrivals)
    return "arrival_share and arrivals_s in [impacts]";
  if (metric == PanelMetric::plateau && !(definition.impacts->plateau > 0))
    return "plateau_Pa in [impacts]";
  return "";
}

std::vector<PanelMetric> read_metrics_of_panel(const TomlTable& panel, const std::string& quantity,
                                               const CaseDefinition& definition) {
  std::vector<PanelMetric> metrics;
  for (const PlacedText& name : panel.texts("metrics", any_text())) {
    const std::size_t place = metrics.size();
    const auto& table = panel_metric_table();
    const auto entry = std::find_if(table.begin(), table.end(), [&](const PanelMetricEntry& one) {
      return one.name == name.text;
    });
    if (entry == table.end())
      panel.refuse_element(
          "metrics", place,
          fmt::format("a metric of a panel: {}", fmt::join(panel_metric_names(), ", ")));
    if (std::find(metrics.begin(), metrics.end(), entry->metric) != metrics.end())
      panel.refuse_element("metrics", place, "each metric once");
    if (const std::string missing = missing_for(entry->metric, quantity, definition);
        !missing.empty())
      panel.refuse_element("metrics", place,
                           "a metric that the panel has; this one needs " + missing);
    metrics.push_back(entry->metric);
  }
  if (metrics.empty()) panel.refuse("metrics", "one metric or more");
  return metrics;
}

// The duration of the panel, or that of the published impulses; nullopt where no impulse is asked.
std::optional<double> read_impulse_duration(const TomlTable& panel, const PanelDefinition& read,
                                            const CaseDefinition& definition) {
  const char* key = "impulse_duration_s";
  const bool is_asked = std::find(read.metrics.begin(), read.metrics.end(), PanelMetric::impulse) !=
                        read.metrics.end();
  if (!is_asked && panel.has(key)) panel.refuse(key, "no such key without the metric impulse");
  if (!is_asked) return std::nullopt;
  if (!panel.has(key) && definition.impacts->impulses)
    return definition.impacts->impulses->duration;
  return panel.get(key, positive("s"));
}

template <class Value>
std::string setting_text(const char* key, const std::optional<Value>& value) {
  return value ? fmt::format("{} = {}", key, *value) : fmt::format("no {}", key);
}

// What a [[run]] of an OpenFOAM program sets beside its program, its seed and its
// outer_corrections, of which a compressible run may need more, as the case file writes it. The
// binding names all members of InterFoamRun, so that it no longer compiles when one is added.
std::vector<std::string> mesh_settings(const RunDefinition& run) {
  const auto& [cells_x, cells_z, processes, disorder, seed, program, courant_number,
               interface_courant_number, outer_corrections, no_slip, wall_cell, cells_y] =
      std::get<InterFoamRun>(run.solver);
  return {fmt::format("cells_x = {}", cells_x),
          fmt::format("cells_z = {}", cells_z),
          setting_text("cells_y", cells_y),
          setting_text("wall_cell_m", wall_cell),
          fmt::format("courant_number = {}", courant_number),
          fmt::format("interface_courant_number = {}", interface_courant_number),
          fmt::format("no_slip = {}", no_slip),
          fmt::format("processes = {}", processes),
          fmt::format("start_disorder = {}", disorder),
          fmt::format("vary_inputs = {}", run.varies_inputs)};
}

// Returns what the incompressible run must have and what it has instead; "" where the two may be
// compared.
std::string difference_of_pair(const RunDefinition& compressible,
                               const RunDefinition& incompressible) {
  const std::vector<std::string> expected = mesh_settings(compressible);
  const std::vector<std::string> found = mesh_settings(incompressible);
  const auto [one, other] = std::mismatch(expected.begin(), expected.end(), found.begin());
  if (one == expected.end()) return "";
  return fmt::format(
      "a run that differs from {} in its program, its seed and its outer_corrections alone, with "
      "{}; "
      "it has {}",
      compressible.name, *one, *other);
}

std::optional<AirPair> read_air(const TomlTable& panel, const PanelDefinition& read,
                                const CaseDefinition& definition) {
  const char* key = "compressibility";
  if (!panel.has(key)) return std::nullopt;
  const std::vector<PlacedText> pair = panel.texts(key, any_text());
  const auto require = [&](std::size_t place, FoamProgram program) {
    const auto* run =
        is_one_of(pair[place].text, read.runs)
            ? std::get_if<InterFoamRun>(&run_named(definition, pair[place].text).solver)
            : nullptr;
    if (!run || run->program != program)
      panel.refuse_element(
          key, place,
          fmt::format("one of the panel's runs of {}", name_of(program, foam_program_names)));
  };
  if (pair.size() != 2)
    panel.refuse(key, "two of the panel's runs: one of compressibleInterFoam, one of interFoam");
  require(0, FoamProgram::compressible_inter_foam);
  require(1, FoamProgram::inter_foam);
  if (const std::string difference = difference_of_pair(run_named(definition, pair[0].text),
                                                        run_named(definition, pair[1].text));
      !difference.empty())
    panel.refuse_element(key, 1, difference);
  return AirPair{pair[0].text, pair[1].text};
}

}  // namespace

PanelDefinition read_panel(const TomlTable& panel, const CaseDefinition& definition) {
  panel.allow_only(keys_of("panel"));
  PanelDefinition read;
  read.name = panel.get("name", file_safe_name());
  read.runs = read_runs_of_panel(panel, definition);
  read.quantity = read_quantity_of_panel(panel, definition);
  read.metrics = read_metrics_of_panel(panel, read.quantity, definition);
  read.impulse_duration = read_impulse_duration(panel, read, definition);
  read.air = read_air(panel, read, definition);
  read.reason = panel.get("reason", any_text());
  return read;
}

}  // namespace slosh
