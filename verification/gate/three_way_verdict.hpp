// A verdict that accounts for its uncertainty, after ASME V&V 20-2009. The comparison error
//   E = S - D
// is simulation less data (every metric of the gate is such an error). Its validation uncertainty
// is
//   U_val = sqrt(U_discretisation^2 + U_series^2 + U_input^2 + U_reference^2)
// The verdict is pass where the whole interval from E - U_val to E + U_val lies within the bound,
// fail where all of it lies outside, and inconclusive where the interval holds the bound. For a
// bound on |E| it is pass where |E| + U_val <= limit, and fail where |E| - U_val > limit. The first
// two terms are the standard's numerical uncertainty; they are separate here because they have
// different remedies. All terms are expanded 95 % half widths. The standard adds standard
// uncertainties and expands the sum, which is the same where all terms have one coverage factor. An
// unknown contribution counts as zero in U_val; whether a row may then still pass depends on its
// kind (gate.hpp). NaN or infinity fails in E and is inconclusive in a U; neither ever passes.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace slosh {

// The half width of a 95 % interval in the error's unit, not negative; nullopt where it is unknown.
struct Contribution {
  std::optional<double> half_width = 0.0;
  // What the half width rests on. Where it is unknown: what is missing, and what would provide it.
  std::string basis = {};
  // The declared parts that the half width does not count, each with the reason; "" where it counts
  // all.
  std::string not_counted = {};

  Contribution() = default;
  Contribution(double known, std::string rests_on = {})
      : half_width(known), basis(std::move(rests_on)) {}
  static Contribution unknown(std::string missing);

  double known() const { return half_width.value_or(0); }  // zero where unknown
};

// The contributions are independent of one another.
struct UncertaintyContributions {
  Contribution discretisation = {};  // time step and spacing (discretisation_uncertainty.hpp)
  Contribution time_series = {};     // their finite length: the metric's confidence interval
  Contribution input = {};      // the simulation's inputs: motion, fill depth, liquid properties
  Contribution reference = {};  // the experiment's data, or another method's own uncertainty
  // The half width of the range outside which the metric cannot lie.
  double at_most = std::numeric_limits<double>::infinity();
};

// U_val of the known contributions, no larger than their `at_most`; NaN where one of them is
// negative or NaN.
double validation_uncertainty(const UncertaintyContributions& contributions);

// What is missing of the numerical uncertainty and of the reference's, and the declared parts that
// any contribution does not count, joined by "; "; "" where nothing is missing. Anything missing
// keeps a validation row from passing. Inputs that are not declared are exempt: the experiment's
// paper may not state them, and no run of this project could provide them.
std::string missing_for_validation(const UncertaintyContributions& contributions);

// "discretisation", "time series", "input" or "reference": the largest.
std::string dominant_contribution(const UncertaintyContributions& contributions);

// The range that the error may have: {-limit, limit} for |E| <= limit. An unbounded side is
// infinite.
struct AllowedRange {
  double lower, upper;
};

enum class ThreeWayVerdict { pass, fail, inconclusive };

struct ThreeWayOutcome {
  ThreeWayVerdict verdict;
  double error;
  UncertaintyContributions contributions;
  double uncertainty;  // U_val
  // The distance of E to the nearest bound: the verdict is conclusive where U_val is below it. It
  // is zero where E lies on a bound, NaN where E is not finite.
  double conclusive_uncertainty;
};

// The verdict is fail where a bound of the range is NaN.
ThreeWayOutcome judge_error(double error, const UncertaintyContributions& contributions,
                            const AllowedRange& allowed);

// How far one contribution must fall to make an inconclusive outcome conclusive while E and the
// other contributions stay as they are. More work changes E as well, so this is the least to plan
// for.
struct Remedy {
  double half_width;  // that the contribution must fall to
  double factor;      // by which the steps must be finer, or the window longer
  double cost_ratio;  // of the new run to the present one
};

// U_discretisation ~ h^order; the cost grows as h^-3, for two dimensions and the time step. Returns
// nullopt where the other contributions alone exceed the conclusive uncertainty, where the outcome
// is already conclusive, and where the order is not above zero.
std::optional<Remedy> finer_step(const ThreeWayOutcome& outcome, double order);

// U_series ~ 1 / sqrt(window); the cost grows as the window. Returns nullopt as finer_step() does.
std::optional<Remedy> longer_window(const ThreeWayOutcome& outcome);

}  // namespace slosh
