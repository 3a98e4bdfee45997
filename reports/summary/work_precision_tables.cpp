#include "reports/summary/work_precision_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace slosh {
namespace {

using reports::Table;

const std::string mesh_family = "interFoam";

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

// "11.2 s (8.1 to 15.5)"
std::string with_range(double value, double spread, const std::string& unit) {
  const std::string text = fmt::format("{:.3g} {}", value, unit);
  if (!(spread > 0)) return text;
  return fmt::format("{} ({:.3g} to {:.3g})", text, value * std::exp(-spread),
                     value * std::exp(spread));
}

// A kind of cost as a table tells it.
struct CostColumn {
  std::vector<WorkPoint> (*points)(const WorkFamily&);
  double scale;
  std::string unit;
};

const CostColumn time_column{by_core_seconds, 1, "s"};
const CostColumn memory_column{by_memory, 1.0 / 1048576, "MiB"};

std::string reached_text(const CostAtError& found, const CostColumn& column) {
  const std::string text = with_range(column.scale * found.cost, known_spread(found), column.unit);
  switch (found.reach) {
    case Reach::between:
      return text;
    case Reach::by_cheapest:
      return "at most " + text;
    case Reach::extrapolated:
      return "extrapolated: " + text;
    case Reach::not_at_all:
      break;
  }
  if (!found.most_exact) return "not reached";
  return fmt::format("not reached ({} at {:.3g} {})", percent(found.most_exact->error.value),
                     column.scale * found.most_exact->cost.value, column.unit);
}

std::string slope_text(const WorkFamily& family, const CostColumn& column) {
  const auto slope = work_slope(column.points(family));
  if (!slope) return "";
  return std::isnan(slope->half_width)
             ? fmt::format("{:.2f}", slope->value)
             : fmt::format("{:.2f} ± {:.2f}", slope->value, slope->half_width);
}

// "5 to 6 times", "once, beside other runs", "3 of 5 runs"
std::string timed_text(const WorkFamily& family) {
  std::size_t timed = 0, fewest = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const WorkRun& run : family.runs) {
    if (run.cost.timings == 0) continue;
    ++timed;
    fewest = std::min(fewest, run.cost.timings);
    most = std::max(most, run.cost.timings);
  }
  if (timed == 0) return "beside other runs";
  const std::string times = fewest == most ? fmt::format("alone, {} times", most)
                                           : fmt::format("alone, {} to {} times", fewest, most);
  return timed == family.runs.size()
             ? times
             : fmt::format("{} of {} runs {}; beside other runs", timed, family.runs.size(), times);
}

// What all the runs were made by and on, each once.
std::string made_on(const CaseAssessment& assessment, const std::vector<WorkFamily>& families) {
  std::set<std::string> places;
  for (const WorkFamily& family : families)
    for (const WorkRun& run : family.runs) {
      const auto& origin = assessment.runs.results.at(run.run).provenance;
      const auto told = [&](const char* key) {
        const auto found = origin.find(key);
        return found == origin.end() || found->second.empty() ? "not told" : found->second;
      };
      places.insert(fmt::format("{}; compiler {}, flags {}", told("processor"), told("compiler"),
                                told("compiler_flags")));
    }
  return fmt::format("{}", fmt::join(places, " | "));
}

Table cost_at_errors(const CaseAssessment& assessment, const std::vector<WorkFamily>& families,
                     const CostColumn& column) {
  Table table{"", "", "", {"method", "against", "measured", "runs", "slope"}, {}};
  for (const double error : told_errors()) table.header.push_back(percent(error));
  for (const WorkFamily& family : families) {
    std::vector<std::string> row{family.name, family.reference, timed_text(family),
                                 fmt::format("{}", family.runs.size()), slope_text(family, column)};
    for (const double error : told_errors())
      row.push_back(reached_text(cost_at_error_or_beyond(column.points(family), error), column));
    table.rows.push_back(std::move(row));
  }
  table.caption = fmt::format(
      "Interpolated between the runs of the method's own Pareto front, with the 95 % interval that "
      "the bars of both cost and error give; \"at most\": the cheapest run errs less. "
      "Extrapolated along the fitted slope at most to half the smallest error. Slope: of ln error "
      "over ln cost. Of costs measured beside other runs, once, no scatter is known and none is "
      "counted. Measured on {}.",
      made_on(assessment, families));
  return table;
}

std::string speed_text(const SpeedUp& found) {
  if (std::isnan(found.value)) return "not reached";
  const std::string text = with_range(found.value, found.spread, "times");
  return found.reach == Reach::by_cheapest ? "at least " + text : text;
}

Table speed_table(const std::vector<WorkFamily>& families) {
  Table table{"",
              "Speed against interFoam at the same error",
              "The core-seconds of each mesh of interFoam's Pareto front over those that the "
              "mesh's error costs the method, each against its own reference; 95 % intervals of "
              "all bars, as if the errors of both were independent.",
              {"method"},
              {}};
  for (const WorkFamily& family : families) {
    const std::vector<SpeedUp> found = speed_ups(family, families);
    if (found.empty()) continue;
    if (table.header.size() == 1)
      for (const SpeedUp& one : found)
        table.header.push_back(fmt::format("at {} of {}", percent(one.error), one.mesh_run));
    std::vector<std::string> row{family.name};
    for (const SpeedUp& one : found) row.push_back(speed_text(one));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

const std::vector<double>& told_errors() {
  static const std::vector<double> errors{0.1, 0.05, 0.02, 0.01};
  return errors;
}

std::vector<WorkFamily> told_families(const CaseAssessment& assessment) {
  std::vector<WorkFamily> families = work_families(assessment);
  std::erase_if(families, [](const WorkFamily& family) {
    return family.changed && !work_slope(by_core_seconds(family));
  });
  return families;
}

namespace {

// How far the cost moves, as a logarithm, while the error that is asked for moves within its bar; a
// side that is not reached counts for nothing.
double moved_by_error(const std::vector<WorkPoint>& own, double cost, const Estimate& error) {
  double most = 0;
  for (const double side : {-1.0, 1.0}) {
    const double other = error.value * std::exp(side * error.half_width / error.value);
    most = std::fmax(most, std::abs(std::log(cost_at_error(own, other).cost / cost)));
  }
  return most;
}

}  // namespace

std::vector<SpeedUp> speed_ups(const WorkFamily& family, const std::vector<WorkFamily>& families) {
  const auto mesh = std::find_if(families.begin(), families.end(),
                                 [](const WorkFamily& one) { return one.name == mesh_family; });
  if (mesh == families.end() || family.name == mesh_family) return {};
  std::vector<SpeedUp> found;
  for (const WorkPoint& point : pareto_front(by_core_seconds(*mesh))) {
    const std::vector<WorkPoint> points = by_core_seconds(family);
    const CostAtError own = cost_at_error(points, point.error.value);
    const double of_mesh = point.cost.half_width / point.cost.value;
    found.push_back({point.error.value, point.run, point.cost.value / own.cost,
                     std::hypot(known_spread(own), std::isnan(of_mesh) ? 0 : of_mesh,
                                moved_by_error(points, own.cost, point.error)),
                     own.reach});
  }
  return found;
}

std::vector<Table> work_precision_tables(const CaseAssessment& assessment) {
  const std::vector<WorkFamily> families = told_families(assessment);
  if (families.empty()) return {};
  const std::string& name = assessment.definition.name;
  std::vector<Table> tables{cost_at_errors(assessment, families, time_column),
                            cost_at_errors(assessment, families, memory_column),
                            speed_table(families)};
  tables[0].id = name + "-cost-to-reach";
  tables[0].title = "Run time to reach an error [core-seconds]";
  tables[1].id = name + "-memory-to-reach";
  tables[1].title = "Memory to reach an error [MiB]";
  tables[2].id = name + "-speed";
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace slosh
