// The evidence that the gate rows of a case are judged by: comparisons of its runs over the case's
// window, each computed once and cached.
#pragma once

#include <fmt/format.h>

#include <array>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/input_uncertainty.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// The forcing, where the motion has one, and the first `count` natural modes (quantities.hpp).
std::vector<ToneRequest> modes_of(const CaseDefinition& definition, int count);

// Those of them that the case's comparisons fit.
std::vector<ToneRequest> fitted_modes(const CaseDefinition& definition);

// Role, run, quantity, window's begin and end, number of modes: a series is prepared once for all
// its comparisons.
using PreparedKey = std::tuple<std::string, std::string, std::string, double, double, std::size_t>;

// A series as it is, or moved by a share of its distance from the one with the suffix that its run
// leaves beside it.
struct Moved {
  std::string suffix = {};
  double share = 0;

  std::string text() const { return share == 0 ? "" : fmt::format("{}/{}", suffix, share); }
};

struct FittedComparisons {
  // By candidate, reference and the reference's quantity, moved or not.
  std::map<std::array<std::string, 3>, Comparison> of;
  std::map<PreparedKey, std::shared_ptr<const PreparedSeries>> series;
  // input_effects() by row_name(), but for those that depend on the candidate's own series.
  std::map<std::string, std::vector<InputEffect>> input;
};

// The part of a comparison's modes that is computed; by default all of it.
struct NeededModes {
  Detail detail = Detail::fitted_tones;
  std::set<std::string> names = {};  // empty: all modes
  // Of a series in the candidate's place: what it has beside a mode, as at another period of the
  // motion, belongs to the metric. The row's own pair has been asked whether its modes are apart.
  bool with_what_is_beside = false;
};

NeededModes modes_needed_by(const std::vector<GateRow>& rows);

class CaseEvidence {
 public:
  // All arguments must outlive this object. `known` holds comparisons of these runs that need not
  // be computed again; it may be nullptr.
  CaseEvidence(const CaseDefinition& definition, const CaseRuns& runs,
               const FittedComparisons* known = nullptr, NeededModes needed = {});

  // Throws ComparisonError or ResultError where the two runs cannot be compared.
  const Comparison& comparison(const std::string& candidate, const std::string& reference,
                               const std::string& quantity);

  // The evidence of the row's own time: this object, or where the row is judged over another time
  // than the case's window (judged_time()) one that it holds.
  CaseEvidence& over_time_of(const GateRow& row);

  // The functions refer to this object, whose window they cut series to.
  GateEvidence gate_evidence();

  // Measures a row with a series in the place of a run's; it refers to this object.
  MeasureWithSeries measure_with_series() const;

  GateOutcome judge(const GateRow& row);

  // Hands over all that was computed here.
  FittedComparisons release_fitted() { return std::exchange(fitted_, {}); }

 private:
  const CaseDefinition& definition_;
  const CaseRuns& runs_;
  const FittedComparisons* known_;
  NeededModes needed_;
  std::vector<ToneRequest> modes_;
  FittedComparisons fitted_;
  std::map<std::string, Estimate> of_repeats_ = {};  // by row; before any correction
  std::set<std::string> read_ = {};                  // the runs that the row being judged has read
  // Evidence over other times than the case's window, of cases whose window that time is.
  std::map<std::pair<double, double>, std::shared_ptr<CaseEvidence>> other_times_ = {};
  std::list<CaseDefinition> other_definitions_ = {};

  // Compares with the reference's series, moved or not.
  const Comparison& comparison_with(const std::string& candidate, const std::string& reference,
                                    const std::string& quantity, const Moved& moved);
  Comparison compared(const std::string& candidate, const std::string& reference,
                      const std::string& quantity, const Moved& moved);
  std::vector<InputEffect> effects_of_inputs(const GateRow& row);
  Contribution input_contribution(const GateRow& row, double value);
  RowDoubts doubts_of_runs(const GateRow& row, const std::set<std::string>& rests_on);
  const Estimate& of_repeats(const std::vector<std::string>& members, const GateRow& row);
  Estimate corrected_p_value(const std::vector<std::string>& members, const GateRow& row);
  const PreparedSeries& prepared(const std::string& role, const std::string& run,
                                 const std::string& quantity, const Moved& moved, TimeWindow window,
                                 const std::vector<ToneRequest>& modes);
};

}  // namespace slosh
