// What each method needs for a given error, in run time and memory: as tables, and as JSON of
// families[] with runs[], slopes, and the cost of the stated errors.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/assessment/work_points.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;
using Json = nlohmann::ordered_json;

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

// Returns "11.2 s (8.1 to 15.5)".
std::string with_range(double value, double spread, const std::string& unit) {
  std::string text = fmt::format("{:.3g} {}", value, unit);
  if (!(spread > 0)) return text;
  return fmt::format("{} ({:.3g} to {:.3g})", text, value * std::exp(-spread),
                     value * std::exp(spread));
}

// A kind of cost: the id and the title of its table, the unit there, and the key of the JSON.
struct CostKind {
  std::vector<WorkPoint> (*points)(const WorkFamily&);
  std::string id, title;
  double scale;
  std::string unit, key;
};

const CostKind run_time{
    by_core_seconds, "cost-to-reach", "Run time to reach an error [core-seconds]", 1, "s",
    "core_seconds_s"};
const CostKind memory{by_memory, "memory-to-reach", "Memory to reach an error [MiB]", 1.0 / 1048576,
                      "MiB",     "peak_memory_byte"};

std::string reached_text(const CostAtError& found, const CostKind& kind) {
  std::string text = with_range(kind.scale * found.cost, known_spread(found), kind.unit);
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
                     kind.scale * found.most_exact->cost.value, kind.unit);
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
      const bool is_stored = origin.contains("stored_software");
      const std::string place = value_of(is_stored ? "stored_machine" : "processor");
      places.insert(is_stored || origin.contains("external_command")
                        ? fmt::format("{}; {}", place, software_text(origin))
                        : fmt::format("{}; compiler {}, flags {}", place, value_of("compiler"),
                                      value_of("compiler_flags")));
    }
  return fmt::format("{}", fmt::join(places, " | "));
}

Table cost_at_errors(const CaseAssessment& assessment, const std::vector<WorkFamily>& families,
                     const CostKind& kind) {
  Table table = case_table(
      assessment.definition, kind.id, kind.title,
      fmt::format(
          "Interpolated between the runs on the method's own Pareto front; in brackets the 95 % "
          "interval from those of cost and error. \"at most\": the cheapest run already has a "
          "smaller error. \"extrapolated\": along the fitted slope, at most to half the smallest "
          "error. Slope: that of ln(error) over ln(cost). The scatter of costs that were measured "
          "once, while other runs were running, is unknown and not included. Measured on {}.",
          made_on(assessment, families)),
      {"method", "reference", "measured", "runs", "slope"});
  for (const double error : stated_errors()) table.header.push_back(percent(error));
  for (const WorkFamily& family : families) {
    const std::vector<WorkPoint> points = kind.points(family);
    if (points.empty()) continue;
    const auto slope = work_slope(points);
    TableRow row{family.name, family.reference, timed_text(family),
                 fmt::format("{}", family.runs.size()), slope ? slope_text(*slope) : ""};
    for (const double error : stated_errors())
      row.push_back(reached_text(cost_at_error_or_beyond(points, error), kind));
    table.rows.push_back(std::move(row));
  }
  return table;
}

const char* reach_name(Reach reach) {
  switch (reach) {
    case Reach::not_at_all:
      return "not reached";
    case Reach::by_cheapest:
      return "at most";
    case Reach::between:
      return "interpolated";
    case Reach::extrapolated:
      return "extrapolated";
  }
  throw std::logic_error("a reach without a name");
}

// The key of the cost includes its unit.
Json costs_at_errors(const WorkFamily& family, const CostKind& kind) {
  Json list = Json::array();
  for (const double error : stated_errors()) {
    const CostAtError found = cost_at_error_or_beyond(kind.points(family), error);
    list.push_back({{"error", error},
                    {"reach", reach_name(found.reach)},
                    {kind.key, found.cost},
                    {"relative_half_width_95_of_costs", found.cost_spread},
                    {"relative_half_width_95_of_errors", found.error_spread}});
  }
  return list;
}

Json slope_of(const WorkFamily& family, const CostKind& kind) {
  const auto slope = work_slope(kind.points(family));
  return slope ? estimate_json(*slope) : Json(nullptr);
}

}  // namespace

std::vector<Table> work_precision_tables(const CaseAssessment& assessment) {
  const std::vector<WorkFamily> families = stated_families(assessment);
  if (families.empty()) return {};
  return {cost_at_errors(assessment, families, run_time),
          cost_at_errors(assessment, families, memory)};
}

Json work_precision_json(const CaseAssessment& assessment) {
  const std::vector<EqualErrorSpeed> speeds = equal_error_speeds(assessment);
  Json list = Json::array();
  for (const WorkFamily& family : work_families(assessment)) {
    Json runs = Json::array(), speed_ups = Json::array();
    for (const WorkRun& run : family.runs)
      runs.push_back({{"run", run.run},
                      {"timings", run.cost.timings},
                      {"core_seconds_s", estimate_json(run.cost.core_seconds)},
                      {"peak_memory_byte", estimate_json(run.cost.memory)},
                      {"normalised_rms", estimate_json(run.error)}});
    for (const EqualErrorSpeed& found : speeds)
      if (found.family == family.name)
        speed_ups.push_back({{"error", found.error},
                             {"speed_up", found.value},
                             {"half_width_95_of_logarithm", found.spread},
                             {"costs_are_repeated", found.is_repeated}});
    list.push_back({{"family", family.name},
                    {"reference", family.reference},
                    {"runs", runs},
                    {"slope_over_core_seconds", slope_of(family, run_time)},
                    {"slope_over_memory", slope_of(family, memory)},
                    {"core_seconds_to_reach", costs_at_errors(family, run_time)},
                    {"memory_to_reach", costs_at_errors(family, memory)},
                    {"speed_against_interfoam", speed_ups}});
  }
  return list;
}

}  // namespace slosh
