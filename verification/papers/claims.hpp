// A paper's claims, each decided by what this harness found: confirmed, refuted or not decidable.
// A claim rests on findings. One finding against it refutes it. Otherwise it is undecided where a
// finding is undecided: a run is absent or failed, a number is NaN, or its interval reaches over
// the threshold. The claims and their thresholds are rows of li2010_claims.cpp and
// zhao2021_claims.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/fits/harmonic_fit.hpp"
#include "verification/papers/paper_figures.hpp"

namespace slosh {

enum class Held { yes, no, undecided };

enum class Relation {
  within,        // from lower to upper
  at_least,      // holds from upper on, is refuted up to lower, undecided in between
  at_most,       // up to upper
  within_factor  // from 1 / upper to upper
};

struct Threshold {
  Relation relation;
  double lower, upper;
};
inline Threshold within_range(double lower, double upper) {
  return {Relation::within, lower, upper};
}
inline Threshold at_least_between(double refuted, double confirmed) {
  return {Relation::at_least, refuted, confirmed};
}
inline Threshold at_most(double upper) { return {Relation::at_most, -upper, upper}; }
inline Threshold within_factor(double factor) {
  return {Relation::within_factor, 1 / factor, factor};
}

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
};

// Throws std::runtime_error where a run, a series or a number is missing: then the finding is
// undecided.
using Find = std::function<Finding()>;

struct Claim {
  std::string number = {};                // "C5.1", "Z11.2", "conclusion 3": the paper's
  std::string statement = {};             // in our words
  std::string printed = {};               // the paper's own numbers, if it has any
  std::vector<std::string> figures = {};  // the paper's, that show it
  std::vector<std::string> runs = {};     // that decide it: "li2010_large_b125: li2010_20mm"
  std::vector<Find> findings = {};
  std::string not_decidable = {};  // why no run can decide it; there are no findings then
};

struct DecidedClaim {
  Claim claim;
  Held held;
  std::string found;  // all findings that have a number
  std::string why;    // of a claim that is not confirmed: what speaks against it or is missing
};

// "confirmed", "refuted", "not decidable"
std::string verdict_of(Held held);

DecidedClaim decide(const Claim& claim);

// How a finding shows its number: "first natural frequency", 100, "%".
struct Shown {
  std::string name;
  double scale;
  std::string unit;
};

// The number with its 95 % interval, its threshold, and whether it meets it.
Finding judged(const Shown& shown, const Estimate& estimate, const Threshold& threshold);

// A row for each claim, with a link to the first of its figures that is redrawn.
reports::Table claims_table(const std::string& id, const std::vector<Claim>& claims,
                            const RedrawnFigures& redrawn);

}  // namespace slosh
