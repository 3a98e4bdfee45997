#include "verification/papers/paper_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/case/quantities.hpp"
#include "verification/papers/measured_values.hpp"

namespace slosh {
namespace {

using reports::Table;
using std::string;

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

string redrawn_text(const RedrawnFigure& redrawn) {
  if (redrawn.anchors.empty()) return "no";
  return redrawn.anchors.size() == 1 ? "in 1 panel"
                                     : fmt::format("in {} panels", redrawn.anchors.size());
}

Table figures_table(const Paper& paper, const RedrawnFigures& redrawn) {
  Table table{
      paper.name + "-figures",
      "Figures of the paper",
      "What each shows, and the panels below that redraw it. Time spans and axes are those of the "
      "panels: the paper's where they are known here. The units and the limits of the paper's axes "
      "are not known.",
      {"figure", "what it shows", "redrawn", "left out", "cases", "time span", "axes",
       "not known of it"},
      {}};
  for (std::size_t i = 0; i < paper.figures.size(); ++i) {
    const PaperFigure& figure = paper.figures[i];
    table.rows.push_back({figure_name(figure.number), figure.shows, redrawn_text(redrawn.at(i)),
                          fmt::format("{}", fmt::join(redrawn[i].missing, "; ")),
                          fmt::format("{}", fmt::join(figure.cases, ", ")), span_text(figure),
                          axes_text(figure), figure.not_known});
    table.links.emplace_back(table.header.size());
    if (!redrawn[i].anchors.empty()) table.links.back()[2] = redrawn[i].anchors.front();
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
                       {"the paper", "correction", "computed"},
                       {}},
                      rows, redrawn);
}

Table deviations_table(const Paper& paper) {
  Table table{paper.name + "-deviations",
              "Deviations from the paper as printed",
              "What the schemes and the cases do in another way than the paper says, and what the "
              "paper leaves open.",
              {"of", "the paper", "here", "why"},
              {}};
  for (const Deviation& one : paper.deviations)
    table.rows.push_back({one.of, one.printed, one.here, one.why});
  return table;
}

}  // namespace

string anchor_of(const RedrawnFigures& redrawn, const string& number) {
  for (const RedrawnFigure& one : redrawn)
    if (one.number == number && !one.anchors.empty()) return one.anchors.front();
  return "";
}

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
        "evidence against it, or what is missing", "decided by"},
       {}},
      rows, redrawn);
}

reports::Section paper_section(const Paper& paper, const std::vector<CaseAssessment>& cases,
                               const RedrawnFigures& redrawn) {
  reports::Section section{
      paper.name,
      "Comparison with the paper",
      paper.text,
      {claims_table(paper.name + "-claims", decided_claims(paper, cases), redrawn)},
      {}};
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

}  // namespace slosh
