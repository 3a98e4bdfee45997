#include "verification/texts/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

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

}  // namespace slosh
