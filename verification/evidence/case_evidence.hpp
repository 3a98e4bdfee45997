// What the gate rows of a case are judged by: comparisons of its runs over the case's window, each
// computed once.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// The forcing, where the motion has one, and the first `count` natural modes (natural_modes.hpp).
std::vector<ToneRequest> modes_of(const CaseDefinition& definition, int count);

// Of these, the ones that the case's comparisons fit.
std::vector<ToneRequest> fitted_modes(const CaseDefinition& definition);

// The case's, or what a record covers of it: a candidate must cover it all.
TimeWindow compared_window(const CaseDefinition& definition, const std::string& reference);

// By role, run, quantity, window and number of modes: a series is prepared once for all that it is
// compared with.
using PreparedKey = std::tuple<std::string, std::string, std::string, double, double, std::size_t>;

struct FittedComparisons {
  // By candidate, reference and the reference's quantity.
  std::map<std::array<std::string, 3>, Comparison> of;
  std::map<PreparedKey, std::shared_ptr<const PreparedSeries>> series;
  // By row_name(): input_uncertainty(), in which the candidate's own series has no part.
  std::map<std::string, Contribution> input;
};

// What is asked of a comparison's modes; by default all.
struct AskedOfModes {
  Detail detail = Detail::fitted_tones;
  std::set<std::string> names = {};  // empty: of all
};

// By these rows alone.
AskedOfModes asked_by(const std::vector<GateRow>& rows);

class CaseEvidence {
 public:
  // All stay the caller's and outlive this; `known` are comparisons of these runs, null for none.
  CaseEvidence(const CaseDefinition& definition, const CaseRuns& runs,
               const FittedComparisons* known = nullptr, AskedOfModes asked = {});

  // Throws ComparisonError or ResultError where there is none.
  const Comparison& comparison(const std::string& candidate, const std::string& reference,
                               const std::string& quantity);

  // Refers to this.
  GateEvidence gate_evidence();

  GateOutcome judge(const GateRow& row);

  // What was computed here; this has none of it any more.
  FittedComparisons release_fitted() { return std::exchange(fitted_, {}); }

 private:
  const CaseDefinition& definition_;
  const CaseRuns& runs_;
  const FittedComparisons* known_;
  AskedOfModes asked_;
  std::vector<ToneRequest> modes_;
  FittedComparisons fitted_;

  // Of a reference that leaves the quantity twice, the one under this ending.
  const Comparison& comparison_with(const std::string& candidate, const std::string& reference,
                                    const std::string& quantity, const std::string& ending);
  Comparison compared(const std::string& candidate, const std::string& reference,
                      const std::string& quantity, const std::string& ending);
  const Contribution& input_contribution(const GateRow& row);
  const PreparedSeries& prepared(const std::string& role, const std::string& run,
                                 const std::string& quantity, TimeWindow window,
                                 const std::vector<ToneRequest>& modes);
};

}  // namespace slosh
