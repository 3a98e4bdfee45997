#include "verification/results/timings.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/sealed_json.hpp"

namespace slosh {
namespace {

using nlohmann::json;

constexpr const char* timings_format = "slosh timings";

json entry_of(const Timing& timing) {
  const RunCost& cost = timing.cost;
  return {{"wall_time_s", cost.wall_time},
          {"user_time_s", cost.user_time},
          {"system_time_s", cost.system_time},
          {"peak_memory_byte", cost.peak_memory},
          {"steps", cost.steps},
          {"elements", cost.elements},
          {"processor", timing.processor},
          {"date_utc", timing.date}};
}

Timing timing_of(const json& entry) {
  return {{.wall_time = entry.at("wall_time_s"),
           .user_time = entry.at("user_time_s"),
           .system_time = entry.at("system_time_s"),
           .peak_memory = entry.at("peak_memory_byte"),
           .steps = entry.at("steps"),
           .elements = entry.at("elements")},
          entry.at("processor"),
          entry.at("date_utc")};
}

}  // namespace

std::vector<Timing> read_timings(const std::filesystem::path& file) {
  std::vector<Timing> timings;
  try {
    const json body = read_sealed_json(timings_format, file);
    for (const json& entry : body.at("timings")) timings.push_back(timing_of(entry));
  } catch (const ResultError&) {
    timings.clear();
  } catch (const json::exception&) {
    timings.clear();
  }
  return timings;
}

void add_timing(const Timing& timing, const std::filesystem::path& file) {
  json entries = json::array();
  for (const Timing& one : read_timings(file)) entries.push_back(entry_of(one));
  entries.push_back(entry_of(timing));
  write_sealed_json({{"format", timings_format}, {"timings", entries}}, file);
}

std::vector<RunCost> comparable_costs(const std::vector<Timing>& timings) {
  std::vector<RunCost> costs;
  for (const Timing& one : timings)
    if (one.processor == timings.back().processor) costs.push_back(one.cost);
  return costs;
}

}  // namespace slosh
