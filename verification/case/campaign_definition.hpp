// A campaign: cases that are run, compared, gated and reported together, and verification problems
// with exact solutions.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// What the errors of a problem's measure over its resolutions are judged by.
enum class ProblemMetric {
  order_at_least,   // slope of the least-squares line through (ln step, ln |error|)
  order_within,     // the same between two bounds
  error_at_finest,  // |error| at the smallest step
  largest_error     // |error| over all steps
};

struct ProblemGateRow {
  std::string measure;
  ProblemMetric metric;
  std::string unit;                                  // of the bounds; an order has "1"
  std::optional<double> limit;                       // of all but order_within
  std::optional<std::pair<double, double>> between;  // of order_within
  std::string reason, source;
  SourceLocation where;
  RowKind kind = RowKind::validation;
};

struct ProblemDefinition {
  std::string name;
  std::vector<ProblemGateRow> gate;
};

// The problems that there are, as a campaign file is checked against them.
struct KnownMeasure {
  std::string name, unit;
};
struct KnownProblem {
  std::string name;
  std::vector<KnownMeasure> measures;
};

// Which runs are repeated alone on the machine, so that what they take can be compared.
struct TimingDefinition {
  int repeats = 0;                // of each; 0: none
  double longest_run = 60;        // [s] of processor time: what takes longer is not repeated
  std::vector<std::string> only;  // patterns as run_selection.hpp has them; empty: all
};

struct CampaignDefinition {
  std::string name, title, source;
  std::string paper;  // whose printed numbers and errata the report sets beside ours: "li2010",
                      // "zhao2021", or empty
  std::vector<std::filesystem::path> cases;  // case files, in the order of the report
  std::string text;                          // the file as read
  std::filesystem::path file;
  std::vector<ProblemDefinition> problems = {};  // in the order of the report, after the cases
  TimingDefinition timing = {};
};

}  // namespace slosh
