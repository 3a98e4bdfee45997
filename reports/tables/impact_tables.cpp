#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
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
using Row = std::vector<std::string>;
using Repeats = std::vector<const RunDefinition*>;

std::string pressure_word(const std::string& quantity) {
  return is_filtered(quantity) ? "filtered" : "unfiltered";
}

std::string rise_text(const RiseTimesDefinition& published, std::size_t n) {
  return fmt::format("{:.4f}", published.values[n]) +
         (published.half_width ? fmt::format(" ± {:.4f}", *published.half_width) : "");
}

Row published_row(const ImpactsDefinition& impacts) {
  const bool has_spread = !impacts.peak_deviations.empty();
  Row row{"published", has_spread ? "mean ± sd of the repeats" : "as published"};
  for (std::size_t n = 0; n < impacts.times.size(); ++n) {
    row.push_back(fmt::format("{:.3f}", impacts.times[n]));
    row.push_back(has_spread ? fmt::format("{:.0f} ± {:.0f}", impacts.peak_means[n],
                                           impacts.peak_deviations[n])
                             : fmt::format("{:.0f}", impacts.peak_means[n]));
    row.push_back(impacts.rise_times ? rise_text(*impacts.rise_times, n)
                                     : std::string("not published"));
    if (impacts.arrivals) row.push_back(fmt::format("{:.4f}", impacts.arrivals->times[n]));
    if (impacts.impulses) row.push_back(fmt::format("{:.0f}", impacts.impulses->values[n]));
  }
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

// Returns " (-0.012)", the difference to expected_time(); empty where that needs a record that is
// not supplied.
std::string time_difference(double time, std::size_t n, const TimeSeries& pressure,
                            const TimeSeries* record, const CaseDefinition& definition) try {
  return fmt::format(" ({:+.3f})",
                     round_to_place(time - expected_time(n, pressure, record, definition), -3));
} catch (const NotSuppliedError&) {
  return "";
}

// "0.0042 (+0.0012)": the rise time and, where one is published, the difference to it.
std::string rise_cell(const TimeSeries& pressure, const ImpactPeak& peak, std::size_t n,
                      const ImpactsDefinition& impacts) {
  const std::optional<double> rise = rise_time(pressure, peak);
  if (!rise) return "no rise from half the peak";
  return fmt::format("{:.4f}", *rise) +
         (impacts.rise_times
              ? fmt::format(" ({:+.4f})", round_to_place(*rise - impacts.rise_times->values[n], -4))
              : "");
}

// Adds the arrival, with the difference to the published one, and the impulse, with its error, as
// far as the case publishes them. Throws ComparisonError as arrival_in() and impulse_in() do.
void add_arrival_cells(const TimeSeries& pressure, std::size_t n, const CaseDefinition& definition,
                       Row& row) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  if (impacts.arrivals) {
    const std::optional<double> arrival = arrival_in(pressure, n, definition);
    row.push_back(arrival ? fmt::format("{:.4f} ({:+.4f})", *arrival,
                                        round_to_place(*arrival - impacts.arrivals->times[n], -4))
                          : "no arrival");
  }
  if (impacts.impulses) {
    const std::optional<double> found = impulse_in(pressure, n, definition);
    row.push_back(
        found ? fmt::format("{:.0f} ({:+.0f} %)", *found,
                            round_to_place(100 * (*found / impacts.impulses->values[n] - 1), 0))
              : "no arrival");
  }
}

std::size_t cells_of_an_impact(const ImpactsDefinition& impacts) {
  return 3 + (impacts.arrivals ? 1 : 0) + (impacts.impulses ? 1 : 0);
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
        row.push_back("no impact");
        row.resize(2 + cells_of_an_impact(impacts) * (n + 1));
        continue;
      }
      row.push_back(fmt::format("{:.3f}", peaks[n]->time) +
                    time_difference(peaks[n]->time, n, pressure, record, definition));
      row.push_back(fmt::format("{:.0f} ({})", peaks[n]->pressure,
                                place_among_repeats(definition, n, peaks[n]->pressure)));
      row.push_back(rise_cell(pressure, *peaks[n], n, impacts));
      add_arrival_cells(pressure, n, definition, row);
    }
  } catch (const ComparisonError& error) {
    row.push_back(error.what());
    row.resize(2 + cells_of_an_impact(impacts) * impacts.times.size());
  }
  if (impacts.plateau > 0) row.push_back(plateau_cell(pressure, definition));
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
Row moments(const Distribution& peaks) {
  const std::size_t count = peaks.sorted().size();
  const Estimate mean = mean_of_members(peaks.sorted());
  Row row{interval_text(mean), count < 2 ? std::string("single run")
                                         : fmt::format("{:.0f}", peaks.standard_deviation())};
  try {
    const Interval interval = peaks.central_90_percent();
    row.push_back(fmt::format("{:.0f} to {:.0f}", interval.low, interval.high));
  } catch (const ComparisonError&) {
    row.push_back("fewer than 20 peaks");
  }
  return row;
}

const Row repeat_columns{"repeats",
                         "pressure",
                         "impact",
                         "occurred in",
                         "mean [Pa]",
                         "sd [Pa]",
                         "central 90 % [Pa]",
                         "median over the experiment's",
                         "p (means)",
                         "p (KS)",
                         "p (AD)",
                         "left out (reason)"};

Row experiment_row(const CaseDefinition& definition, std::size_t impact) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  Row row{"experiment", "as published", fmt::format("{}", impact + 1)};
  if (impacts.repeats.empty()) {
    row.insert(row.end(), {"", fmt::format("{:.0f}", impacts.peak_means[impact]),
                           impacts.peak_deviations.empty()
                               ? std::string("not published")
                               : fmt::format("{:.0f}", impacts.peak_deviations[impact]),
                           "not supplied"});
  } else {
    const Distribution peaks = repeated_peaks(definition, impact);
    row.push_back(fmt::format("{0} of {0}", peaks.sorted().size()));
    const Row rest = moments(peaks);
    row.insert(row.end(), rest.begin(), rest.end());
  }
  row.resize(repeat_columns.size());
  return row;
}

// What the peaks are against those of the experiment's repeats.
Row against_repeats(const CaseDefinition& definition, const PeakSample& sample,
                    std::size_t impact) {
  if (definition.impacts->repeats.empty()) return {"not supplied"};
  const auto found = against_experiment(definition, sample, impact);
  if (!found) return {"fewer than 20 peaks"};
  return {median_ratio_text(*found), fmt::format("{:.2g}", found->mean_p.value),
          fmt::format("{:.2g}", found->ks_p.value), fmt::format("{:.2g}", found->ad_p.value)};
}

Row run_row(const CaseAssessment& assessment, const Repeats& repeats, const std::string& pressure,
            std::size_t impact) {
  const CaseDefinition& definition = assessment.definition;
  const PeakSample sample = peak_sample(assessment, repeats, pressure, impact);
  Row row{fmt::format("{} to {}", repeats.front()->name, repeats.back()->name),
          pressure_word(pressure), fmt::format("{}", impact + 1),
          fmt::format("{} of {}", sample.peaks.size(), sample.usable)};
  if (!sample.peaks.empty()) {
    const Distribution peaks("peaks of " + repeats.front()->name, sample.peaks);
    for (const Row& part : {moments(peaks), against_repeats(definition, sample, impact)})
      row.insert(row.end(), part.begin(), part.end());
  }
  row.resize(repeat_columns.size());
  row.back() = fmt::format("{}", fmt::join(sample.left_out, "; "));
  return row;
}

}  // namespace

std::optional<Table> impact_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (!definition.impacts) return std::nullopt;
  Table table{case_id(definition.name) + "-impacts",
              "Impacts",
              caption(definition),
              {"run", "pressure"},
              {published_row(*definition.impacts)}};
  for (std::size_t n = 1; n <= definition.impacts->times.size(); ++n) {
    table.header.insert(table.header.end(),
                        {fmt::format("impact {} [s]", n), fmt::format("peak {} [Pa]", n),
                         fmt::format("rise {} [s]", n)});
    if (definition.impacts->arrivals) table.header.push_back(fmt::format("arrival {} [s]", n));
    if (definition.impacts->impulses) table.header.push_back(fmt::format("impulse {} [Pa s]", n));
  }
  if (definition.impacts->plateau > 0) table.header.push_back("plateau [Pa]");
  const auto add_runs = [&](bool records) {
    for (const RunDefinition& run : definition.runs) {
      if (is_record(run) != records) continue;
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

std::optional<Table> repeat_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const auto groups = repeated_runs(definition);
  if (!definition.impacts || groups.empty()) return std::nullopt;
  Table table{
      case_id(definition.name) + "-repeats",
      "Distribution of peaks over repeated runs",
      "Impact peaks of runs that differ only in their random seed, by which their starts are "
      "disturbed or their inputs are drawn, and those of the experiment's repeats. The mean has "
      "the 95 % interval of the repeats' scatter. In brackets: the 95 % interval by the bootstrap. "
      "p (means) is that of equal means by Welch's test. The "
      "other two p are the share of random divisions of all peaks into two such samples that "
      "differ as much or more, by Kolmogorov and Smirnov (KS) and by Anderson and Darling (AD); "
      "below 0.05 the samples are told apart. All p are of each test alone; the gate rows correct "
      "them together, by Holm.",
      repeat_columns,
      {}};
  for (std::size_t impact = 0; impact < definition.impacts->times.size(); ++impact) {
    table.rows.push_back(experiment_row(definition, impact));
    for (const Repeats& group : groups)
      for (const std::string& pressure : impact_pressures(definition))
        table.rows.push_back(run_row(assessment, group, pressure, impact));
  }
  return table;
}

}  // namespace slosh
