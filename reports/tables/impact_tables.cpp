#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <optional>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/metrics/ensemble_mean.hpp"
#include "verification/series/interval_text.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

using reports::Table;
using Repeats = std::vector<const RunDefinition*>;

std::string pressure_word(const std::string& quantity) {
  return is_filtered(quantity) ? "filtered" : "unfiltered";
}

// The pressure of a run, and the record's where it is supplied.
struct PressureOfRun {
  const TimeSeries& pressure;
  const TimeSeries* record;
};

// A column that each impact has: its heading before the impact's number, the published cell of the
// n-th impact, and the cell of a run's peak.
struct ImpactColumn {
  std::string heading, unit;
  std::function<std::string(std::size_t n)> published;
  std::function<std::string(const PressureOfRun&, const ImpactPeak&, std::size_t n)> found;
};

// With the difference to expected_time(), unless that needs a record that is not supplied.
std::string time_cell(const PressureOfRun& of, const ImpactPeak& peak, std::size_t n,
                      const CaseDefinition& definition) {
  const std::string time = fmt::format("{:.3f}", peak.time);
  try {
    const double expected = expected_time(n, of.pressure, of.record, definition);
    return time + fmt::format(" ({:+.3f})", round_to_place(peak.time - expected, -3));
  } catch (const NotSuppliedError&) {
    return time;
  }
}

// With the difference to the published one, where one is published.
std::string rise_cell(const TimeSeries& pressure, const ImpactPeak& peak, std::size_t n,
                      const std::optional<RiseTimesDefinition>& published) {
  const std::optional<double> rise = rise_time(pressure, peak);
  if (!rise) return "no rise from half the peak";
  const std::string text = fmt::format("{:.4f}", *rise);
  return published
             ? text + fmt::format(" ({:+.4f})", round_to_place(*rise - published->values[n], -4))
             : text;
}

// The functions of the columns throw ComparisonError as arrival_in() and impulse_in() do.
std::vector<ImpactColumn> impact_columns(const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  std::vector<ImpactColumn> columns{
      {"impact", "s", [&](std::size_t n) { return fmt::format("{:.3f}", impacts.times[n]); },
       [&](const PressureOfRun& of, const ImpactPeak& peak, std::size_t n) {
         return time_cell(of, peak, n, definition);
       }},
      {"peak", "Pa",
       [&](std::size_t n) {
         const std::string mean = fmt::format("{:.0f}", impacts.peak_means[n]);
         return impacts.peak_deviations.empty()
                    ? mean
                    : fmt::format("{} ± {:.0f}", mean, impacts.peak_deviations[n]);
       },
       [&](const PressureOfRun&, const ImpactPeak& peak, std::size_t n) {
         return fmt::format("{:.0f} ({})", peak.pressure,
                            place_among_repeats(definition, n, peak.pressure));
       }},
      {"rise", "s",
       [&](std::size_t n) {
         if (!impacts.rise_times) return std::string("not published");
         const auto& [values, half_width] = *impacts.rise_times;
         return fmt::format("{:.4f}", values[n]) +
                (half_width ? fmt::format(" ± {:.4f}", *half_width) : "");
       },
       [&](const PressureOfRun& of, const ImpactPeak& peak, std::size_t n) {
         return rise_cell(of.pressure, peak, n, impacts.rise_times);
       }}};
  if (impacts.arrivals)
    columns.push_back(
        {"arrival", "s",
         [&](std::size_t n) { return fmt::format("{:.4f}", impacts.arrivals->times[n]); },
         [&](const PressureOfRun& of, const ImpactPeak&, std::size_t n) -> std::string {
           const auto arrival = arrival_in(of.pressure, n, definition);
           if (!arrival) return "no arrival";
           return fmt::format("{:.4f} ({:+.4f})", *arrival,
                              round_to_place(*arrival - impacts.arrivals->times[n], -4));
         }});
  if (impacts.impulses)
    columns.push_back(
        {"impulse", "Pa s",
         [&](std::size_t n) { return fmt::format("{:.0f}", impacts.impulses->values[n]); },
         [&](const PressureOfRun& of, const ImpactPeak&, std::size_t n) -> std::string {
           const auto impulse = impulse_in(of.pressure, n, definition);
           if (!impulse) return "no arrival";
           const double error = *impulse / impacts.impulses->values[n] - 1;
           return fmt::format("{:.0f} ({:+.0f} %)", *impulse, round_to_place(100 * error, 0));
         }});
  return columns;
}

TableRow published_row(const ImpactsDefinition& impacts, const std::vector<ImpactColumn>& columns) {
  TableRow row{"published",
               impacts.peak_deviations.empty() ? "as published" : "mean ± sd of the repeats"};
  for (std::size_t n = 0; n < impacts.times.size(); ++n)
    for (const ImpactColumn& column : columns) row.push_back(column.published(n));
  if (impacts.plateau > 0) row.push_back(fmt::format("{:.0f}", impacts.plateau));
  return row;
}

// Returns "not available" where the series does not reach the plateau's end or is not finite there.
std::string plateau_cell(const TimeSeries& pressure, const CaseDefinition& definition) try {
  const double error = plateau_error(pressure, definition);
  return fmt::format("{:.0f} ({:+.0f} %)", (1 + error) * definition.impacts->plateau,
                     round_to_place(100 * error, 0));
} catch (const ComparisonError&) {
  return "not available";
}

TableRow run_row(const CaseAssessment& assessment, const std::string& run,
                 const TimeSeries& pressure, const std::vector<ImpactColumn>& columns) {
  const CaseDefinition& definition = assessment.definition;
  const PressureOfRun of{pressure, series_of_record(assessment, pressure.name)};
  TableRow row{run, pressure_word(pressure.name)};
  try {
    const auto peaks = impacts_in(pressure, definition);
    for (std::size_t n = 0; n < peaks.size(); ++n) {
      if (!peaks[n])
        row.push_back("no impact");
      else
        for (const ImpactColumn& column : columns) row.push_back(column.found(of, *peaks[n], n));
      row.resize(2 + columns.size() * (n + 1));
    }
  } catch (const ComparisonError& error) {
    row.push_back(error.what());
    row.resize(2 + columns.size() * definition.impacts->times.size());
  }
  if (definition.impacts->plateau > 0) row.push_back(plateau_cell(pressure, definition));
  return row;
}

std::string caption(const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  const bool is_single = impacts.plateau == 0;
  std::string text = fmt::format(
      "The highest pressure within {} of each published time. In "
      "brackets after its time: the difference to the published time (for the filtered pressure, "
      "to the time in the record with the same filter, if the record is supplied). In brackets "
      "after the peak: ",
      is_single ? fmt::format("{:g} s", impacts.period / 4)
                : fmt::format("a quarter of the period ({} s)", impacts.period));
  text +=
      impacts.repeats.empty()
          ? (impacts.peak_deviations.empty()
                 ? "its difference to the published peak. "
                 : "its distance from the mean of the experiment's repeats, in their standard "
                   "deviations (sd); the table of the repeats is not supplied, so there are no "
                   "percentiles. ")
          : fmt::format("the percentage of the experiment's {} repeats that have a lower peak. ",
                        impacts.repeats.front().size());
  text += "Rise: twice the time from half the peak to the peak. ";
  if (impacts.arrivals)
    text += fmt::format(
        "Arrival: when the pressure comes to {:.3g} of the published peak and holds it, and in "
        "brackets the difference to the published arrival. ",
        impacts.arrivals->share);
  if (impacts.impulses)
    text += fmt::format("Impulse: the integral of the pressure over {:g} s from the arrival on. ",
                        impacts.impulses->duration);
  if (impacts.plateau > 0)
    text += fmt::format("Plateau: the mean from {} to {} s. ", impacts.plateau_begin,
                        impacts.plateau_end);
  text += fmt::format("Published: {}.", impacts.source);
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (gauge.name == impacts.gauge && gauge.filter_cutoff)
      text += fmt::format(" Filter: {}; the published peaks are not filtered.",
                          low_pass_name(*gauge.filter_cutoff));
  return text;
}

// Returns the mean with its 95 % interval, the standard deviation and the central 90 % interval.
TableRow moments(const Distribution& peaks) {
  const std::size_t count = peaks.sorted().size();
  TableRow row{
      interval_text(mean_of_members(peaks.sorted())),
      count < 2 ? std::string("single run") : fmt::format("{:.0f}", peaks.standard_deviation())};
  try {
    const Interval interval = peaks.central_90_percent();
    row.push_back(fmt::format("{:.0f} to {:.0f}", interval.low, interval.high));
  } catch (const ComparisonError&) {
    row.push_back("fewer than 20 peaks");
  }
  return row;
}

TableRow experiment_row(const CaseDefinition& definition, std::size_t impact) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  TableRow row{"experiment", "as published", fmt::format("{}", impact + 1)};
  if (impacts.repeats.empty()) {
    append(row, {"", fmt::format("{:.0f}", impacts.peak_means[impact]),
                 impacts.peak_deviations.empty()
                     ? std::string("not published")
                     : fmt::format("{:.0f}", impacts.peak_deviations[impact]),
                 "not supplied"});
  } else {
    const Distribution peaks = repeated_peaks(definition, impact);
    row.push_back(fmt::format("{0} of {0}", peaks.sorted().size()));
    append(row, moments(peaks));
  }
  return row;
}

// What the peaks are against those of the experiment's repeats.
TableRow against_repeats(const CaseDefinition& definition, const PeakSample& sample,
                         std::size_t impact) {
  if (definition.impacts->repeats.empty()) return {"not supplied"};
  const auto found = against_experiment(definition, sample, impact);
  if (!found) return {"fewer than 20 peaks"};
  return {median_ratio_text(*found), fmt::format("{:.2g}", found->mean_p.value),
          fmt::format("{:.2g}", found->ks_p.value), fmt::format("{:.2g}", found->ad_p.value)};
}

// Of `columns` cells, the last of which says what is left out.
TableRow repeats_row(const CaseAssessment& assessment, const Repeats& repeats,
                     const std::string& pressure, std::size_t impact, std::size_t columns) {
  const PeakSample sample = peak_sample(assessment, repeats, pressure, impact);
  TableRow row{fmt::format("{} to {}", repeats.front()->name, repeats.back()->name),
               pressure_word(pressure), fmt::format("{}", impact + 1),
               fmt::format("{} of {}", sample.peaks.size(), sample.usable)};
  if (!sample.peaks.empty()) {
    append(row, moments({"peaks of " + repeats.front()->name, sample.peaks}));
    append(row, against_repeats(assessment.definition, sample, impact));
  }
  row.resize(columns);
  row.back() = fmt::format("{}", fmt::join(sample.left_out, "; "));
  return row;
}

}  // namespace

Table impact_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (!definition.impacts) return {};
  const ImpactsDefinition& impacts = *definition.impacts;
  const std::vector<ImpactColumn> columns = impact_columns(definition);
  Table table =
      case_table(definition, "impacts", "Impacts", caption(definition), {"run", "pressure"});
  for (std::size_t n = 1; n <= impacts.times.size(); ++n)
    for (const auto& [heading, unit, published, found] : columns)
      table.header.push_back(fmt::format("{} {} [{}]", heading, n, unit));
  if (impacts.plateau > 0) table.header.push_back("plateau [Pa]");
  table.rows = {published_row(impacts, columns)};
  for (const bool records : {true, false})
    for (const RunDefinition& run : definition.runs) {
      if (is_record(run) != records) continue;
      const RunResult* result = find_result(assessment.runs, run.name);
      if (!result) {
        table.rows.push_back({run.name, state_name(assessment.runs.status.at(run.name).state)});
        table.rows.back().resize(table.header.size());
        continue;
      }
      for (const std::string& pressure : impact_pressures(definition))
        if (has_series(assessment.runs, run.name, pressure))
          table.rows.push_back(run_row(assessment, run.name, result->at(pressure), columns));
    }
  return table;
}

Table repeat_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const auto groups = repeated_runs(definition);
  if (!definition.impacts || groups.empty()) return {};
  Table table = case_table(
      definition, "repeats", "Distribution of peaks over repeated runs",
      "Impact peaks of runs that differ only in their random seed, by which their starts are "
      "disturbed or their inputs are drawn, and those of the experiment's repeats. The mean has "
      "the 95 % interval of the repeats' scatter. In brackets: the 95 % interval by the bootstrap. "
      "p (means) is that of equal means by Welch's test. The "
      "other two p are the share of random divisions of all peaks into two such samples that "
      "differ as much or more, by Kolmogorov and Smirnov (KS) and by Anderson and Darling (AD); "
      "below 0.05 the samples are told apart. All p are of each test alone; the gate rows correct "
      "them together, by Holm.",
      {"repeats", "pressure", "impact", "occurred in", "mean [Pa]", "sd [Pa]", "central 90 % [Pa]",
       "median over the experiment's", "p (means)", "p (KS)", "p (AD)", "left out (reason)"});
  const std::size_t columns = table.header.size();
  for (std::size_t impact = 0; impact < definition.impacts->times.size(); ++impact) {
    table.rows.push_back(experiment_row(definition, impact));
    table.rows.back().resize(columns);
    for (const Repeats& group : groups)
      for (const std::string& pressure : impact_pressures(definition))
        table.rows.push_back(repeats_row(assessment, group, pressure, impact, columns));
  }
  return table;
}

}  // namespace slosh
