// Error against cost as JSON: families[] with runs[], slopes, and the cost of the stated errors.
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/summary/results_json.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/assessment/work_points.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;

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
Json costs_at_errors(const std::vector<WorkPoint>& points, const char* cost) {
  Json list = Json::array();
  for (const double error : stated_errors()) {
    const CostAtError found = cost_at_error_or_beyond(points, error);
    list.push_back({{"error", error},
                    {"reach", reach_name(found.reach)},
                    {cost, found.cost},
                    {"relative_half_width_95_of_costs", found.cost_spread},
                    {"relative_half_width_95_of_errors", found.error_spread}});
  }
  return list;
}

Json slope_of(const std::vector<WorkPoint>& points) {
  const auto slope = work_slope(points);
  return slope ? estimate_json(*slope) : Json(nullptr);
}

Json run_entry(const WorkRun& run) {
  return {{"run", run.run},
          {"timings", run.cost.timings},
          {"core_seconds_s", estimate_json(run.cost.core_seconds)},
          {"peak_memory_byte", estimate_json(run.cost.memory)},
          {"normalised_rms", estimate_json(run.error)}};
}

Json speed_up_entry(const EqualErrorSpeed& found) {
  return {{"error", found.error},
          {"speed_up", found.value},
          {"half_width_95_of_logarithm", found.spread},
          {"costs_are_repeated", found.is_repeated}};
}

}  // namespace

Json estimate_json(const Estimate& value) {
  return {{"value", value.value}, {"half_width_95", value.half_width}};
}

Json work_precision_json(const CaseAssessment& assessment) {
  const std::vector<WorkFamily> families = work_families(assessment);
  const std::vector<EqualErrorSpeed> speeds = equal_error_speeds(assessment);
  Json list = Json::array();
  for (const WorkFamily& family : families) {
    const std::vector<WorkPoint> times = by_core_seconds(family), memories = by_memory(family);
    Json entry{{"family", family.name},
               {"reference", family.reference},
               {"runs", Json::array()},
               {"slope_over_core_seconds", slope_of(times)},
               {"slope_over_memory", slope_of(memories)},
               {"core_seconds_to_reach", costs_at_errors(times, "core_seconds_s")},
               {"memory_to_reach", costs_at_errors(memories, "peak_memory_byte")},
               {"speed_against_interfoam", Json::array()}};
    for (const WorkRun& run : family.runs) entry["runs"].push_back(run_entry(run));
    for (const EqualErrorSpeed& found : speeds)
      if (found.family == family.name)
        entry["speed_against_interfoam"].push_back(speed_up_entry(found));
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace slosh
