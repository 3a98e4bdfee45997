// The time over which a gate row is judged.
#pragma once

#include <tuple>
#include <utility>

#include "verification/case/case_definition.hpp"
#include "verification/case/metric_table.hpp"

namespace slosh {

// [s]: the row's part of the run, or else of a series of the candidate alone the whole run and of
// any other metric the comparison's window.
inline std::pair<double, double> judged_time(const GateRow& row, const CaseDefinition& definition) {
  if (row.part) return *row.part;
  if (metric_entry(row.metric).measured_on == MeasuredOn::own_series)
    return {0, definition.duration};
  return {definition.window_begin, definition.window_end};
}

// The case with that time as the comparison's window.
inline CaseDefinition judged_over(const GateRow& row, CaseDefinition definition) {
  std::tie(definition.window_begin, definition.window_end) = judged_time(row, definition);
  return definition;
}

}  // namespace slosh
