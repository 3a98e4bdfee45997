#include "verification/case_file/groups/row_group.hpp"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace slosh
