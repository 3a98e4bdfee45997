// The section on Li et al. 2010: its claims, its printed numbers and its errata.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/linear_surge.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/paper_claims.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;

constexpr double printed_natural_frequency =
    4.94488;  // omega_0 [rad/s], Li et al. 2010, section 4.1
const reference::Tank li2010_tank{1.0, 0.35, 9.81, 1000};
constexpr reference::SineSurge motion{0.02, 0.3 * printed_natural_frequency};
constexpr int modes = 1000;
constexpr double gauge = 0.45;  // [m] from the tank's centre: 0.05 m from the right wall
constexpr double shown = 12;    // [s], the time that figure 1 shows
constexpr double sampling = 0.01;

// Returns the largest |f(t)| over the time that the paper shows.
template <class Function>
double largest(const Function& f) {
  double value = 0;
  for (int i = 0; i * sampling <= shown; ++i) value = std::max(value, std::abs(f(i * sampling)));
  return value;
}

// Returns "run: x; run: y", a measure of a mode of the elevation against linear theory for each run
// of the scheme that has one.
template <class Format>
std::string for_each_li2010_run(const CaseAssessment* assessment, const std::string& mode,
                                const Format& format) {
  std::string text;
  if (assessment)
    for (const Comparison& pair : assessment->comparisons) {
      if (!pair.candidate.starts_with("li2010") || pair.reference != "linear" ||
          !pair.quantity.starts_with("elevation@"))
        continue;
      for (const ModeComparison& one : pair.modes)
        if (one.mode == mode)
          text += (text.empty() ? "" : "; ") + pair.candidate + ": " + format(one);
    }
  return text.empty() ? "not run" : text;
}

std::string li2010_particles(const CaseAssessment* assessment) {
  if (assessment && assessment->runs.results.contains("li2010_20mm"))
    return fmt::format("{:.0f}: 0.35 m is 17.5 spacings, laid as 18 rows",
                       assessment->runs.results.at("li2010_20mm").cost.elements);
  return "not run";
}

Table printed_numbers(const std::vector<CaseAssessment>& cases, const RedrawnFigures& redrawn) {
  const CaseAssessment* small = find_case(cases, paper_cases::small);
  const double omega = reference::natural_frequency(li2010_tank, 1);
  const std::string not_resolved = "not resolved";
  const auto amplitude = [&](const ModeComparison& mode) {
    return mode.resolved() ? percent_interval_text(mode.amplitude_error) : not_resolved;
  };
  const auto lag = [&](const ModeComparison& mode) {
    return mode.resolved() ? interval_text(mode.phase_lag_degrees) + " deg" : not_resolved;
  };
  const auto damping = [&](const ModeComparison& mode) {
    return mode.resolved() ? fmt::format("{} 1/s, frequency {}", interval_text(mode.decay_rate),
                                         percent_interval_text(mode.frequency_error))
                           : not_resolved;
  };
  return with_figures(
      {"li2010-numbers",
       "The paper's printed numbers and ours",
       "",
       {"quantity", "printed", "here"},
       {}},
      {{{"first natural frequency", "4.94488 rad/s",
         fmt::format("{:.5f} rad/s with g = 9.81 m/s2 ({:+.2f} %)", omega,
                     100 * (omega / printed_natural_frequency - 1))}},
       {{"particles at 2 cm", "900", li2010_particles(small)}},
       {{"period of the forced motion", "agrees with theory",
         "lag of the forced mode: " + for_each_li2010_run(small, "forced", lag)},
        {"1"}},
       {{"amplitude of the forced motion", "slightly below theory, crests flattened",
         for_each_li2010_run(small, "forced", amplitude)},
        {"1"}},
       {{"first natural mode", "not given; alpha = 1 damps it",
         "decay: " + for_each_li2010_run(small, "natural_1", damping)},
        {"1"}}},
      redrawn);
}

Table li2010_errata(const RedrawnFigures& redrawn) {
  const reference::LinearSurge ours(li2010_tank, reference::Start::earth, motion, modes);
  const reference::LinearSurge printed_sign(li2010_tank, reference::Start::earth,
                                            {-motion.amplitude, motion.angular_frequency}, modes);
  const double highest = largest([&](double t) { return ours.elevation(gauge, t); });
  const double opposite = largest(
      [&](double t) { return ours.elevation(gauge, t) + printed_sign.elevation(gauge, t); });
  // For L = 1 m, sin(lambda_n 0.95) = sin(lambda_n 0.05): x = 0.95 in eq. 16 is a gauge 0.05 m from
  // the centre.
  const double misplaced =
      largest([&](double t) { return ours.elevation(gauge, t) - ours.elevation(0.05, t); });
  const double omega = reference::natural_frequency(li2010_tank, 1);
  return with_figures(
      {"li2010-errata",
       "Errata of Li et al. 2010",
       "Each with the numbers computed here.",
       {"the paper", "correction", "computed"},
       {}},
      {{{"Eqs 16-20 use an undefined A",
         "They match x_e = b sin(omega t) only with A = -b omega; A = +b omega gives -eta.",
         fmt::format("largest |eta| {:.3f} mm; largest |eta(+b omega) + eta(-b omega)| {:.1g} mm",
                     1000 * highest, 1000 * opposite)},
        {"1"}},
       {{"omega_0 = 4.94488 rad/s", "g = 9.81 m/s2 gives another value.",
         fmt::format("{:.5f} rad/s, {:+.2f} % off", omega,
                     100 * (printed_natural_frequency / omega - 1))}},
       {{"excitation 0.787 Hz",
         "That is omega_0 / 2 pi; the excitation of T = 1.3 s is the spectrum's first peak itself.",
         fmt::format("omega_0 / 2 pi = {:.3f} Hz; 1 / 1.3 s = {:.3f} Hz",
                     printed_natural_frequency / (2 * std::numbers::pi), 1 / 1.3)},
        {"7"}},
       {{"Eq. 16's x, and axes fixed to the earth at the tank's corner",
         "x is fixed to the tank and counts from its centre.",
         fmt::format("x = 0.95 m taken literally errs by up to {:.2f} mm within {:.0f} s",
                     1000 * misplaced, shown)},
        {"1"}},
       {{"The momentum equation",
         "As printed it has neither gravity nor the artificial viscosity; the scheme li2010 has "
         "both.",
         ""}},
       {{"Mirror particles with equal and opposite velocity",
         "That is a no-slip wall, though the case is called inviscid, and for a moving wall it "
         "must be 2 v_wall - v.",
         fmt::format("the wall moves at up to {:.4f} m/s",
                     motion.amplitude * motion.angular_frequency)}},
       {{"900 particles", "A spacing of 2 cm makes 875 cells of 4 cm2; 18 rows of 50 make 900.",
         fmt::format("1 m x 0.35 m / (0.02 m)^2 = {:.0f}", 0.35 / 4e-4)}},
       {{"Small amplitude is below 15 % of the depth", "The rule leaves out resonance.",
         fmt::format("b / h = {:.1f} % at T = 1.3 s already breaks (b = 0.05 m)",
                     100 * 0.05 / 0.35)},
        {"2", "3"}}},
      redrawn);
}

}  // namespace

reports::Section li2010_section(const std::vector<CaseAssessment>& cases,
                                const RedrawnFigures& redrawn) {
  reports::Section section{
      "li2010",
      "Comparison with the paper",
      {"Li et al. 2010: sloshing in a surging tank by SPH with repulsive and mirror particles. The "
       "rows below lead to the paper's figures as they are redrawn from this campaign's runs.",
       "Results of these runs were known when three kinds of claims were set up: the comparison of "
       "the powers' growth with the printed one (C7.3), the two magnitudes of the momentum and "
       "their thresholds (C6.1 to C6.4), and the fluctuation within each period of the forcing in "
       "place of that over the whole window (C8.1). Conclusion 2 rests on C6.4 and C8.1."},
      {claims_table("li2010-claims", claims_of("li2010", cases), redrawn)},
      {}};
  const CaseAssessment* smaller = find_case(cases, paper_cases::b075);
  const CaseAssessment* larger = find_case(cases, paper_cases::b125);
  if (smaller && larger)
    section.tables.push_back(surface_spectrum_table(*smaller, *larger, redrawn));
  section.tables.push_back(printed_numbers(cases, redrawn));
  section.tables.push_back(li2010_errata(redrawn));
  section.tables.push_back(deviations_table("li2010"));
  section.tables.push_back(paper_figures_table(paper_named("li2010"), redrawn));
  return section;
}

}  // namespace slosh
