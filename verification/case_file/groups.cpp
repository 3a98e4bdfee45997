#include <fmt/format.h>

#include <algorithm>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

// The keys at which a row takes its bound. In a group they stand in `limits`.
const std::vector<std::string> keys_of_bounds{"metric", "limit",       "lower",
                                              "upper",  "improves_on", "error"};

void refuse_beside(const TomlTable& group, const std::string& key, const std::string& other) {
  if (group.has(key) && group.has(other))
    group.refuse(key, fmt::format("no such key beside {}", other));
}

// The names that the patterns match, in the order of the patterns, each once. Without patterns
// there is one row, whose subject is the group's own.
std::vector<std::string> listed_subjects(const TomlTable& group, const RowSubjects& subjects) {
  if (!group.has(subjects.key_of_several)) return {""};
  refuse_beside(group, subjects.key, subjects.key_of_several);
  const Rule<std::string> known{
      one_of_text(subjects.what + " or a pattern of them", subjects.names),
      [&](const std::string& pattern) {
        return std::any_of(subjects.names.begin(), subjects.names.end(),
                           [&](const std::string& name) { return matches_pattern(pattern, name); });
      }};
  std::vector<std::string> listed;
  for (const PlacedText& pattern : group.texts(subjects.key_of_several, known))
    for (const std::string& name : subjects.names)
      if (matches_pattern(pattern.text, name) && !contains(listed, name)) listed.push_back(name);
  if (listed.empty()) group.refuse(subjects.key_of_several, known.expected);
  return listed;
}

// "" stands for the mode that the group itself names, or for none.
std::vector<std::string> listed_modes(const TomlTable& group) {
  if (!group.has("modes")) return {""};
  refuse_beside(group, "mode", "modes");
  std::vector<std::string> listed;
  for (const PlacedText& mode : group.texts("modes", any_text())) listed.push_back(mode.text);
  if (listed.empty()) group.refuse("modes", "at least one mode");
  return listed;
}

// A key of the metric alone takes the place of the group's.
TomlTable row_of_metric(const TomlTable& row, const TomlTable& limits, const std::string& metric,
                        const std::vector<std::string>& own_keys) {
  const TomlTable named = row.with("metric", metric).placed_at(limits, metric);
  if (!limits.has_table(metric)) return named.with("limit", limits, metric);
  const TomlTable own = limits.table(metric);
  own.allow_only(own_keys);
  TomlTable merged = named;
  for (const std::string& key : own.keys()) merged = merged.with(key, own, key);
  return merged;
}

// Returns the row once for each metric of `limits`, and as it is where there are none.
std::vector<TomlTable> by_metric(const TomlTable& row, const TomlTable& group,
                                 const RowSubjects& subjects) {
  if (!group.has("limits")) return {row};
  for (const std::string& key : keys_of_bounds) refuse_beside(group, key, "limits");
  const TomlTable limits = group.table("limits");
  limits.allow_only(subjects.metrics);
  std::vector<std::string> own_keys;
  for (const std::string& key : keys_of(subjects.table))
    if (!contains({"metric", "limits", "modes", subjects.key, subjects.key_of_several}, key))
      own_keys.push_back(key);
  std::vector<TomlTable> rows;
  for (const std::string& metric : limits.keys())
    rows.push_back(row_of_metric(row, limits, metric, own_keys));
  if (rows.empty()) group.refuse("limits", "at least one metric with its limit");
  return rows;
}

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

std::vector<TomlTable> rows_of_group(const TomlTable& group, const RowSubjects& subjects) {
  group.allow_only(keys_of(subjects.table));
  const TomlTable common = group.without({subjects.key_of_several, "modes", "limits"});
  std::vector<TomlTable> rows;
  for (const std::string& subject : listed_subjects(group, subjects))
    for (const std::string& mode : listed_modes(group)) {
      TomlTable row = common;
      if (!subject.empty()) row = row.with(subjects.key, subject);
      if (!mode.empty()) row = row.with("mode", mode);
      for (const TomlTable& one : by_metric(row, group, subjects)) rows.push_back(one);
    }
  return rows;
}

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
