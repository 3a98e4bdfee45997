// The numbers that Li et al. 2010 print, beside those of this campaign's runs.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using std::string;
using Texts = std::vector<string>;

// Returns "run: x; run: y", a measure of a mode of the elevation against linear theory for each run
// of the scheme that has one.
template <class Format>
string for_each_li2010_run(const CaseAssessment* assessment, const string& mode,
                           const Format& format) {
  string text;
  if (assessment)
    for (const Comparison& pair : assessment->comparisons) {
      if (!pair.candidate.starts_with("li2010") || pair.reference != "linear" ||
          !pair.quantity.starts_with("elevation@"))
        continue;
      for (const ModeComparison& one : pair.modes)
        if (one.mode == mode)
          text += (text.empty() ? "" : "; ") + pair.candidate + ": " +
                  (one.resolved() ? format(one) : "not resolved");
    }
  return text.empty() ? "not run" : text;
}

double amplitude(const CaseDefinition& definition) {
  const auto* sine =
      definition.motion.surge ? std::get_if<SineMotion>(&*definition.motion.surge) : nullptr;
  return sine ? sine->amplitude : not_a_number;
}

// The geometric mean of a ratio with its interval, or "unknown" where a member has no such number.
string mean_text(const std::vector<double>& of, const std::vector<double>& over) {
  const Estimate mean = ratio_of_members(of, over);
  return std::isfinite(mean.value) ? interval_text(mean) : "unknown";
}

std::vector<double> of_spectrum(const CaseAssessment& assessment, const string& run,
                                Measure measure) {
  return numbers(measured(assessment, run, {"", measure}));
}

Texts spectrum_row(const CaseAssessment& assessment, const string& run) {
  Texts row{name_of_members(assessment, run), fmt::format("{}", amplitude(assessment.definition))};
  const auto of = [&](Measure measure) { return of_spectrum(assessment, run, measure); };
  try {
    row.insert(
        row.end(),
        {frequency_text(of(Measure::first_frequency)), mean_text(of(Measure::first_power), {1}),
         frequency_text(of(Measure::second_frequency)), mean_text(of(Measure::second_power), {1}),
         mean_text(of(Measure::power_ratio), {1})});
  } catch (const std::runtime_error& error) {
    row.emplace_back(error.what());
  }
  return row;
}

// The growth of both powers; empty where a spectrum is missing, of which the rows tell.
Texts growth(const CaseAssessment& smaller, const CaseAssessment& larger, const string& run) try {
  const auto of = [&](Measure measure) {
    return mean_text(of_spectrum(larger, run, measure), of_spectrum(smaller, run, measure));
  };
  return {of(Measure::first_power), of(Measure::second_power)};
} catch (const std::runtime_error&) {
  return {"", ""};
}

}  // namespace

reports::Table printed_numbers_table(const std::vector<CaseAssessment>& cases,
                                     const RedrawnFigures& redrawn) {
  const CaseAssessment* small = find_case(cases, "li2010_small_amplitude");
  const bool is_run = small && small->runs.results.contains("li2010_20mm");
  return with_figures(
      {"li2010-numbers",
       "The paper's printed numbers and ours",
       "",
       {"quantity", "printed", "here"},
       {}},
      {{{"first natural frequency", "4.94488 rad/s", "4.96646 rad/s with g = 9.81 m/s2 (+0.44 %)"}},
       {{"particles at 2 cm", "900",
         is_run ? fmt::format("{:.0f}: 0.35 m is 17.5 spacings, laid as 18 rows",
                              small->runs.results.at("li2010_20mm").cost.elements)
                : "not run"}},
       {{"period of the forced motion", "agrees with theory",
         "lag of the forced mode: " + for_each_li2010_run(small, "forced",
                                                          [](const ModeComparison& mode) {
                                                            return interval_text(
                                                                       mode.phase_lag_degrees) +
                                                                   " deg";
                                                          })},
        {"1"}},
       {{"amplitude of the forced motion", "slightly below theory, crests flattened",
         for_each_li2010_run(small, "forced",
                             [](const ModeComparison& mode) {
                               return percent_interval_text(mode.amplitude_error);
                             })},
        {"1"}},
       {{"first natural mode", "not given; alpha = 1 damps it",
         "decay: " + for_each_li2010_run(small, "natural_1",
                                         [](const ModeComparison& mode) {
                                           return fmt::format(
                                               "{} 1/s, frequency {}",
                                               interval_text(mode.decay_rate),
                                               percent_interval_text(mode.frequency_error));
                                         })},
        {"1"}}},
      redrawn);
}

reports::Table surface_spectrum_table(const CaseAssessment& smaller, const CaseAssessment& larger,
                                      const RedrawnFigures& redrawn) {
  reports::Table table{
      "li2010-spectrum",
      "Spectrum of the highest surface elevation",
      fmt::format(
          "Peaks at the excitation frequency and at twice that, {} m from the left wall, from {} "
          "to {} s. Power: half the squared amplitude of a sine [m2], one-sided, Hann window. Of "
          "an ensemble they are means over its repeats, the powers geometric ones. The unit of the "
          "printed power is unknown, so only ratios can be compared. Growth: from the "
          "smaller to the larger amplitude b.",
          smaller.definition.gauges.empty() ? not_a_number : smaller.definition.gauges.front().x,
          smaller.definition.window_begin, smaller.definition.window_end),
      {"run", "b [m]", "first peak [Hz]", "its power", "second peak [Hz]", "its power",
       "first / second", "growth of the first", "growth of the second"},
      {{"printed", "0.075", "0.77", "0.048", "1.54", "0.024", "2.00", "", ""},
       {"printed", "0.125", "0.77", "0.2423", "1.54", "0.0493", "4.915", "5.05", "2.05"}}};
  for (const RunDefinition& run : smaller.definition.runs) {
    if (!solver_kind(run).solves_flow || is_later_member(run) ||
        !larger.runs.status.contains(run.name))
      continue;
    table.rows.push_back(spectrum_row(smaller, run.name));
    table.rows.back().resize(table.header.size());
    table.rows.push_back(spectrum_row(larger, run.name));
    table.rows.back().resize(table.header.size() - 2);
    for (string& text : growth(smaller, larger, run.name)) table.rows.back().push_back(text);
  }
  table.links.assign(table.rows.size(), Texts(table.header.size()));
  for (Texts& row : table.links) row.front() = anchor_of(redrawn, "7");
  return table;
}

}  // namespace slosh
