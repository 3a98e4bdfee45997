// The figures of the papers as data: what each shows, what redraws it, and what is not known here
// of it. The papers' texts are at hand, their pictures are not: where a row says nothing of a time
// span or of an axis, the harness chose its own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh {

// The papers' cases.
namespace paper_cases {
inline constexpr const char *small = "li2010_small_amplitude", *b075 = "li2010_large_b075",
                            *b125 = "li2010_large_b125", *mild = "zhao2021_mild_roll",
                            *violent = "zhao2021_violent_roll";
}  // namespace paper_cases

enum class Redrawn {
  history,     // a panel for each case and quantity: the time series
  spectrum,    // the same: the spectrum over the comparison window
  time_steps,  // a panel for each case and scheme of the paper: runs that differ in time step alone
  spacings,    // the same: runs that differ in particle spacing alone
  fields,      // by the fields of the case's own page
  not_at_all   // the row's `not_known` says why
};

struct PaperFigure {
  std::string number;      // "1", "2 and 3"
  std::string shows = {};  // in our words
  Redrawn redrawn;
  std::vector<std::string> cases = {};
  std::vector<std::string> quantities = {};   // series of the cases, where the kind needs them
  std::pair<double, double> time_span{0, 0};  // [s]; equal ends: not known, the whole run
  // Time over the forcing's period, height over the still depth.
  bool without_dimensions = false;
  std::string not_known = {};  // of the paper's figure, beside its limits and its units
};

struct Paper {
  std::string name;                  // in campaign files
  std::string citation;              // "Li et al. 2010"
  std::vector<std::string> schemes;  // SPH schemes that follow the paper, as families of runs
  double particle_spacing;           // [m], the paper's, as far as it is known
  std::vector<PaperFigure> figures;  // in the paper's order
};

// Throws std::invalid_argument where no paper has the name.
const Paper& paper_named(const std::string& name);

// What a report has of one of the paper's figures.
struct RedrawnFigure {
  std::string number;
  std::vector<std::string> anchors = {};  // of the panels, in the report
  std::vector<std::string> missing = {};  // why one or more panels are left out
};
using RedrawnFigures = std::vector<RedrawnFigure>;

// Returns the anchor of the figure's first panel, "" where it has none.
std::string anchor_of(const RedrawnFigures& redrawn, const std::string& number);

// "figure 5", "figures 2 and 3".
std::string figure_name(const std::string& number);

// The table of the paper's figures: each with what it shows and where its panels are. There is one
// entry of `redrawn` for each figure, in the same order.
reports::Table paper_figures_table(const Paper& paper, const RedrawnFigures& redrawn);

// A row on what a paper says, and the figures that it speaks of.
struct PaperRow {
  std::vector<std::string> cells;
  std::vector<std::string> figures = {};
};

// Returns the table with these rows and one more column, which names the figures of each row and
// links to the panel of the first one that has any. `head` has no rows.
reports::Table with_figures(reports::Table head, const std::vector<PaperRow>& rows,
                            const RedrawnFigures& redrawn);

}  // namespace slosh
