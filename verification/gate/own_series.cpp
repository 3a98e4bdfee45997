#include "verification/gate/own_series.hpp"

#include <fmt/format.h>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/measured_value.hpp"

namespace slosh {
namespace {

struct MemberPeak {
  std::string run;
  TimeSeries series;
  Peak peak{-1, not_a_number};
};

MemberPeak highest_member(const GateRow& row, const GateEvidence& evidence) {
  MemberPeak highest;
  for (const std::string& run : ensemble_of(row.candidate, evidence).members) {
    TimeSeries series = evidence.series(run, row.quantity);
    if (const Peak one = largest_of(series); one.magnitude > highest.peak.magnitude)
      highest = {run, std::move(series), one};
  }
  return highest;
}

std::string larger_outside(TimeSeries whole, const MemberPeak& within, const std::string& unit) {
  for (std::size_t i = 0; i < whole.time.size(); ++i)
    if (whole.time[i] >= within.series.time.front() && whole.time[i] <= within.series.time.back())
      whole.value[i] = 0;
  const Peak other = largest_of(whole);
  if (!(other.magnitude > within.peak.magnitude)) return "";
  return fmt::format("; LARGER outside of that time: {} at {:.4g} s",
                     in_unit(other.magnitude, unit), other.time);
}

std::string place_text(const GateRow& row, const GateEvidence& evidence) {
  const MemberPeak found = highest_member(row, evidence);
  if (found.run.empty()) return "";  // NaN
  std::string text = fmt::format(
      "; {}at {:.4g} s of {:.4g} to {:.4g} s",
      is_of_ensembles(row, evidence)
          ? fmt::format("the highest member has {} ", in_unit(found.peak.magnitude, row.unit))
          : "",
      found.peak.time, found.series.time.front(), found.series.time.back());
  if (evidence.history)
    text += larger_outside(evidence.history(found.run, row.quantity), found, row.unit);
  return text;
}

}  // namespace

std::string peak_text(const GateRow& row, const GateEvidence& evidence) {
  const bool is_largest = row.metric == Metric::largest_magnitude;
  const bool is_peak = row.metric == Metric::impact_peak_error ||
                       row.metric == Metric::impulse_error ||
                       (is_largest && find_quantity(row.quantity) != nullptr);
  std::string text = is_largest ? place_text(row, evidence) : "";
  const EnsembleOfRun runs = ensemble_of(row.candidate, evidence);
  if (is_peak && !runs.exact && runs.members.size() == 1)
    text += fmt::format("; single run: `repeats` of {} tell how its peaks scatter", row.candidate);
  return text;
}

}  // namespace slosh
