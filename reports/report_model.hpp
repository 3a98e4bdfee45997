// The whole of a report as plain data: reports/ draws and formats it and computes no physics.
//
// Ids (of sections, tables and figures) are made of ASCII letters, digits, '-' and '_', and are
// unique among their kind. In paragraphs, captions and cells, text between `backticks` is shown as
// code. Values that are not finite leave a gap in a curve; markers and bands that are not finite
// are not drawn.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slosh::reports {

// A polyline (or points) of a figure.
struct Curve {
  std::string label;
  std::vector<double> x, y;     // of equal length
  std::vector<double> y_error;  // half bars, as long as y; empty for none
  enum class Style { line, dashed, points, line_points } style = Style::line;
};

// A shaded band between two horizontal levels (a tolerance); an infinite level reaches the figure's
// edge.
struct Band {
  std::string label;
  double lower, upper;
};

// A vertical line with a label (a predicted frequency); not drawn outside a given x_range.
struct Marker {
  std::string label;
  double x;
};

struct Figure {
  std::string id;  // file name stem, and the anchor is "figure-<id>"
  std::string title, caption;
  std::string x_label, y_label;
  bool log_x = false, log_y = false;        // values that are not positive leave a gap there
  std::pair<double, double> x_range{0, 0};  // equal ends: automatic
  std::vector<Curve> curves;
  std::vector<Band> bands;
  std::vector<Marker> markers;
};

// The cells "pass", "FAIL", "violated", "solver failed", "not compared", "no result", "not
// selected", "out of range" (in any case) get a sign and a colour. Columns of numbers are aligned
// right.
struct Table {
  std::string id, title, caption;  // the anchor is "table-<id>"
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header
};

struct Section {
  std::string id, title;  // the anchor is "section-<id>"
  std::vector<std::string> paragraphs;
  std::vector<Table> tables;
  std::vector<Figure> figures;
};

struct Report {
  std::string title;
  std::string verdict;  // one sentence, first of all
  bool passed = false;
  std::string subtitle;  // date, version, machine
  std::vector<Section> sections;
  std::string
      results_json;  // the machine-readable document, already serialised (schema in the README)
};

}  // namespace slosh::reports
