// A verdict that knows its own uncertainty, after ASME V&V 20-2009: with the comparison error
// E = S - D (simulation less data; any metric of the gate is one) and its validation uncertainty
//   U_val = sqrt(U_discretisation^2 + U_statistics^2 + U_input^2 + U_reference^2)
// a bound passes where all of E - U_val to E + U_val lies within it, fails where all of it lies
// outside, and is inconclusive where the interval holds the bound. For |E| <= limit: pass where
// |E| + U_val <= limit, fail where |E| - U_val > limit. The first two terms are the standard's
// numerical uncertainty, told apart because they have different remedies. All of them are expanded
// 95 % half widths, as everything in this project is stated, where the standard adds standard
// uncertainties and expands the sum: the same where all have the same coverage factor.
// A contribution that is unknown counts for nothing in U_val; what then may still pass is for the
// row's kind to say (gate.hpp).
// NaN or infinity in E fails, and in a U is inconclusive: neither ever passes.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace slosh {

// Half width of a 95 % interval in the error's unit, not negative; none where it is unknown.
struct Contribution {
  std::optional<double> half_width = 0.0;
  // What it rests on; of an unknown one what is missing, and what would tell it.
  std::string basis = {};

  Contribution() = default;
  Contribution(double known, std::string rests_on = {})
      : half_width(known), basis(std::move(rests_on)) {}
  static Contribution unknown(std::string missing);

  double known() const { return half_width.value_or(0); }  // zero where unknown
};

// Independent of one another.
struct UncertaintyContributions {
  Contribution discretisation = {};  // of step and spacing, discretisation_uncertainty.hpp
  Contribution statistics = {};      // of a finite record, as the metric's confidence interval
  Contribution input = {};      // of what the simulation is told: motion, fill depth, properties
  Contribution reference = {};  // of the data: an experiment's, or another method's own
};

// U_val of the known ones; NaN where one is negative or no number.
double validation_uncertainty(const UncertaintyContributions& contributions);

// What is missing of the numerical uncertainty and of the reference's, joined by "; "; empty where
// both are known. What this names keeps a validation row from passing. The inputs' is not among
// them: an experiment's paper may be silent on it, and no run of ours would tell it.
std::string missing_for_validation(const UncertaintyContributions& contributions);

// "discretisation", "statistics", "input" or "reference": the largest.
std::string dominant_contribution(const UncertaintyContributions& contributions);

// What the error may be; infinite where only one side is bounded. {-limit, limit} for |E| <= limit.
struct AllowedRange {
  double lower, upper;
};

enum class ThreeWayVerdict { pass, fail, inconclusive };

struct ThreeWayOutcome {
  ThreeWayVerdict verdict;
  double error;
  UncertaintyContributions contributions;
  double uncertainty;  // U_val
  // Distance of E to the nearest bound: the verdict is conclusive where U_val is below it. Zero
  // where E lies on a bound, NaN where E is not finite.
  double conclusive_uncertainty;
};

// A range that holds NaN fails.
ThreeWayOutcome judge_error(double error, const UncertaintyContributions& contributions,
                            const AllowedRange& allowed);

// What one contribution must become for an inconclusive outcome to be conclusive, E and the other
// contributions as they are. More work moves E as well: this is the least to plan for.
struct Remedy {
  double half_width;  // that the contribution must fall to
  double factor;      // steps smaller by, or the window longer by
  double cost_ratio;  // of the run to the present one
};

// U_discretisation ~ h^order; the cost grows as h^-3, two dimensions and the time step. None where
// the others alone exceed the conclusive uncertainty, where the outcome is conclusive as it is, and
// where the order is not above zero.
std::optional<Remedy> finer_step(const ThreeWayOutcome& outcome, double order);

// U_statistics ~ 1 / sqrt(window), the cost grows as the window. None as above.
std::optional<Remedy> longer_window(const ThreeWayOutcome& outcome);

// "pass", "fail", "inconclusive"
std::string three_way_name(ThreeWayVerdict verdict);

}  // namespace slosh
