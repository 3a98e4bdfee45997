#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/motion.hpp"
#include "verification/case_file/quantities.hpp"
#include "verification/case_file/row_kind.hpp"

namespace slosh {
namespace {

// What a metric is measured on. A forced mode's frequency is given and it does not decay: a row on
// either would pass whatever the candidate did. What swings has the lags of its modes, what runs
// away one.
enum class MeasuredOn {
  any_mode,
  natural_mode,
  whole_window,
  wave,  // the whole window of what swings
  run_away,
  own_series,
  impact,
  plateau
};

struct MetricEntry {
  const char* name;
  Metric metric;
  const char* unit;  // "": the quantity's
  MeasuredOn measured_on;
};

constexpr std::array<MetricEntry, 21> metrics{{
    {"amplitude_error", Metric::amplitude_error, "1", MeasuredOn::any_mode},
    {"phase_lag", Metric::phase_lag, "deg", MeasuredOn::any_mode},
    {"frequency_error", Metric::frequency_error, "1", MeasuredOn::natural_mode},
    {"decay_rate", Metric::decay_rate, "1/s", MeasuredOn::natural_mode},
    {"decay_error", Metric::decay_error, "1", MeasuredOn::natural_mode},
    {"normalised_rms", Metric::normalised_rms, "1", MeasuredOn::whole_window},
    {"maximum_residual", Metric::maximum_residual, "", MeasuredOn::whole_window},
    {"time_lag", Metric::time_lag, "s", MeasuredOn::run_away},
    {"aligned_rms", Metric::aligned_rms, "1", MeasuredOn::run_away},
    {"largest_magnitude", Metric::largest_magnitude, "", MeasuredOn::own_series},
    {"band_energy_error", Metric::band_energy_error, "1", MeasuredOn::any_mode},
    {"spectral_peak_error", Metric::spectral_peak_error, "1", MeasuredOn::wave},
    {"rms_error", Metric::rms_error, "1", MeasuredOn::whole_window},
    {"crest_error", Metric::crest_error, "1", MeasuredOn::wave},
    {"trough_error", Metric::trough_error, "1", MeasuredOn::wave},
    {"mean_offset", Metric::mean_offset, "", MeasuredOn::whole_window},
    {"noise_share", Metric::noise_share, "1", MeasuredOn::own_series},
    {"impact_time", Metric::impact_time, "s", MeasuredOn::impact},
    {"plateau_error", Metric::plateau_error, "1", MeasuredOn::plateau},
    {"impact_percentile", Metric::impact_percentile, "1", MeasuredOn::impact},
    {"cost_to_reach", Metric::cost_to_reach, "s", MeasuredOn::whole_window},
}};

const MetricEntry& read_metric(const TomlTable& row) {
  std::vector<std::string> names;
  for (const MetricEntry& entry : metrics) names.push_back(entry.name);
  const std::string name = row.choice("metric", "a metric", names);
  return *std::find_if(metrics.begin(), metrics.end(),
                       [&](const MetricEntry& entry) { return entry.name == name; });
}

bool is_of_impacts(const MetricEntry& metric) {
  return metric.measured_on == MeasuredOn::impact || metric.measured_on == MeasuredOn::plateau;
}

std::vector<std::string> impact_names(const ImpactsDefinition& impacts) {
  std::vector<std::string> names;
  for (std::size_t n = 1; n <= impacts.times.size(); ++n)
    names.push_back(fmt::format("impact_{}", n));
  return names;
}

std::vector<std::string> modes_of(const MetricEntry& metric, const std::string& quantity,
                                  const CaseDefinition& definition) {
  if (metric.measured_on == MeasuredOn::whole_window ||
      metric.measured_on == MeasuredOn::own_series || metric.measured_on == MeasuredOn::plateau)
    return {"whole"};
  if (metric.measured_on == MeasuredOn::impact) return impact_names(definition.impacts.value());
  if (metric.measured_on == MeasuredOn::run_away)
    return has_modes(quantity) ? std::vector<std::string>{} : std::vector<std::string>{"whole"};
  if (!has_modes(quantity)) return {};
  std::vector<std::string> modes;
  const bool is_forced = forcing_frequency(definition) > 0;
  if (metric.measured_on == MeasuredOn::wave)
    return is_forced || definition.natural_modes > 0 ? std::vector<std::string>{"whole"} : modes;
  if (is_forced && metric.measured_on == MeasuredOn::any_mode) modes.push_back("forced");
  for (int n = 1; n <= definition.natural_modes; ++n) modes.push_back(fmt::format("natural_{}", n));
  return modes;
}

const RecordRun* as_record(const CaseDefinition& definition, const std::string& run) {
  for (const RunDefinition& one : definition.runs)
    if (one.name == run) return std::get_if<RecordRun>(&one.solver);
  return nullptr;
}

// A published record is a reference and never a candidate.
std::vector<std::string> candidates(const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs)
    if (!std::holds_alternative<RecordRun>(run.solver)) names.push_back(run.name);
  return names;
}

std::vector<std::string> runs_besides(const std::vector<std::string>& excluded,
                                      const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs) {
    if (std::find(excluded.begin(), excluded.end(), run.name) == excluded.end()) {
      names.push_back(run.name);
    }
  }
  return names;
}

// Exactly one of limit, lower with upper, improves_on.
void read_bound(const TomlTable& row, const CaseDefinition& definition, GateRow& gate_row) {
  std::vector<std::string> given;
  for (const char* key : {"limit", "lower", "upper", "improves_on"}) {
    if (row.has(key)) given.push_back(key);
  }
  const std::string unit = gate_row.unit;
  if (given == std::vector<std::string>{"limit"}) {
    gate_row.limit = row.get("limit", positive(unit));
  } else if (given == std::vector<std::string>{"lower", "upper"}) {
    const double lower = row.get("lower", any_number(unit));
    const Rule<double> above_lower{fmt::format("a number above lower ({}), {}", lower, in(unit)),
                                   [lower](double value) { return value > lower; }};
    gate_row.between = {lower, row.get("upper", above_lower)};
  } else if (given == std::vector<std::string>{"improves_on"}) {
    gate_row.improves_on =
        row.choice("improves_on", "a run other than the candidate and the reference",
                   runs_besides({gate_row.candidate, gate_row.reference}, definition));
  } else {
    row.refuse_table(fmt::format("{{{}}}", fmt::join(given, ", ")),
                     "exactly one of limit | lower with upper | improves_on");
  }
}

// The error whose cost is bounded, and only from above: what is cheaper is better.
void read_error(const TomlTable& row, const MetricEntry& metric, GateRow& gate_row) {
  if (metric.metric != Metric::cost_to_reach) {
    if (row.has("error")) row.refuse("error", "no error: only cost_to_reach is of one");
    return;
  }
  gate_row.error =
      row.get("error", Rule<double>{"a normalised rms above 0 and below 1, without unit",
                                    [](double value) { return value > 0 && value < 1; }});
  if (!gate_row.limit) row.refuse_table("a row on cost_to_reach", "limit: cheaper is better");
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
  gate_row.quantity =
      record ? row.choice("quantity", "the record's quantity", {record->quantity})
             : row.choice("quantity", "a compared quantity", compared_quantities(definition));
  const std::string unit = *metric.unit ? metric.unit : unit_of(gate_row.quantity);
  gate_row.unit = row.choice("unit", fmt::format("the unit of {}", metric.name), {unit});
}

// What else than the compared quantities a solver records, and in what unit, is known when it has
// run: the gate finds a wrong name or unit then, and compares nothing.
void read_own_series(const TomlTable& row, const MetricEntry& metric,
                     const CaseDefinition& definition, GateRow& gate_row) {
  refuse_reference(row, metric, "the candidate alone");
  gate_row.quantity = row.get("quantity", any_text());
  const auto compared = compared_quantities(definition);
  const bool known =
      std::find(compared.begin(), compared.end(), gate_row.quantity) != compared.end();
  if (*metric.unit) {
    gate_row.unit = row.choice("unit", fmt::format("the unit of {}", metric.name), {metric.unit});
  } else {
    gate_row.unit = known ? row.choice("unit", fmt::format("the unit of {}", gate_row.quantity),
                                       {unit_of(gate_row.quantity)})
                          : row.get("unit", any_text());
  }
}

// The pressure at the gauge of the case's impacts, as it is or filtered.
void read_impact_series(const TomlTable& row, const MetricEntry& metric,
                        const CaseDefinition& definition, GateRow& gate_row) {
  refuse_reference(row, metric, "the published impacts");
  if (!definition.impacts)
    row.refuse("metric", "a metric that needs no [impacts], which this case does not have");
  std::vector<std::string> quantities;
  for (const std::string& quantity : compared_quantities(definition)) {
    const std::string pressure = "wall_pressure@" + definition.impacts->gauge;
    if (quantity == pressure || quantity == pressure + "/filtered") quantities.push_back(quantity);
  }
  gate_row.quantity = row.choice("quantity", "the pressure at the gauge of [impacts]", quantities);
  gate_row.unit = row.choice("unit", fmt::format("the unit of {}", metric.name), {metric.unit});
}

}  // namespace

GateRow read_gate_row(const TomlTable& row, const CaseDefinition& definition) {
  row.allow_only({"candidate", "reference", "quantity", "mode", "metric", "unit", "limit", "lower",
                  "upper", "improves_on", "error", "kind", "reason", "source"});
  GateRow gate_row{};
  gate_row.candidate = row.choice("candidate", "a run", candidates(definition));
  const MetricEntry& metric = read_metric(row);
  gate_row.metric = metric.metric;
  if (metric.measured_on == MeasuredOn::own_series) {
    read_own_series(row, metric, definition, gate_row);
  } else if (is_of_impacts(metric)) {
    read_impact_series(row, metric, definition, gate_row);
  } else {
    read_compared_series(row, metric, definition, gate_row);
  }
  gate_row.mode = row.choice("mode", fmt::format("what {} is measured on", metric.name),
                             modes_of(metric, gate_row.quantity, definition));
  read_bound(row, definition, gate_row);
  read_error(row, metric, gate_row);
  if (metric.metric == Metric::impact_percentile && !gate_row.between)
    row.refuse_table("a row on impact_percentile",
                     "lower with upper: neither end of the repeats is the better one");
  gate_row.kind = read_row_kind(row);
  const RecordRun* record = as_record(definition, gate_row.reference);
  if (record && record->earlier_run && gate_row.kind != RowKind::regression)
    row.refuse("kind", "regression: the reference is an earlier run of this harness");
  gate_row.reason = row.get("reason", any_text());
  gate_row.source = row.get("source", any_text());
  gate_row.where = row.where();
  return gate_row;
}

}  // namespace slosh
