#include "verification/cli/texts/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "reports/model/report_files.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
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

}  // namespace slosh
