// A paper's claims, each decided by what this harness found: confirmed, refuted or not decidable.
// One finding against a claim refutes it. Otherwise it is undecided where a finding is: a run is
// absent or failed, a number is NaN, or its interval reaches over the threshold.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/paper.hpp"

namespace slosh {

enum class Held { yes, no, undecided };

// "confirmed", "refuted", "not decidable"
std::string verdict_of(Held held);

// Whether a value with its 95 % interval meets the threshold: undecided where the interval reaches
// over an end, and for NaN.
Held compare(const Estimate& estimate, const Threshold& threshold);
inline Held compare(double value, const Threshold& threshold) {
  return compare(Estimate{value, 0}, threshold);
}

// The claim of both parts together.
Held both(Held one, Held other);

struct Finding {
  Held held;
  std::string text;  // the number, its threshold, and the run; or what is missing
  bool is_missing = false;
};

// How a finding shows its number: "first natural frequency", 100, "%".
struct Shown {
  std::string name;
  double scale;
  std::string unit;
};

// The number with its 95 % interval, its threshold, and whether it meets it.
Finding judged(const Shown& shown, const Estimate& estimate, const Threshold& threshold);

// What a finding is evaluated on: the row and its first and last case.
struct Question {
  const CaseAssessment &first, &last;
  const FindingRow& row;

  const CaseDefinition& definition() const { return first.definition; }
  const std::string& run(std::size_t i) const { return row.runs.at(i); }
  // Of the first case. Throws std::runtime_error where the run has none.
  const RunResult& result(std::size_t i) const;
  const Threshold& threshold(std::size_t i = 0) const { return row.thresholds.at(i); }
  // judged() against the first threshold; the name has {0} for the first run, {1} for the second.
  Finding judge(const std::string& name, double scale, const std::string& unit,
                const Estimate& estimate) const;
};

// The functions by the names that rows have for them. They throw std::runtime_error where a run, a
// series or a number is missing.
using Evidence = Finding (*)(const Question& question);
const std::map<std::string, Evidence>& wave_findings();
const std::map<std::string, Evidence>& pressure_findings();

struct DecidedClaim {
  Claim claim;
  std::vector<std::string> runs;  // that decide it: "li2010_large_b125: li2010_20mm"
  Held held;
  std::string found;  // all findings that have a number
  std::string why;    // of a claim that is not confirmed: what speaks against it or is missing
};

DecidedClaim decided(const Claim& claim, const std::vector<Finding>& findings);

// The claims of a paper on these results. Throws std::out_of_range where a row names no function.
std::vector<DecidedClaim> decided_claims(const Paper& paper,
                                         const std::vector<CaseAssessment>& cases);

}  // namespace slosh
