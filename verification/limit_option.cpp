#include "verification/limit_option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "verification/case_file/case_file_error.hpp"
#include "verification/case_file/nearest_name.hpp"
#include "verification/case_file/rules.hpp"

namespace slosh {
namespace {

// What a limit may be set on; of those with a mode "forced" unless another is named.
struct JudgedMetric {
  Metric metric;
  bool of_mode;
};
constexpr JudgedMetric judged_metrics[] = {
    {Metric::amplitude_error, true},      {Metric::phase_lag, true},
    {Metric::frequency_error, true},      {Metric::decay_rate, true},
    {Metric::decay_error, true},          {Metric::normalised_rms, false},
    {Metric::maximum_residual, false},    {Metric::time_lag, false},
    {Metric::aligned_rms, false},         {Metric::band_energy_error, true},
    {Metric::spectral_peak_error, false}, {Metric::rms_error, false},
    {Metric::crest_error, false},         {Metric::trough_error, false},
    {Metric::mean_offset, false}};

JudgedMetric metric_named(const std::string& name, const std::string& limit) {
  std::vector<std::string> names;
  for (const JudgedMetric& one : judged_metrics) {
    names.push_back(metric_name(one.metric));
    if (names.back() == name) return one;
  }
  throw CaseFileError(
      fmt::format("--limit {}: expected METRIC=VALUE or MODE:METRIC=VALUE with one "
                  "of {}; nearest: {}",
                  limit, fmt::join(names, ", "), nearest_names(name, names, 1).front()));
}

double positive_number(const std::string& text, const std::string& limit, const std::string& unit) {
  double value = 0;
  std::istringstream stream(text);
  if (!(stream >> value) || !stream.eof() || !(value > 0) || !std::isfinite(value))
    throw CaseFileError(fmt::format("--limit {}: expected a value > 0, {}", limit, in(unit)));
  return value;
}

// "phase_lag=2", "natural_1:frequency_error=0.01".
GateRow row_of(const std::string& limit, const Comparison& comparison) {
  const std::size_t equals = std::min(limit.find('='), limit.size());
  const std::size_t colon = limit.find(':');
  const bool has_mode = colon < equals;
  const std::size_t begin = has_mode ? colon + 1 : 0;
  const JudgedMetric metric = metric_named(limit.substr(begin, equals - begin), limit);
  if (has_mode && !metric.of_mode)
    throw CaseFileError(fmt::format("--limit {}: expected no mode: {} is of the whole window",
                                    limit, metric_name(metric.metric)));
  GateRow row{};
  row.candidate = comparison.candidate;
  row.reference = comparison.reference;
  row.quantity = comparison.quantity;
  row.mode = has_mode ? limit.substr(0, colon) : metric.of_mode ? "forced" : "whole";
  row.metric = metric.metric;
  row.unit = metric_unit(metric.metric, comparison.unit);
  row.limit =
      positive_number(equals < limit.size() ? limit.substr(equals + 1) : "", limit, row.unit);
  return row;
}

GateOutcome judged(const GateRow& row, const Comparison& comparison) {
  const std::map<std::string, RunStatus> runs{{comparison.candidate, {RunState::finished, ""}},
                                              {comparison.reference, {RunState::finished, ""}}};
  const FindComparison find = [&](const std::string&, const std::string&,
                                  const std::string&) -> const Comparison& { return comparison; };
  return evaluate(row, runs, {find, {}});
}

}  // namespace

GateOutcome judged_by_limit(const std::string& limit, const Comparison& comparison) {
  return judged(row_of(limit, comparison), comparison);
}

}  // namespace slosh
