#include "verification/papers/paper_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "verification/case/quantities.hpp"

namespace slosh {
namespace {

using std::string;

const std::vector<Paper>& papers() {
  using namespace paper_cases;
  static const std::vector<Paper> all{
      {"li2010",
       "Li et al. 2010",
       {"li2010"},
       0.02,
       {{.number = "1",
         .shows = "surface elevation 0.05 m from the right wall at small amplitude: SPH and linear "
                  "theory",
         .redrawn = Redrawn::history,
         .cases = {small},
         .quantities = {"elevation@right"},
         .time_span = {0, 12}},
        {.number = "2",
         .shows = "resonant surge of T = 1.2 s, b = 0.025 and 0.05 m",
         .redrawn = Redrawn::history,
         .cases = {"li2010_resonant_T12_b025", "li2010_resonant_T12_b050"},
         .quantities = {"elevation@right"},
         .not_known = "which panel has which amplitude"},
        {.number = "3",
         .shows = "resonant surge of T = 1.3 s, b = 0.025 and 0.05 m",
         .redrawn = Redrawn::history,
         .cases = {"li2010_resonant_T13_b025", "li2010_resonant_T13_b050"},
         .quantities = {"elevation@right"},
         .not_known = "which panel has which amplitude"},
        {.number = "4",
         .shows = "velocity and pressure at large amplitude, at 12.5 and 35 s",
         .redrawn = Redrawn::fields,
         .cases = {b075, b125},
         .time_span = {12.5, 35}},
        {.number = "5",
         .shows = "highest surface 0.05 m from the right wall at large amplitude, without "
                  "dimensions",
         .redrawn = Redrawn::history,
         .cases = {b075, b125},
         .quantities = {"highest_surface@right"},
         .time_span = {0, 40},
         .without_dimensions = true,
         .not_known = "what it is divided by: the still depth and the forcing's period are ours"},
        {.number = "6",
         .shows = "total momentum at large amplitude, a magnitude such as sum m |v|; here its two "
                  "components; the claims are judged on their magnitude",
         .redrawn = Redrawn::history,
         .cases = {b075, b125},
         .quantities = {"momentum_x", "momentum_z"},
         .time_span = {0, 40},
         .not_known = "which magnitude it shows"},
        {.number = "7",
         .shows = "spectrum of the highest surface at large amplitude, with peaks at 0.77 and "
                  "1.54 Hz",
         .redrawn = Redrawn::spectrum,
         .cases = {b075, b125},
         .quantities = {"highest_surface@right"},
         .not_known = "the unit of its power, and its window"}}},
      {"zhao2021",
       "Zhao et al. 2021",
       {"zhao2021_moving", "zhao2021_fixed"},
       0.002,
       {{.number = "1 and 2",
         .redrawn = Redrawn::not_at_all,
         .not_known = "what they show: our text of the paper says nothing of them"},
        {.number = "3",
         .shows = "pressure on the right wall 0.17 m above the bottom in the mildly rolling tank, "
                  "here the left wall, as its roll begins clockwise",
         .redrawn = Redrawn::history,
         .cases = {mild},
         .quantities = {"wall_pressure@P"},
         .not_known = "whether its pressure is filtered: ours is not"},
        {.number = "4",
         .shows = "force, and moment about the axis, of the mild roll",
         .redrawn = Redrawn::history,
         .cases = {mild},
         .quantities = {"force_x", "force_z", "moment"},
         .not_known = "which component of the force it shows: both stand here"},
        {.number = "5",
         .shows = "pressure in the mildly rolling tank at several moments, moving beside fixed "
                  "boundary particles",
         .redrawn = Redrawn::fields,
         .cases = {mild},
         .not_known = "the moments"},
        {.number = "6",
         .redrawn = Redrawn::not_at_all,
         .not_known = "what it shows: our text of the paper says nothing of it"},
        {.number = "7",
         .shows = "the angle of the violent roll over time, which is given to the runs",
         .redrawn = Redrawn::not_at_all,
         .not_known = "a run that computes it: it is the measured roll of SPHERIC benchmark 10"},
        {.number = "8",
         .shows =
             "pressure on the left wall 0.093 m above the bottom in the violently rolling tank",
         .redrawn = Redrawn::history,
         .cases = {violent},
         .quantities = {"wall_pressure@B", "wall_pressure@B/filtered"},
         .not_known = "whether its pressure is filtered: both stand here"},
        {.number = "9",
         .shows = "the violent roll at 3.45, 3.95, 4.35 and 4.75 s",
         .redrawn = Redrawn::fields,
         .cases = {violent},
         .time_span = {3.45, 4.75}},
        {.number = "10",
         .shows = "the violent roll with several time steps, moving and fixed boundary particles",
         .redrawn = Redrawn::time_steps,
         .cases = {violent},
         .quantities = {"wall_pressure@B/filtered"},
         .not_known = "its quantity and its time steps: the filtered pressure is our choice"},
        {.number = "11",
         .shows = "the violent roll with several particle spacings, moving and fixed boundary "
                  "particles",
         .redrawn = Redrawn::spacings,
         .cases = {violent},
         .quantities = {"wall_pressure@B/filtered"},
         .not_known = "its quantity and its spacings: the filtered pressure is our choice"}}}};
  return all;
}

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
  const auto [begin, end] = figure.time_span;
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

}  // namespace

const Paper& paper_named(const string& name) {
  for (const Paper& paper : papers())
    if (paper.name == name) return paper;
  throw std::invalid_argument("no paper has the name " + name);
}

string anchor_of(const RedrawnFigures& redrawn, const string& number) {
  for (const RedrawnFigure& one : redrawn)
    if (one.number == number && !one.anchors.empty()) return one.anchors.front();
  return "";
}

string figure_name(const string& number) {
  return (number.find(' ') == string::npos ? "figure " : "figures ") + number;
}

reports::Table paper_figures_table(const Paper& paper, const RedrawnFigures& redrawn) {
  reports::Table table{
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

reports::Table with_figures(reports::Table head, const std::vector<PaperRow>& rows,
                            const RedrawnFigures& redrawn) {
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

}  // namespace slosh
