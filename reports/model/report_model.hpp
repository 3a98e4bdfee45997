// A report as plain data. The code in reports/ that draws and formats it computes no physics.
//
// Ids (of sections, tables and figures) are made of ASCII letters, digits, '-' and '_', and are
// unique among their kind. In paragraphs, captions and cells, text between `backticks` is shown as
// code. Values that are not finite leave a gap in a curve. Markers, bands, and the places and
// arrows of a field are not drawn where they are not finite.
//
// Each section stands on a page. A section that names no page stands on the first, index.html,
// which has the verdict.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace slosh::reports {

// The one exception of everything that writes or draws a report: the report contradicts its model,
// gnuplot is missing or refused a figure, or the directory cannot be written.
struct ReportError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// How all figures of a report draw one run, so that a reader knows it again. The colours, markers
// and dashes are those of figure_palette.hpp, whose lists are taken up again beyond their ends.
struct Look {
  bool is_reference = false;  // black and grey take turns; any other run has a hue
  std::size_t colour = 0;
  std::size_t shape = 0;  // the marker and the dash

  bool operator==(const Look&) const = default;
};

// A polyline (or points) of a figure.
struct Curve {
  std::string label;                   // empty: it has no entry in the legend
  std::vector<double> x = {}, y = {};  // of equal length
  std::vector<double> y_error = {};    // half bars, as long as y; empty for none
  enum class Style { line, dashed, points, line_points } style = Style::line;
  std::vector<double> x_error = {};            // half bars, as long as x; empty for none
  std::vector<double> lower = {}, upper = {};  // edges of a ribbon, as long as y; empty for none
  std::string ribbon = {};                     // what the ribbon shows, for the legend
  std::optional<Look> look = {};               // absent: by the curve's place in the figure
  // A curve that sets no scale is drawn thin, and cut off where it leaves the frame of the others.
  bool sets_scale = true;
};

// A shaded band between two horizontal levels (a tolerance); an infinite level reaches the figure's
// edge.
struct Band {
  std::string label;
  double lower, upper;
  std::optional<Look> look = {};  // of the curve that it belongs to; absent: a colour of bands
};

// A vertical line with a label (a predicted frequency); not drawn outside a given x_range.
struct Marker {
  std::string label;
  double x;
};

// A shaded interval of the horizontal axis (a transient that no metric uses). Spans with the same
// label share their entry in the legend.
struct Span {
  std::string label;
  double begin, end;
};

struct Figure {
  std::string id;  // file name stem, and the anchor is "figure-<id>"
  std::string title, caption = {};
  std::string x_label = {}, y_label = {};
  bool log_x = false, log_y = false;        // values that are not positive leave a gap there
  std::pair<double, double> x_range{0, 0};  // equal ends: automatic
  std::vector<Curve> curves = {};           // those of one ribbon text share its legend entry
  std::vector<Band> bands = {};
  std::vector<Marker> markers = {};
  std::vector<Span> spans = {};
  bool equal_axes = false;  // a square with one scale for both axes, neither of them logarithmic
  bool to_scale = false;    // one scale for both axes, whose ranges are given; as high as they take
  std::vector<std::pair<double, std::string>> x_ticks = {};  // place and label; empty: automatic
  std::pair<double, double> y_range{0, 0};  // of several figures with one scale; else automatic
  bool is_small = false;  // one of small multiples: its page draws one legend for them all
};

// A corner of a tank's outline [m], in the tank's own frame.
struct TankCorner {
  double x, z;
};

// A tank at one moment, its water coloured by a scalar (the pressure, the speed). The places are
// the particles of SPH or the wet cells of a mesh, in the tank's own frame whatever its roll: x [m]
// from its left wall, z [m] from its bottom.
struct FieldPanel {
  std::string label;                        // "li2010 2 mm, t = 3.45 s"
  double angle = 0;                         // the roll [rad], counter-clockwise about the axis
  double axis_x = 0, axis_z = 0;            // [m]
  double tank_length = 0, tank_height = 0;  // [m], above zero
  // Of a tank that is no rectangle, counter-clockwise; the rectangle around it is that of length
  // and height.
  std::vector<TankCorner> outline = {};
  double point_width = 0, point_height = 0;  // [m], above zero: the rectangle at each place
  std::vector<double> x, z, value;           // [m], [m], of equal length
  std::vector<double> arrow_x, arrow_z;      // [m], of equal length with the next two, or empty
  std::vector<double> arrow_u, arrow_w;      // [m/s], the velocity in the tank's own directions
};

// Panels in rows, with one scale, one colour bar and one scale of the arrows. A panel without
// places was not recorded.
struct FieldFigure {
  std::string id;  // unique among the figures too: file name stem, and the anchor is "figure-<id>"
  std::string title, caption;
  std::string value_label;                      // with its unit: "pressure (Pa)"
  std::pair<double, double> value_range{0, 0};  // equal ends: the middle 98 % of all values
  double arrow_scale = 0;                       // m of the tank per m/s; 0: automatic
  int columns = 1;                              // panels in a row
  std::vector<FieldPanel> panels;               // row by row
  bool is_animation = false;                    // its rows are shown one after the other
};

// The cells "pass", "confirmed", "validated", "limits kept", "watched, not validated", "FAIL",
// "violated", "refuted", "inconclusive", "solver failed", "not compared", "no result", "not
// selected", "not supplied", "not decidable", "out of range", "skipped" (in upper or lower case)
// get a sign and a colour, and so does a cell that begins with such a word and ": ". Columns of
// numbers are aligned right.
struct Table {
  std::string id, title, caption;  // the anchor is "table-<id>"
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows = {};  // each as long as the header
  std::vector<std::string> row_ids = {};  // anchors "row-<id>", one per row; empty for none
  // For each cell the anchor of this report that it links to ("section-gate", "row-surge-3"), empty
  // for none. There are as many as cells, or none at all.
  std::vector<std::vector<std::string>> links = {};
  // The reason behind each row, empty for none; as many as rows, or none at all. Pages fold it in
  // the row's last cell until it is asked for; what is printed shows it.
  std::vector<std::string> reasons = {};
  bool is_folded = false;  // behind its title and the number of its rows, until it is asked for
};

struct Section {
  std::string id, title;  // the anchor is "section-<id>"
  std::vector<std::string> paragraphs = {};
  std::vector<Table> tables = {};
  std::vector<Figure> figures = {};
  std::vector<FieldFigure> fields = {};  // after the figures; the numbering continues
  std::string page = {};                 // the id of the page it stands on; empty: the first
};

// What is watched departs no further than earlier, and nothing is validated.
enum class Outcome { pass, watched, inconclusive, not_compared, fail };

// A text that links to an anchor of the report.
struct Link {
  std::string text, anchor;
};

// A page other than the first.
struct Page {
  std::string id;  // as sections' ids, and not "index": the file is "<id>.html"
  std::string title;
  std::string verdict;              // one sentence; empty for none
  Outcome outcome = Outcome::fail;  // where there is a verdict
  std::string continues = {};       // the id of the page whose appendix it is; empty: its own page
  // A small figure that stands beside the page's entry on the first page, and a remark below it.
  std::optional<Figure> glance = {};
  std::string remark = {};
  std::vector<std::string> doubts = {};  // below the verdict: sentences
};

// What decides the outcome: "Decided by" ROW ": 7.2 ± 0.3 %, at most 5 %." The text of the row's
// link is empty where nothing decides.
struct Decision {
  std::string lead;  // before the link
  Link row = {};
  std::string finding = {};  // after it: sentences
};

struct Report {
  std::string title;
  std::string verdict;  // one sentence, at the top of the report
  Outcome outcome = Outcome::fail;
  Decision decision = {};
  std::vector<std::string> doubts = {};  // below the verdict: sentences
  std::string coverage = {};  // of the checks: what they check and would detect; empty for none
  std::string subtitle;       // date, version, machine
  std::vector<Section> sections;
  std::string results_json;  // the machine-readable document, already serialised (docs/results.md)
  std::vector<Page> pages = {};  // after the first, in their order
};

}  // namespace slosh::reports
