#include "verification/cli/texts/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "reports/model/report_files.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/series/spectrum.hpp"

namespace slosh {
namespace {

// Returns ", period 1.3 s (spectral peak)", or an empty text if the series is too short or has no
// peak.
std::string period_text(const TimeSeries& series) try {
  const Spectrum spectrum = power_spectrum(series, {series.time.front(), series.time.back()});
  const std::vector<SpectralPeak> peaks = spectral_peaks(spectrum, 1);
  if (peaks.empty() || !(peaks.front().frequency > 0)) return "";
  return fmt::format(", period {:.3g} s (spectral peak)", 1 / peaks.front().frequency);
} catch (const ComparisonError&) {
  return "";
}

std::string extreme_text(const TimeSeries& series, std::vector<double>::const_iterator at) {
  return fmt::format("{:.3g} {} at {:.4g} s", *at, series.unit,
                     series.time[static_cast<std::size_t>(at - series.value.begin())]);
}

std::string gauge_text(const TimeSeries& series) {
  const auto [lowest, highest] = std::minmax_element(series.value.begin(), series.value.end());
  return fmt::format("{}: highest {}, lowest {}{}\n", series.name, extreme_text(series, highest),
                     extreme_text(series, lowest), period_text(series));
}

std::string cost_text(const RunResult& result) {
  constexpr double mebibyte = 1024 * 1024;
  const RunCost& cost = result.cost;
  std::string text = fmt::format("cost: {:.3g} core-seconds in {:.3g} s of wall time, {:.0f} MiB",
                                 cost.core_seconds(), cost.wall_time, cost.peak_memory / mebibyte);
  const SolverKind* kind = find_solver_kind(result.solver);
  if (cost.elements > 0)
    text += fmt::format("; {:.0f} {}", cost.elements, kind ? kind->elements : "nodes");
  return text + "\n";
}

// Returns what a coarse run has measured [m/s].
std::optional<double> measured_speed(const RunResult& result) {
  if (!result.diagnostics.contains("coarse_run_spacing_m")) return {};
  return result.diagnostics.at("expected_speed_m_s");
}

std::string speed_of_sound_text(const RunResult& result) {
  const std::optional<double> measured = measured_speed(result);
  if (!measured) return "";
  const double c0 = result.diagnostics.at("speed_of_sound_m_s");
  return fmt::format(
      "speed of sound: {:.4g} m/s, {:.3g} times the {:.4g} m/s that a coarse run at {:.4g} mm "
      "measured\n",
      c0, c0 / *measured, *measured, 1000 * result.diagnostics.at("coarse_run_spacing_m"));
}

// Returns how far landing on the samples and the flow itself shorten the time steps.
std::string steps_text(const RunResult& result, const CaseDefinition& definition,
                       const SphStep& step) {
  const double mean = definition.duration / result.cost.steps;
  constexpr double told = 0.005;  // relative, as percentages are rounded
  const bool flow_shortens = mean < (1 - told) * step.between_samples;
  return fmt::format(
      "steps: {:.0f} of {}{}\n", result.cost.steps, step_text(step, definition.sample_interval),
      flow_shortens ? fmt::format("; the flow's accelerations to a mean of {:.3g} ms", 1000 * mean)
                    : "");
}

// A text may have several lines.
std::string comment(const std::string& text) {
  std::string lines = "# ";
  for (const char letter : text) lines += letter == '\n' ? "\n# " : std::string(1, letter);
  return lines + "\n";
}

// Returns the times of all series, increasing, each once.
std::vector<double> moments(const RunResult& result) {
  std::vector<double> all;
  for (const TimeSeries& series : result.series) {
    const bool increases = std::adjacent_find(series.time.begin(), series.time.end(),
                                              std::not_fn(std::less())) == series.time.end();
    if (!increases)
      throw ResultError("the series " + series.name + ": expected times that increase");
    all.insert(all.end(), series.time.begin(), series.time.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

std::string step_text(const SphStep& step, double sample_interval) {
  const double percent = 100 * step.lost_to_samples();
  const std::string each = fmt::format("{:.3g} ms", 1000 * step.between_samples),
                    samples =
                        fmt::format("landing on the samples every {:g} ms", 1000 * sample_interval);
  if (percent < 0.5) return fmt::format("{} each: {} costs nothing", each, samples);
  return fmt::format("{} each: {} shortens the stable {:.3g} ms by {:.0f} %", each, samples,
                     1000 * step.stable, percent);
}

std::string run_summary(const RunResult& result, const CaseDefinition& definition,
                        const RunDefinition& run) {
  std::string text;
  for (const std::string& quantity : compared_quantities(definition))
    for (const TimeSeries& series : result.series)
      if (series.name == quantity && is_gauged(quantity) && !series.value.empty())
        text += gauge_text(series);
  text += cost_text(result);
  text += speed_of_sound_text(result);
  const std::optional<SphStep> step = sph_step(definition, run, measured_speed(result));
  if (step && result.cost.steps > 0) text += steps_text(result, definition, *step);
  return text;
}

std::string theory_line(const TheoryRemarks& remarks) {
  return remarks.outside
             ? fmt::format("{} is outside its range: it {}", remarks.run, *remarks.outside)
             : fmt::format("{} is inside its range: {}", remarks.run, remarks.range);
}

std::string theory_csv(const CaseDefinition& definition, const CaseTheories& theories) {
  std::string text = comment(fmt::format("Case {}: {}", definition.name, definition.title)) +
                     comment("Source: " + definition.source);
  for (const TheoryRemarks& remarks : theories.remarks) {
    text += comment(fmt::format("{}: {}", remarks.run, remarks.solution));
    text += comment(fmt::format("{}, range: {}", remarks.run, remarks.range));
    if (remarks.outside) text += comment(theory_line(remarks));
    text += comment(fmt::format("{}, uncertainty: {}", remarks.run, remarks.uncertainty));
  }
  return text + series_csv(theories.result);
}

std::string series_csv(const RunResult& result) {
  std::vector<std::string> cells{"time [s]"};
  for (const TimeSeries& series : result.series)
    cells.push_back(series.name + " [" + series.unit + "]");
  std::string text = reports::csv_line(cells);
  std::vector<std::size_t> next(result.series.size(), 0);
  for (const double time : moments(result)) {
    cells.assign(1, reports::csv_number(time));
    for (std::size_t i = 0; i < result.series.size(); ++i) {
      const TimeSeries& series = result.series[i];
      const bool has_value = next[i] < series.time.size() && series.time[next[i]] == time;
      cells.push_back(has_value ? reports::csv_number(series.value[next[i]++]) : "");
    }
    text += reports::csv_line(cells);
  }
  return text;
}

namespace {

using nlohmann::ordered_json;

std::string numbers_text(const ImpactNumbers& impact) {
  std::string text = impact.peak ? fmt::format("peak {:.4g} Pa at {:.4f} s", impact.peak->pressure,
                                               impact.peak->time)
                                 : std::string("no impact");
  const auto add = [&](const char* what, const std::optional<double>& value, const char* unit) {
    if (value) text += fmt::format(", {} {:.4g} {}", what, *value, unit);
  };
  add("rise time", impact.rise_time, "s");
  if (impact.arrival) text += fmt::format(", arrival {:.4f} s", *impact.arrival);
  add("impulse", impact.impulse, "Pa s");
  return text;
}

std::vector<ImpactNumbers> published_numbers(const ImpactsDefinition& impacts) {
  std::vector<ImpactNumbers> all;
  for (std::size_t n = 0; n < impacts.times.size(); ++n) {
    ImpactNumbers one{.peak = ImpactPeak{impacts.times[n], impacts.peak_means[n]}};
    if (impacts.rise_times) one.rise_time = impacts.rise_times->values[n];
    if (impacts.arrivals) one.arrival = impacts.arrivals->times[n];
    if (impacts.impulses) one.impulse = impacts.impulses->values[n];
    all.push_back(one);
  }
  return all;
}

// Empty where the series cannot be searched; `lines` then says why.
std::vector<ImpactNumbers> found_numbers(const CaseDefinition& definition, const char* role,
                                         const TimeSeries& series, std::string& lines) try {
  return impact_numbers(series, definition);
} catch (const ComparisonError& error) {
  lines += fmt::format("impacts of {}: {}\n", role, error.what());
  return {};
}

// A series that does not cover the plateau has a line that says why.
std::string plateau_line(const CaseDefinition& definition, const char* role,
                         const TimeSeries& series) try {
  const double error = plateau_error(series, definition);
  return fmt::format("plateau of {}: {:.4g} Pa, {:+.3g} %\n", role,
                     (1 + error) * definition.impacts->plateau, 100 * error);
} catch (const ComparisonError& error) {
  return fmt::format("plateau of {}: {}\n", role, error.what());
}

std::string plateau_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                          const TimeSeries& reference) {
  if (!(definition.impacts->plateau > 0)) return "";
  return plateau_line(definition, "the candidate", candidate) +
         plateau_line(definition, "the reference", reference) +
         fmt::format("plateau as published: {:.4g} Pa\n", definition.impacts->plateau);
}

std::string order_text(const ConvergedMetric& metric) {
  const auto& order = metric.refined.found.order;
  if (!order) return "no order";
  return fmt::format("order {:.2f} {}", *order,
                     metric.order_half_width ? fmt::format("± {:.2f}", *metric.order_half_width)
                                             : "(its interval is unknown)");
}

std::string metric_text(const ConvergedMetric& metric) {
  const GateRow& row = metric.row;
  const DiscretisationUncertainty& found = metric.refined.found;
  std::string text =
      fmt::format("\n{} {} of {}\n", row.mode, metric_name(row.metric), row.quantity);
  for (const ValueAtStep& one : metric.refined.values)
    text += fmt::format("  {:>8.4g} mm   {}\n", 1000 * one.step,
                        with_interval({one.value, one.noise}, row.unit));
  return text +
         fmt::format(
             "  {}, {}; extrapolated to zero spacing {}; uncertainty of the finest {}\n  {}\n",
             behaviour_name(found.behaviour), order_text(metric),
             in_unit(found.extrapolated, row.unit), in_unit(found.uncertainty, row.unit),
             found.explanation);
}

std::string run_text(const std::string& run, const CaseRuns& runs) {
  const RunStatus& status = runs.status.at(run);
  std::string text = fmt::format("  {:<28} {}", run, state_name(status.state));
  if (!status.message.empty()) text += ": " + status.message;
  if (const auto result = runs.results.find(run); result != runs.results.end())
    text += fmt::format(", {:.3g} core-seconds", result->second.cost.core_seconds());
  return text + "\n";
}

// Of all runs of the study: the order rests on each.
std::string unsound_runs(const ConvergenceStudy& study) {
  std::set<std::string> named;
  for (const RunDefinition& run : study.assessment.definition.runs) named.insert(run.name);
  return soundness_doubt(study.assessment.definition, study.assessment.runs, named);
}

ordered_json number_or_null(const std::optional<double>& number) {
  return number ? ordered_json(*number) : ordered_json(nullptr);
}

ordered_json json_of(const ConvergedMetric& metric) {
  const DiscretisationUncertainty& found = metric.refined.found;
  ordered_json values = ordered_json::array();
  for (std::size_t i = 0; i < metric.refined.values.size(); ++i)
    values.push_back({{"run", metric.refined.runs[i]},
                      {"particle_spacing_m", metric.refined.values[i].step},
                      {"value", metric.refined.values[i].value},
                      {"half_width_95", metric.refined.values[i].noise}});
  return {{"mode", metric.row.mode},
          {"metric", metric_name(metric.row.metric)},
          {"unit", metric.row.unit},
          {"values", values},
          {"behaviour", behaviour_name(found.behaviour)},
          {"order", number_or_null(found.order)},
          {"order_half_width_95", number_or_null(metric.order_half_width)},
          {"extrapolated", found.extrapolated},
          {"uncertainty_95", found.uncertainty},
          {"explanation", found.explanation}};
}

}  // namespace

bool has_impacts(const CaseDefinition& definition, const std::string& quantity) {
  if (!definition.impacts) return false;
  const std::vector<std::string> pressures = impact_pressures(definition);
  return std::find(pressures.begin(), pressures.end(), quantity) != pressures.end();
}

std::string impact_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                         const TimeSeries& reference) {
  std::string lines;
  const auto of_candidate = found_numbers(definition, "the candidate", candidate, lines);
  const auto of_reference = found_numbers(definition, "the reference", reference, lines);
  const auto published = published_numbers(*definition.impacts);
  const auto add = [&](std::size_t n, const char* whose, const std::vector<ImpactNumbers>& all) {
    if (n < all.size())
      lines += fmt::format("impact_{} {}: {}\n", n + 1, whose, numbers_text(all[n]));
  };
  for (std::size_t n = 0; n < published.size(); ++n) {
    add(n, "of the candidate", of_candidate);
    add(n, "of the reference", of_reference);
    add(n, "as published", published);
  }
  return lines + plateau_lines(definition, candidate, reference);
}

std::string text_of(const ConvergenceStudy& study) {
  const CaseDefinition& definition = study.assessment.definition;
  std::string text = fmt::format("{}: {} against {}\n", definition.name, study.question.quantity,
                                 study.question.reference);
  for (const RunDefinition& run : definition.runs)
    text += run_text(run.name, study.assessment.runs);
  if (const std::string doubts = unsound_runs(study); !doubts.empty())
    text += "doubtful: " + doubts + "\n";
  for (const ConvergedMetric& metric : study.found.metrics) text += metric_text(metric);
  for (const std::string& one : study.found.not_measured) text += "\nnot measured: " + one + "\n";
  return text;
}

std::string json_of(const ConvergenceStudy& study) {
  ordered_json document{{"case", study.assessment.definition.name},
                        {"case_file", study.assessment.definition.file.string()},
                        {"quantity", study.question.quantity},
                        {"reference", study.question.reference},
                        {"doubtful", unsound_runs(study)},
                        {"metrics", ordered_json::array()},
                        {"not_measured", study.found.not_measured}};
  for (const ConvergedMetric& metric : study.found.metrics)
    document["metrics"].push_back(json_of(metric));
  return document.dump(2) + "\n";
}

}  // namespace slosh
