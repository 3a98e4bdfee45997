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

// How the errors of a problem's measure over its resolutions are judged.
enum class ProblemMetric {
  order_at_least,   // slope of the least-squares line through (ln step, ln |error|)
  order_within,     // the same between two bounds
  error_at_finest,  // |error| at the smallest step
  largest_error     // |error| over all steps
};

inline constexpr EnumName<ProblemMetric> problem_metric_names[] = {
    {ProblemMetric::order_at_least, "order_at_least"},
    {ProblemMetric::order_within, "order_within"},
    {ProblemMetric::error_at_finest, "error_at_finest"},
    {ProblemMetric::largest_error, "largest_error"}};

inline std::string metric_name(ProblemMetric metric) {
  return name_of(metric, problem_metric_names);
}

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

// The existing problems, against which a campaign file is checked.
struct KnownMeasure {
  std::string name, unit;
};
struct KnownProblem {
  std::string name;
  std::vector<KnownMeasure> measures;
};

// The runs that are repeated alone on the machine, so that their costs can be compared.
struct TimingDefinition {
  int repeats = 0;                // of each; 0: none
  double longest_run = 60;        // [s] of processor time; longer runs are not repeated
  std::vector<std::string> only;  // patterns (run_selection.hpp); empty: all
};

struct CampaignDefinition {
  std::string name, title, source;
  // The paper whose printed numbers and errata the report shows beside its own: "li2010",
  // "zhao2021", or empty.
  std::string paper;
  std::vector<std::filesystem::path> cases;  // case files, in the order of the report
  std::string text;                          // the file as read
  std::filesystem::path file;
  std::vector<ProblemDefinition> problems = {};  // in the order of the report, after the cases
  TimingDefinition timing = {};
};

}  // namespace slosh
