#include "verification/papers/paper_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;
using std::string;
using Texts = std::vector<string>;

// Every quantity of a figure on its axis, as its panels have it.
string axes_text(const PaperFigure& figure) {
  if (figure.redrawn == Redrawn::not_at_all) return "";
  if (figure.redrawn == Redrawn::fields) return "the tank, to scale";
  std::vector<string> labels;
  for (const string& name : figure.quantities) {
    const Quantity& quantity = *find_quantity(name);
    if (figure.without_dimensions)
      labels.emplace_back(quantity.label_over_depth);
    else if (figure.redrawn == Redrawn::spectrum)
      labels.push_back(fmt::format("power [{}2]", quantity.unit));
    else
      labels.push_back(fmt::format("{} [{}]", quantity.label, quantity.shown_unit));
  }
  return fmt::format("{}; {}",
                     figure.redrawn == Redrawn::spectrum ? "frequency [Hz]"
                     : figure.without_dimensions         ? "t/T [1]"
                                                         : "time [s]",
                     fmt::join(labels, "; "));
}

string span_text(const PaperFigure& figure) {
  const auto [begin, end] = figure.time_span_s;
  if (begin < end) return fmt::format("{:g} to {:g} s", begin, end);
  switch (figure.redrawn) {
    case Redrawn::spectrum:
      return "the comparison window";
    case Redrawn::fields:
    case Redrawn::not_at_all:
      return "";
    default:
      return "the whole run; the paper's is not known";
  }
}

Table figures_table(const Paper& paper, const RedrawnFigures& redrawn) {
  Table table{
      paper.name + "-figures",
      "Figures of the paper",
      "What each shows, and the panels below that redraw it. Time spans and axes are those of the "
      "panels: the paper's where they are known here. The units and the limits of the paper's axes "
      "are not known.",
      {"figure", "what it shows", "redrawn", "left out", "cases", "time span", "axes",
       "not known of it"}};
  for (std::size_t i = 0; i < paper.figures.size(); ++i) {
    const PaperFigure& figure = paper.figures[i];
    const auto& [number, anchors, missing] = redrawn.at(i);
    table.rows.push_back({figure_name(figure.number), figure.shows,
                          anchors.empty()       ? "no"
                          : anchors.size() == 1 ? "in 1 panel"
                                                : fmt::format("in {} panels", anchors.size()),
                          fmt::format("{}", fmt::join(missing, "; ")),
                          fmt::format("{}", fmt::join(figure.cases, ", ")), span_text(figure),
                          axes_text(figure), figure.not_known});
    table.links.emplace_back(table.header.size());
    if (!anchors.empty()) table.links.back()[2] = anchors.front();
  }
  return table;
}

Table errata_table(const Paper& paper, const RedrawnFigures& redrawn) {
  std::vector<PaperRow> rows;
  for (const Erratum& one : paper.errata)
    rows.push_back({{one.paper, one.correction, one.computed}, one.figures});
  return with_figures({paper.name + "-errata",
                       "Errata of " + paper.citation,
                       "Each with the numbers computed here.",
                       {"the paper", "correction", "computed"}},
                      rows, redrawn);
}

Table deviations_table(const Paper& paper) {
  Table table{paper.name + "-deviations",
              "Deviations from the paper as printed",
              "What the schemes and the cases do in another way than the paper says, and what the "
              "paper leaves open.",
              {"of", "the paper", "here", "why"}};
  for (const Deviation& one : paper.deviations)
    table.rows.push_back({one.of, one.printed, one.here, one.why});
  return table;
}

// Returns "run: x; run: y", what the format says of a mode of the elevation against linear theory
// for each run of the scheme that has one.
string for_each_li2010_run(const CaseAssessment* assessment, const string& mode,
                           string (*format)(const ModeComparison&)) {
  Texts texts;
  if (assessment)
    for (const Comparison& pair : assessment->comparisons) {
      if (!pair.candidate.starts_with("li2010") || pair.reference != "linear" ||
          !pair.quantity.starts_with("elevation@"))
        continue;
      for (const ModeComparison& one : pair.modes)
        if (one.mode == mode)
          texts.push_back(pair.candidate + ": " + (one.resolved() ? format(one) : "not resolved"));
    }
  return texts.empty() ? "not run" : fmt::format("{}", fmt::join(texts, "; "));
}

string lag_text(const ModeComparison& mode) {
  return interval_text(mode.phase_lag_degrees) + " deg";
}

string amplitude_text(const ModeComparison& mode) {
  return percent_interval_text(mode.amplitude_error);
}

string decay_text(const ModeComparison& mode) {
  return fmt::format("{} 1/s, frequency {}", interval_text(mode.decay_rate),
                     percent_interval_text(mode.frequency_error));
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

// Returns the anchor of the figure's first panel, "" where it has none.
string anchor_of(const RedrawnFigures& redrawn, const string& number) {
  for (const RedrawnFigure& one : redrawn)
    if (one.number == number && !one.anchors.empty()) return one.anchors.front();
  return "";
}

}  // namespace

string figure_name(const string& number) {
  return (number.find(' ') == string::npos ? "figure " : "figures ") + number;
}

Table with_figures(Table head, const std::vector<PaperRow>& rows, const RedrawnFigures& redrawn) {
  head.header.emplace_back("figure of the paper");
  for (const PaperRow& row : rows) {
    head.rows.push_back(row.cells);
    std::vector<string> names;
    for (const string& number : row.figures) names.push_back(figure_name(number));
    head.rows.back().push_back(fmt::format("{}", fmt::join(names, ", ")));
    head.links.emplace_back(head.header.size());
    string& link = head.links.back().back();
    for (const string& number : row.figures)
      if (link.empty()) link = anchor_of(redrawn, number);
  }
  return head;
}

Table claims_table(const string& id, const std::vector<DecidedClaim>& claims,
                   const RedrawnFigures& redrawn) {
  std::vector<PaperRow> rows;
  for (const DecidedClaim& one : claims)
    rows.push_back(
        {{one.claim.number, one.claim.statement, one.claim.printed, verdict_of(one.held), one.found,
          one.why == one.found ? "" : one.why, fmt::format("{}", fmt::join(one.runs, "; "))},
         one.claim.figures});
  return with_figures(
      {id,
       "Claims of the paper",
       "Each claim under the paper's number, in our own words; what a number is held against is in "
       "brackets. The thresholds were set before the numbers were looked at, but for those that "
       "the text above names. A claim cannot be confirmed where a run is absent or failed, a "
       "number is NaN, or an interval reaches over a threshold.",
       {"claim", "in our words", "printed", "verdict", "result",
        "evidence against it, or what is missing", "decided by"}},
      rows, redrawn);
}

reports::Section paper_section(const Paper& paper, const std::vector<CaseAssessment>& cases,
                               const RedrawnFigures& redrawn) {
  reports::Section section{
      paper.name,
      "Comparison with the paper",
      paper.text,
      {claims_table(paper.name + "-claims", decided_claims(paper, cases), redrawn)}};
  if (paper.name == "li2010") {
    const CaseAssessment *smaller = find_case(cases, "li2010_large_b075"),
                         *larger = find_case(cases, "li2010_large_b125");
    if (smaller && larger)
      section.tables.push_back(surface_spectrum_table(*smaller, *larger, redrawn));
    section.tables.push_back(printed_numbers_table(cases, redrawn));
  }
  section.tables.push_back(errata_table(paper, redrawn));
  section.tables.push_back(deviations_table(paper));
  section.tables.push_back(figures_table(paper, redrawn));
  return section;
}

Table printed_numbers_table(const std::vector<CaseAssessment>& cases,
                            const RedrawnFigures& redrawn) {
  const CaseAssessment* small = find_case(cases, "li2010_small_amplitude");
  const bool is_run = small && small->runs.results.contains("li2010_20mm");
  return with_figures(
      {"li2010-numbers",
       "The paper's printed numbers and ours",
       "",
       {"quantity", "printed", "here"}},
      {{{"first natural frequency", "4.94488 rad/s", "4.96646 rad/s with g = 9.81 m/s2 (+0.44 %)"}},
       {{"particles at 2 cm", "900",
         is_run ? fmt::format("{:.0f}: 0.35 m is 17.5 spacings, laid as 18 rows",
                              small->runs.results.at("li2010_20mm").cost.elements)
                : "not run"}},
       {{"period of the forced motion", "agrees with theory",
         "lag of the forced mode: " + for_each_li2010_run(small, "forced", lag_text)},
        {"1"}},
       {{"amplitude of the forced motion", "slightly below theory, crests flattened",
         for_each_li2010_run(small, "forced", amplitude_text)},
        {"1"}},
       {{"first natural mode", "not given; alpha = 1 damps it",
         "decay: " + for_each_li2010_run(small, "natural_1", decay_text)},
        {"1"}}},
      redrawn);
}

Table surface_spectrum_table(const CaseAssessment& smaller, const CaseAssessment& larger,
                             const RedrawnFigures& redrawn) {
  Table table{
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
