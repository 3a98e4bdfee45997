// A paper's claims, each decided by what this harness found: confirmed, refuted or not decidable.
// A claim stands on findings. One that speaks against it refutes it; otherwise one that cannot be
// told, because a run is absent or failed, a number is none or its interval reaches over the
// threshold, leaves it undecided. The thresholds stand in claim_thresholds.hpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/fits/harmonic_fit.hpp"

namespace slosh {

enum class Held { yes, no, undecided };

struct Finding {
  Held held;
  std::string text;  // the number, its threshold, and whose it is; or what is missing
};

// Throws what a missing run, series or number throws (std::runtime_error): then it cannot be told.
using Find = std::function<Finding()>;

struct Claim {
  std::string statement;  // in our words
  std::vector<Find> findings;
};

struct DecidedClaim {
  std::string statement;
  Held held;
  std::string found;  // all that was found
  std::string why;    // of a claim that is not confirmed: what speaks against it or cannot be told
};

DecidedClaim decide(const Claim& claim);

// How a finding is shown: "first natural frequency", 100, "%".
struct Shown {
  std::string name;
  double scale;
  std::string unit;
};

// Whether a value with its 95 % interval lies from lower to upper; undecided where the interval
// reaches over either, and of NaN.
Finding within(const Shown& shown, const Estimate& estimate, double lower, double upper);

// Whether a value is at least so large, or clearly is not: undecided from `refuted` to `confirmed`,
// and of NaN.
Held at_least(double value, double refuted, double confirmed);

reports::Table claims_table(const std::string& id, const std::vector<Claim>& claims);

}  // namespace slosh
