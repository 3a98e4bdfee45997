// The whole of a report as plain data: reports/ draws and formats it and computes no physics.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slosh::reports {

// A polyline (or points) of a figure.
struct Curve {
  std::string label;
  std::vector<double> x, y;
  std::vector<double> y_error;  // half bars; empty for none
  enum class Style { line, dashed, points, line_points } style = Style::line;
};

// A shaded band between two horizontal levels (a tolerance).
struct Band {
  std::string label;
  double lower, upper;
};

// A vertical line with a label (a predicted frequency).
struct Marker {
  std::string label;
  double x;
};

struct Figure {
  std::string id;       // file name stem and anchor, unique in the report
  std::string title, caption;
  std::string x_label, y_label;
  bool log_x = false, log_y = false;
  std::pair<double, double> x_range{0, 0};  // equal ends: automatic
  std::vector<Curve> curves;
  std::vector<Band> bands;
  std::vector<Marker> markers;
};

struct Table {
  std::string id, title, caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header; "pass"/"FAIL"/... cells get a colour
};

struct Section {
  std::string id, title;
  std::vector<std::string> paragraphs;
  std::vector<Table> tables;
  std::vector<Figure> figures;
};

struct Report {
  std::string title;
  std::string verdict;          // one sentence, first of all
  bool passed = false;
  std::string subtitle;         // date, version, machine
  std::vector<Section> sections;
  std::string results_json;     // the machine-readable document, already serialised (schema in the README)
};

}  // namespace slosh::reports
