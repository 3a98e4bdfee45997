#include "verification/case_file/groups/run_group.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/case_file/key_table.hpp"
#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

// Lists at these keys are values of one run, or of none.
std::vector<std::string> lists_of_one_run() {
  std::vector<std::string> keys = list_keys_of_runs();
  keys.push_back("quick");
  return keys;
}

std::string in_name(std::string value) {
  std::replace(value.begin(), value.end(), '.', 'p');
  std::replace(value.begin(), value.end(), '+', '_');
  return value;
}

// What stands for "{particle_spacing_m}", "{particle_spacing_mm}" or "{start_seed:02}".
std::string placed_value(const TomlTable& run, const std::string& placeholder) {
  const std::size_t colon = placeholder.find(':');
  const std::string key = placeholder.substr(0, colon);
  const std::string in_metres = key.ends_with("_mm") ? key.substr(0, key.size() - 1) : "";
  if (!in_metres.empty() && run.has(in_metres))
    return millimetres_in_name(run.get(in_metres, any_number("m")));
  if (key == "name" || !run.has(key))
    run.refuse("name", fmt::format("a pattern of this table's keys; there is no {}", key));
  std::string value = in_name(run.written(key));
  if (colon == std::string::npos) return value;
  const std::string digits = placeholder.substr(colon + 1);
  if (digits.size() != 2 || digits[0] != '0' || digits[1] < '1' || digits[1] > '9')
    run.refuse("name", "a number of digits from {KEY:01} to {KEY:09}");
  const auto width = static_cast<std::size_t>(digits[1] - '0');
  value.insert(0, width - std::min(width, value.size()), '0');
  return value;
}

// "{scheme}_{particle_spacing_m}" -> "recommended_0p025"
std::string run_name(const TomlTable& run, const std::string& pattern) {
  std::string name;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t end = pattern.find('}', at);
    if (pattern[at] != '{' || end == std::string::npos) {
      name += pattern[at++];
      continue;
    }
    name += placed_value(run, pattern.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return name;
}

// Sets `quick` for the runs that the list names.
void set_quick(const TomlTable& group, std::vector<TomlTable>& runs) {
  const Rule<std::string> of_group{
      "a name or a pattern of a run of this table", [&](const std::string& pattern) {
        return std::any_of(runs.begin(), runs.end(), [&](const TomlTable& run) {
          return matches_pattern(pattern, run.written("name"));
        });
      }};
  const std::vector<PlacedText> patterns = group.texts("quick", of_group);
  for (TomlTable& run : runs)
    run = run.with_flag("quick",
                        std::any_of(patterns.begin(), patterns.end(), [&](const PlacedText& one) {
                          return matches_pattern(one.text, run.written("name"));
                        }));
}

}  // namespace

std::string millimetres_in_name(double metres) {
  return in_name(fmt::format("{:g}", 1000 * metres));
}

std::vector<TomlTable> runs_of_group(const TomlTable& group) {
  if (group.written("name").find('{') == std::string::npos) return {group};
  std::vector<TomlTable> runs;
  for (const TomlTable& run : group.combinations(lists_of_one_run()))
    runs.push_back(run.with("name", run_name(run, group.get("name", any_text()))));
  if (group.has_list("quick")) set_quick(group, runs);
  return runs;
}

}  // namespace slosh
