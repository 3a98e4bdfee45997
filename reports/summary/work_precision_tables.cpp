// What each method needs for a given error, in run time and memory.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "reports/summary/report_sections.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

// Returns "11.2 s (8.1 to 15.5)".
std::string with_range(double value, double spread, const std::string& unit) {
  std::string text = fmt::format("{:.3g} {}", value, unit);
  if (!(spread > 0)) return text;
  return fmt::format("{} ({:.3g} to {:.3g})", text, value * std::exp(-spread),
                     value * std::exp(spread));
}

// A kind of cost and its unit in a table.
struct CostColumn {
  std::vector<WorkPoint> (*points)(const WorkFamily&);
  double scale;
  std::string unit;
};

const CostColumn time_column{by_core_seconds, 1, "s"};
const CostColumn memory_column{by_memory, 1.0 / 1048576, "MiB"};

std::string reached_text(const CostAtError& found, const CostColumn& column) {
  std::string text = with_range(column.scale * found.cost, known_spread(found), column.unit);
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

std::string slope_cell(const WorkFamily& family, const CostColumn& column) {
  const auto slope = work_slope(column.points(family));
  return slope ? slope_text(*slope) : "";
}

// Returns how the costs of a family were measured: "alone, 5 to 6 times", ...
std::string timed_text(const WorkFamily& family) {
  std::size_t timed = 0, fewest = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const WorkRun& run : family.runs) {
    if (run.cost.timings == 0) continue;
    ++timed;
    fewest = std::min(fewest, run.cost.timings);
    most = std::max(most, run.cost.timings);
  }
  if (std::all_of(family.runs.begin(), family.runs.end(),
                  [](const WorkRun& run) { return run.cost.elsewhere; }))
    return "once, on another machine";
  if (timed == 0) return "once, while other runs were running";
  const std::string times = fewest == most ? fmt::format("alone, {} times", most)
                                           : fmt::format("alone, {} to {} times", fewest, most);
  return timed == family.runs.size()
             ? times
             : fmt::format("{} of {} runs {}; the others while other runs were running", timed,
                           family.runs.size(), times);
}

// Returns the processors, compilers and flags of all runs, each once.
std::string made_on(const CaseAssessment& assessment, const std::vector<WorkFamily>& families) {
  std::set<std::string> places;
  for (const WorkFamily& family : families)
    for (const WorkRun& run : family.runs) {
      const auto& origin = assessment.runs.results.at(run.run).provenance;
      const auto value_of = [&](const char* key) {
        const auto found = origin.find(key);
        return found == origin.end() || found->second.empty() ? "unknown" : found->second;
      };
      if (origin.contains("stored_software")) {
        places.insert(fmt::format("{}; {}", value_of("stored_machine"), software_text(origin)));
        continue;
      }
      if (origin.contains("external_command")) {
        places.insert(fmt::format("{}; {}", value_of("processor"), software_text(origin)));
        continue;
      }
      places.insert(fmt::format("{}; compiler {}, flags {}", value_of("processor"),
                                value_of("compiler"), value_of("compiler_flags")));
    }
  return fmt::format("{}", fmt::join(places, " | "));
}

Table cost_at_errors(const CaseAssessment& assessment, const std::vector<WorkFamily>& families,
                     const CostColumn& column) {
  Table table{"", "", "", {"method", "reference", "measured", "runs", "slope"}, {}};
  for (const double error : stated_errors()) table.header.push_back(percent(error));
  for (const WorkFamily& family : families) {
    if (column.points(family).empty()) continue;
    std::vector<std::string> row{family.name, family.reference, timed_text(family),
                                 fmt::format("{}", family.runs.size()), slope_cell(family, column)};
    for (const double error : stated_errors())
      row.push_back(reached_text(cost_at_error_or_beyond(column.points(family), error), column));
    table.rows.push_back(std::move(row));
  }
  table.caption = fmt::format(
      "Interpolated between the runs on the method's own Pareto front; in brackets the 95 % "
      "interval from those of cost and error. \"at most\": the cheapest run already has a smaller "
      "error. \"extrapolated\": along the fitted slope, at most to half the smallest error. Slope: "
      "that of ln(error) over ln(cost). The scatter of costs that were measured once, while other "
      "runs were running, is unknown and not included. Measured on {}.",
      made_on(assessment, families));
  return table;
}

}  // namespace

std::vector<Table> work_precision_tables(const CaseAssessment& assessment) {
  const std::vector<WorkFamily> families = stated_families(assessment);
  if (families.empty()) return {};
  const std::string& name = assessment.definition.name;
  std::vector<Table> tables{cost_at_errors(assessment, families, time_column),
                            cost_at_errors(assessment, families, memory_column)};
  tables[0].id = case_id(name) + "-cost-to-reach";
  tables[0].title = "Run time to reach an error [core-seconds]";
  tables[1].id = case_id(name) + "-memory-to-reach";
  tables[1].title = "Memory to reach an error [MiB]";
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace slosh
