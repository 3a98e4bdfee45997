#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include "verification/case/case_definition.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/field_times.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

const MetricEntry& read_metric(const TomlTable& row) {
  return metric_entry(row.choice("metric", "a metric", names_of(metric_table())));
}

std::vector<std::string> impact_names(const ImpactsDefinition& impacts) {
  std::vector<std::string> names;
  for (std::size_t n = 1; n <= impacts.times.size(); ++n)
    names.push_back(fmt::format("impact_{}", n));
  return names;
}

std::vector<std::string> fitted_to(const std::string& quantity, const CaseDefinition& definition) {
  if (!has_modes(quantity)) return {};
  std::vector<std::string> modes;
  for (const ForcedMode& forced : forced_modes(definition)) modes.push_back(forced.name);
  for (const int n : natural_modes(definition, definition.natural_modes))
    modes.push_back(fmt::format("natural_{}", n));
  return modes;
}

bool is_of_one_impact(const MetricEntry& metric) {
  return metric.measured_on == MeasuredOn::impact ||
         metric.measured_on == MeasuredOn::repeated_impact;
}

std::vector<std::string> modes_of(const MetricEntry& metric, const std::string& quantity,
                                  const CaseDefinition& definition) {
  if (is_of_one_impact(metric)) return impact_names(definition.impacts.value());
  if (is_of_fields(metric.metric)) {
    std::vector<std::string> modes{"whole"};
    for (std::string& moment : moment_names(definition)) modes.push_back(std::move(moment));
    return modes;
  }
  return measured_modes(metric, fitted_to(quantity, definition), !has_modes(quantity));
}

const RecordRun* as_record(const CaseDefinition& definition, const std::string& run) {
  for (const RunDefinition& one : definition.runs)
    if (one.name == run) return std::get_if<RecordRun>(&one.solver);
  return nullptr;
}

// A published record is a reference and never a candidate. The first member represents an ensemble.
std::vector<std::string> candidates(const CaseDefinition& definition) {
  return names_where(definition.runs, [](const RunDefinition& run) {
    return !is_record(run) && !is_later_member(run);
  });
}

std::vector<std::string> runs_besides(const std::vector<std::string>& excluded,
                                      const CaseDefinition& definition) {
  return names_where(definition.runs, [&](const RunDefinition& run) {
    return !is_later_member(run) &&
           std::find(excluded.begin(), excluded.end(), run.name) == excluded.end();
  });
}

BoundScales scales_of(const CaseDefinition& definition, const std::string& unit) {
  return {.window = definition.window_end - definition.window_begin,
          .impact_period = definition.impacts ? definition.impacts->period : 0,
          .tank = largest_in_tank(definition, unit)};
}

std::pair<double, double> read_range(const TomlTable& row, const MetricEntry& metric,
                                     const CaseDefinition& definition, const std::string& unit) {
  const double lower = row.get("lower", any_number(unit));
  return {lower, row.get("upper", upper_rule(metric, unit, scales_of(definition, unit), lower))};
}

// Reads exactly one of limit, lower with upper, and improves_on.
void read_bound(const TomlTable& row, const MetricEntry& metric, const CaseDefinition& definition,
                GateRow& gate_row) {
  std::vector<std::string> given;
  for (const char* key : {"limit", "lower", "upper", "improves_on"}) {
    if (row.has(key)) given.push_back(key);
  }
  if (given == std::vector<std::string>{"limit"}) {
    gate_row.limit =
        row.get("limit", limit_rule(metric, gate_row.unit, scales_of(definition, gate_row.unit)));
  } else if (given == std::vector<std::string>{"lower", "upper"}) {
    gate_row.between = read_range(row, metric, definition, gate_row.unit);
  } else if (given == std::vector<std::string>{"improves_on"}) {
    gate_row.improves_on =
        row.choice("improves_on", "a run other than the candidate and the reference",
                   runs_besides({gate_row.candidate, gate_row.reference}, definition));
  } else {
    row.refuse_table(fmt::format("{{{}}}", fmt::join(given, ", ")),
                     "exactly one of limit | lower with upper | improves_on");
  }
}

// Returns whether two rows bound the same metric of the same runs, and in the same way: by a limit
// or range, by the improvement on the same run, or by the cost of the same error.
bool bounds_the_same(const GateRow& a, const GateRow& b) {
  const auto subject = [](const GateRow& row) {
    return std::tie(row.candidate, row.reference, row.quantity, row.mode, row.metric, row.error,
                    row.improves_on, row.part);
  };
  return subject(a) == subject(b);
}

// Two such rows would be ambiguous.
void refuse_second_bound(const TomlTable& row, const CaseDefinition& definition,
                         const GateRow& gate_row) {
  for (const GateRow& other : definition.gate)
    if (bounds_the_same(other, gate_row))
      row.refuse_table(
          fmt::format("a second bound on {} of {}", metric_name(gate_row.metric),
                      gate_row.candidate),
          fmt::format("one row for each candidate, reference, quantity, mode and metric; the first "
                      "is at {}:{}",
                      other.where.file, other.where.line));
}

// The part of the run over which the row is judged.
void read_part(const TomlTable& row, const MetricEntry& metric, const CaseDefinition& definition,
               GateRow& gate_row) {
  const char *begin = "part_begin_s", *end = "part_end_s";
  if (!row.has(begin) && !row.has(end)) return;
  if (metric.metric == Metric::initial_value || is_of_impacts(metric.metric) ||
      is_of_fields(metric.metric) || is_cost(metric.metric))
    row.refuse(row.has(begin) ? begin : end,
               fmt::format("no such key: {} is measured at its own times", metric.name));
  double from = 0, to = definition.duration;
  if (row.has(begin))
    from = row.get(begin, Rule<double>{fmt::format("a number >= 0 and below {:g}, in s", to),
                                       [=](double time) { return time >= 0 && time < to; }});
  if (row.has(end))
    to = row.get(end, Rule<double>{fmt::format("a number above {:g} and <= {:g}, in s", from, to),
                                   [=](double time) { return time > from && time <= to; }});
  gate_row.part = {from, to};
}

// A metric of a band is of a record that has one.
void require_band(const TomlTable& row, const MetricEntry& metric, const RecordRun* record) {
  if (is_of_band(metric.metric) && !(record && record->has_band))
    row.refuse("reference",
               fmt::format("a record with lower_column and upper_column: {} is measured on their "
                           "band",
                           metric.name));
}

// The quantity of the record, and the filtered one beside it where its gauge has a filter.
std::vector<std::string> quantities_of(const RecordRun& record, const CaseDefinition& definition) {
  std::vector<std::string> quantities{record.quantity};
  const std::string filtered = record.quantity + through_filter;
  for (const std::string& one : compared_quantities(definition))
    if (one == filtered) quantities.push_back(one);
  return quantities;
}

// Some metrics take a limit alone, others a range alone.
void require_form_of_bound(const TomlTable& row, const MetricEntry& metric,
                           const GateRow& gate_row) {
  const std::string name = fmt::format("a row on {}", metric.name);
  if (metric.bound.form == BoundForm::limit && !gate_row.limit)
    row.refuse_table(name, fmt::format("limit: {}", metric.bound.because));
  if (metric.bound.form == BoundForm::range && !gate_row.between)
    row.refuse_table(name, fmt::format("lower with upper: {}", metric.bound.because));
}

// The first of the known texts is the default.
std::string choice_or_first(const TomlTable& row, const char* key, const std::string& expected,
                            const std::vector<std::string>& known) {
  return row.has(key) || known.empty() ? row.choice(key, expected, known) : known.front();
}

// What to write where a row asks for a forced mode of a motion that has none, which is a table.
std::string where_forced_is_named(const TomlTable& row, const CaseDefinition& definition) {
  const bool asks = row.has("mode") && is_forced(row.written("mode"));
  if (!asks || definition.motion.still() || !forced_modes(definition).empty()) return "";
  return " (the table has a forced mode where [comparison] gives forcing_frequency_Hz, or "
         "forcing = \"from_spectrum\")";
}

// The default is the forced mode, where there is one, else the first natural mode. Of several
// impacts or forced modes one must be named.
std::string read_mode(const TomlTable& row, const MetricEntry& metric, const std::string& quantity,
                      const CaseDefinition& definition) {
  const std::vector<std::string> modes = modes_of(metric, quantity, definition);
  const std::string expected = measured_on_text(metric) + where_forced_is_named(row, definition);
  const bool must_be_named =
      is_of_one_impact(metric) || std::count_if(modes.begin(), modes.end(), is_forced) > 1;
  return must_be_named ? row.choice("mode", expected, modes)
                       : choice_or_first(row, "mode", expected, modes);
}

std::string read_unit(const TomlTable& row, const std::string& of, const std::string& unit) {
  return choice_or_first(row, "unit", fmt::format("the unit of {}", of), {unit});
}

void refuse_reference(const TomlTable& row, const MetricEntry& metric, const char* measured_on) {
  if (row.has("reference"))
    row.refuse("reference",
               fmt::format("no reference: {} is measured on {}", metric.name, measured_on));
}

void read_compared_series(const TomlTable& row, const MetricEntry& metric,
                          const CaseDefinition& definition, GateRow& gate_row) {
  gate_row.reference = row.choice("reference", "a run other than the candidate",
                                  runs_besides({gate_row.candidate}, definition));
  const RecordRun* record = as_record(definition, gate_row.reference);
  require_band(row, metric, record);
  gate_row.quantity = record ? choice_or_first(row, "quantity", "the record's quantity",
                                               quantities_of(*record, definition))
                             : choice_or_first(row, "quantity", "a compared quantity",
                                               compared_quantities(definition));
  gate_row.unit =
      read_unit(row, metric.name, metric_unit(metric.metric, unit_of(gate_row.quantity)));
}

// Which series a solver records beside the compared quantities, and in which unit, is known only
// after the run. The gate reports a wrong name or unit then, and the row is not compared.
void read_own_series(const TomlTable& row, const MetricEntry& metric,
                     const CaseDefinition& definition, GateRow& gate_row) {
  refuse_reference(row, metric, "the candidate alone");
  const auto compared = compared_quantities(definition);
  gate_row.quantity = row.find("quantity", any_text()).value_or(compared.front());
  const bool known =
      std::find(compared.begin(), compared.end(), gate_row.quantity) != compared.end();
  if (*metric.unit) {
    gate_row.unit = read_unit(row, metric.name, metric.unit);
  } else {
    gate_row.unit = known ? read_unit(row, gate_row.quantity, unit_of(gate_row.quantity))
                          : row.get("unit", any_text());
  }
  const bool takes_the_rest = metric.metric == Metric::largest_magnitude &&
                              (gate_row.unit == "Pa" || gate_row.unit.starts_with("N"));
  if ((metric.metric == Metric::initial_value || takes_the_rest) &&
      counts_from_its_first_value(definition, gate_row.candidate, gate_row.quantity))
    row.refuse("metric",
               fmt::format("another metric: {} of {} counts from its first value (datum = "
                           "\"first\"), so that its {}",
                           gate_row.quantity, gate_row.candidate,
                           takes_the_rest ? "largest_magnitude is without the load at rest"
                                          : "initial_value is 0 whatever the program prints"));
}

// Each metric of impacts needs what it compares with.
void require_published(const TomlTable& row, Metric metric, const ImpactsDefinition& impacts) {
  const auto require = [&](bool published, const char* keys) {
    if (!published)
      row.refuse("metric", fmt::format("a metric that needs no {} in [impacts], which this case "
                                       "does not have",
                                       keys));
  };
  if (metric == Metric::plateau_error) require(impacts.plateau > 0, "plateau_Pa");
  if (metric == Metric::impact_arrival || metric == Metric::impulse_error)
    require(impacts.arrivals.has_value(), "arrivals_s");
  if (metric == Metric::impulse_error) require(impacts.impulses.has_value(), "impulses_Pa_s");
  if (is_of_repeats(metric)) require(!impacts.peak_table.empty(), "peak_table");
}

// Reads the pressure at the gauge of the case's impacts, unfiltered or filtered.
void read_impact_series(const TomlTable& row, const MetricEntry& metric,
                        const CaseDefinition& definition, GateRow& gate_row) {
  refuse_reference(row, metric, "the published impacts");
  if (!definition.impacts)
    row.refuse("metric", "a metric that needs no [impacts], which this case does not have");
  require_published(row, metric.metric, *definition.impacts);
  gate_row.quantity = choice_or_first(row, "quantity", "the pressure at the gauge of [impacts]",
                                      impact_pressures(definition));
  gate_row.unit = read_unit(row, metric.name, metric.unit);
}

// The reference's mesh is what the fields are compared on, and its liquid is known by cells.
std::vector<std::string> meshes_besides(const std::string& candidate,
                                        const CaseDefinition& definition) {
  return names_where(definition.runs, [&](const RunDefinition& run) {
    return std::holds_alternative<InterFoamRun>(run.solver) && !is_later_member(run) &&
           run.name != candidate;
  });
}

void read_field(const TomlTable& row, const MetricEntry& metric, const CaseDefinition& definition,
                GateRow& gate_row) {
  if (definition.snapshot_times.empty())
    row.refuse("metric",
               "a metric that needs no snapshot_times_s in [time], which this case lacks");
  if (!(definition.gravity > 0))
    row.refuse("metric", "a metric that needs no gravity, which this case lacks");
  gate_row.reference = row.choice("reference", "an OpenFOAM run other than the candidate",
                                  meshes_besides(gate_row.candidate, definition));
  gate_row.quantity = choice_or_first(row, "quantity", "the pressure field", {pressure_field});
  gate_row.unit = read_unit(row, metric.name, metric.unit);
}

bool takes_reference(const TomlTable& row) {
  for (const MetricEntry& entry : metric_table())
    if (entry.name == row.written("metric"))
      return !is_of_candidate_alone(entry.metric) && !is_of_impacts(entry.metric);
  return true;
}

}  // namespace

void finish_gate_row(const TomlTable& row, const CaseDefinition& definition, GateRow& gate_row) {
  gate_row.candidate = row.choice("candidate", "a run", candidates(definition));
  const MetricEntry& metric = read_metric(row);
  gate_row.metric = metric.metric;
  if (is_of_candidate_alone(metric.metric)) {
    read_own_series(row, metric, definition, gate_row);
  } else if (is_of_impacts(metric.metric)) {
    read_impact_series(row, metric, definition, gate_row);
  } else if (is_of_fields(metric.metric)) {
    read_field(row, metric, definition, gate_row);
  } else {
    read_compared_series(row, metric, definition, gate_row);
  }
  gate_row.mode = read_mode(row, metric, gate_row.quantity, definition);
  read_bound(row, metric, definition, gate_row);
  if (gate_row.error && !is_cost(metric.metric))
    row.refuse("error", "no error: only cost_to_reach is of one");
  read_part(row, metric, definition, gate_row);
  require_form_of_bound(row, metric, gate_row);
  const RecordRun* record = as_record(definition, gate_row.reference);
  if (record && record->earlier_run && gate_row.kind != RowKind::regression)
    row.refuse("kind", "regression: the reference is an earlier run of this harness");
  if (gate_row.source.empty()) gate_row.source = measured_before;
  gate_row.where = row.where();
  refuse_second_bound(row, definition, gate_row);
}

// A pattern never means the reference, which the row rule would refuse as a candidate. In a group
// the reference is that of the metrics that take one.
std::vector<TomlTable> gate_rows(const TomlTable& group, const CaseDefinition& definition) {
  std::vector<std::string> names = candidates(definition);
  std::erase(names, group.written("reference"));
  std::vector<TomlTable> rows = rows_of_group(group, {.key = "candidate",
                                                      .key_of_several = "candidates",
                                                      .what = "a run",
                                                      .names = std::move(names),
                                                      .metrics = names_of(metric_table()),
                                                      .table = "gate"});
  if (std::any_of(rows.begin(), rows.end(), takes_reference))
    for (TomlTable& row : rows)
      if (!takes_reference(row)) row = row.without({"reference"});
  return rows;
}

}  // namespace slosh
