#include "reports/tables/impact_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

using Row = std::vector<std::string>;

Row published_row(const ImpactsDefinition& impacts) {
  Row row{"published", "mean ± sd of the repeats"};
  for (std::size_t n = 0; n < impacts.times.size(); ++n) {
    row.push_back(fmt::format("{:.3f}", impacts.times[n]));
    row.push_back(
        fmt::format("{:.0f} ± {:.0f}", impacts.peak_means[n], impacts.peak_deviations[n]));
  }
  row.push_back(fmt::format("{:.0f}", impacts.plateau));
  return row;
}

// The table says where the series does not reach the plateau, or where the plateau is NaN.
std::string plateau_cell(const TimeSeries& pressure, const CaseDefinition& definition) try {
  const double error = plateau_error(pressure, definition);
  return fmt::format("{:.0f} ({:+.0f} %)", (1 + error) * definition.impacts->plateau, 100 * error);
} catch (const ComparisonError&) {
  return "no number";
}

// " (-0.012)" against the time that the gate expects, nothing where it knows none.
std::string difference(double time, std::size_t n, const TimeSeries& pressure,
                       const TimeSeries* record, const CaseDefinition& definition) try {
  return fmt::format(" ({:+.3f})", time - expected_time(n, pressure, record, definition));
} catch (const NotSuppliedError&) {
  return "";
}

Row run_row(const CaseAssessment& assessment, const std::string& run, const TimeSeries& pressure) {
  const CaseDefinition& definition = assessment.definition;
  const ImpactsDefinition& impacts = definition.impacts.value();
  const TimeSeries* record = series_of_record(assessment, pressure.name);
  Row row{run, pressure_word(pressure.name)};
  try {
    const auto peaks = impacts_in(pressure, definition);
    for (std::size_t n = 0; n < peaks.size(); ++n) {
      if (!peaks[n]) {
        row.insert(row.end(), {"no impact", ""});
        continue;
      }
      row.push_back(fmt::format("{:.3f}", peaks[n]->time) +
                    difference(peaks[n]->time, n, pressure, record, definition));
      row.push_back(fmt::format("{:.0f} ({})", peaks[n]->pressure,
                                place_among_repeats(definition, n, peaks[n]->pressure)));
    }
  } catch (const ComparisonError& error) {
    row.push_back(error.what());
    row.resize(2 + 2 * impacts.times.size());
  }
  row.push_back(plateau_cell(pressure, definition));
  return row;
}

std::string caption(const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  std::string text = fmt::format(
      "The highest pressure within a quarter of the period ({} s) of each published time, in "
      "brackets its time less the published one (of the filtered pressure: less the record's, "
      "filtered alike, where that is supplied), and ",
      impacts.period);
  text += impacts.repeats.empty()
              ? "how many of the repeats' standard deviations it lies from their mean: the table "
                "of the repeats is not supplied, so that there are no percentiles. "
              : fmt::format("the percentage of the experiment's {} repeats that lie below it. ",
                            impacts.repeats.front().size());
  text += fmt::format("Plateau: the mean from {} to {} s. Published: {}.", impacts.plateau_begin,
                      impacts.plateau_end, impacts.source);
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (gauge.name == impacts.gauge && gauge.filter_cutoff)
      text += fmt::format(" Filter: {}; the published peaks are not filtered.",
                          low_pass_name(*gauge.filter_cutoff));
  return text;
}

}  // namespace

std::vector<std::string> impact_pressures(const CaseDefinition& definition) {
  std::vector<std::string> pressures{"wall_pressure@" + definition.impacts.value().gauge};
  const auto compared = compared_quantities(definition);
  const std::string filtered = pressures.front() + "/filtered";
  if (std::find(compared.begin(), compared.end(), filtered) != compared.end())
    pressures.push_back(filtered);
  return pressures;
}

std::string pressure_word(const std::string& quantity) {
  return quantity.ends_with("/filtered") ? "filtered" : "as it is";
}

std::string place_among_repeats(const CaseDefinition& definition, std::size_t impact, double peak) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  if (!impacts.repeats.empty())
    return fmt::format("{:.0f} %", repeated_peaks(definition, impact).percentile(peak));
  return fmt::format("{:+.1f} sd",
                     (peak - impacts.peak_means[impact]) / impacts.peak_deviations[impact]);
}

std::optional<reports::Table> impact_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (!definition.impacts) return std::nullopt;
  reports::Table table{definition.name + "-impacts",
                       "Impacts",
                       caption(definition),
                       {"run", "pressure"},
                       {published_row(*definition.impacts)}};
  for (std::size_t n = 1; n <= definition.impacts->times.size(); ++n)
    table.header.insert(table.header.end(),
                        {fmt::format("impact {} [s]", n), fmt::format("peak {} [Pa]", n)});
  table.header.push_back("plateau [Pa]");
  const auto add_runs = [&](bool records) {
    for (const RunDefinition& run : definition.runs) {
      if (std::holds_alternative<RecordRun>(run.solver) != records) continue;
      if (!assessment.runs.results.contains(run.name)) {
        Row row{run.name, state_name(assessment.runs.status.at(run.name).state)};
        row.resize(table.header.size());
        table.rows.push_back(std::move(row));
        continue;
      }
      for (const std::string& pressure : impact_pressures(definition))
        if (has_series(assessment.runs, run.name, pressure))
          table.rows.push_back(
              run_row(assessment, run.name, assessment.runs.results.at(run.name).at(pressure)));
    }
  };
  add_runs(true);
  add_runs(false);
  return table;
}

}  // namespace slosh
