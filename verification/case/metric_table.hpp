// The metrics of the gate, in one table. A row of it says how a metric is named in case files and
// at the command line, its unit, its description, what it is measured on, how wide a bound on it
// may be, and what the self-test expects of it. Only the computation of its value stands elsewhere
// (gate/measured_value.cpp). A row that lacks a field does not compile, nor does a table that lacks
// a row.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "verification/input/rules.hpp"

namespace slosh {

// In the order of the table's rows. A new metric goes above cost_to_reach, which stays the last.
enum class Metric {
  // Of one fitted mode.
  amplitude_error,
  phase_lag,
  frequency_error,
  decay_rate,  // of the candidate
  decay_error,
  // Of the whole window.
  normalised_rms,
  aligned_rms,        // after the lag that fits best is removed
  largest_magnitude,  // of the candidate alone
  // Of irregular waves, whose single crests are random (wave_statistics.hpp, spectrum.hpp,
  // time_alignment.hpp).
  cross_correlation_lag,  // one lag of the whole wave
  spectral_peak_error,    // the frequency of the highest peak
  rms_error,              // the deviation from the mean
  mean_offset,
  noise_share,    // of the candidate alone
  initial_value,  // of the candidate alone
  frequency,      // of a fitted mode of the candidate alone
  // Of the candidate's impacts against the published ones (impact_metrics.hpp).
  plateau_error,      // the mean over the published plateau's time
  impact_arrival,     // the time at which the pressure comes to a share of the peak and holds it
  impact_peak_error,  // the peak over the published one, less 1
  impulse_error,      // the impulse from the arrival on over the published one, less 1
  // Of the peaks of one impact over an ensemble against those over the experiment's repeats
  // (distributions/peak_comparison.hpp).
  peak_mean_p_value,  // of Welch's test of equal means
  peak_ks_p_value,    // of the Kolmogorov-Smirnov test of equal distributions
  peak_ad_p_value,    // of the Anderson-Darling test of equal distributions
  peak_median_error,  // the ratio of the medians, less 1
  // Of the candidate in the band of a record's quantiles (quantile_band.hpp), over the window or a
  // part of it.
  outside_band,  // the share of the time outside the band
  // Of the pressure fields at the case's snapshot times against interFoam's (field_metrics.hpp).
  pressure_field_rms,      // the rms of the difference over the pressure under the fill depth
  pressure_field_tension,  // the share of the candidate's liquid under tension
  // Of the candidate's family: the cost of the row's error (work_precision.hpp).
  cost_to_reach
};

inline constexpr std::size_t metric_count = static_cast<std::size_t>(Metric::cost_to_reach) + 1;

enum class MeasuredOn {
  any_mode,
  natural_mode,  // not the forced mode, whose frequency is given and which does not decay: a row
                 // there would pass whatever the candidate did
  whole_window,
  oscillation,  // the whole window of a quantity with modes: the metric counts periods or peaks
  front,        // the whole window of a quantity without modes, which has one lag; an oscillating
                // quantity has one lag per mode
  own_series,   // the candidate alone, over the whole run
  own_mode,     // a natural mode of the candidate alone
  impact,
  repeated_impact,  // over an ensemble, against the experiment's repeats
  plateau,
  band,   // the window, or a part of it, of a record with a band
  field,  // one moment of the case, or the mean over all
  cost    // all runs of the candidate's family
};

// Whose harmonic fit gives the metric its value and its interval.
enum class FittedTones { none, of_candidate, of_both };

// What a metric does not see of two series, which then have the same value: a modulus that one is
// turned over or turned in phase, a distance that they lie on two sides of the reference. The
// change from one to the other then counts at another place of the line through both
// (refinement.hpp).
enum class BlindTo { nothing, sign, side };

// Where `slosh converge` shows how the metric falls with the particle spacing.
enum class ConvergenceShown { nowhere, of_forced_mode, of_natural_modes, of_oscillation, of_front };

enum class BoundForm { any, limit, range };

// Which form a bound on the metric must have, and why.
struct RequiredBound {
  BoundForm form;
  const char* because;
};

// What the widest bound is a multiple of.
enum class BoundScale { unit, window, impact_period, tank };

// A limit, and half the width of a range, lie below `below` times the scale; `because` says what a
// wider bound would let pass. No range holds `nothing`, which a candidate of zeros has, or of a lag
// a wave that is turned over; NaN where the metric has no such value.
struct WidestBound {
  constexpr WidestBound(double multiple, BoundScale multiple_of, const char* reason,
                        double of_nothing = std::numeric_limits<double>::quiet_NaN())
      : below(multiple), scale(multiple_of), because(reason), nothing(of_nothing) {}

  double below;
  BoundScale scale;
  const char* because;
  double nothing;
};

struct MetricEntry {
  Metric metric;
  const char* name;
  const char* unit;         // "": the quantity's
  const char* description;  // in the text of `slosh explain`
  MeasuredOn measured_on;
  FittedTones fitted;
  BlindTo blind_to;
  ConvergenceShown convergence;
  RequiredBound bound;
  WidestBound widest;
};

const std::array<MetricEntry, metric_count>& metric_table();
const MetricEntry& metric_entry(Metric metric);
// Throws std::logic_error for a name that the table lacks.
const MetricEntry& metric_entry(const std::string& name);

std::string metric_name(Metric metric);
std::string metric_unit(Metric metric, const std::string& quantity_unit);

// Whether a comparison of one candidate with one reference gives the metric.
bool is_of_a_pair(const MetricEntry& metric);
bool is_of_candidate_alone(Metric metric);
bool is_of_impacts(Metric metric);
// Whether the metric is of the peaks of a whole ensemble against those of the experiment's repeats.
bool is_of_repeats(Metric metric);
// Whether the metric is a p-value, whose largest value is 1: an upper bound of 1 is none.
bool is_p_value(Metric metric);
bool is_of_band(Metric metric);
bool is_of_fields(Metric metric);
bool is_cost(Metric metric);
bool is_angle(Metric metric);  // in degrees, and so known up to whole turns

// The modes of a GateRow on which a metric can be judged. `fitted` are the modes that are fitted to
// the quantity, "forced", "natural_1", ...; `is_front` says that the quantity has no modes. Empty
// for a metric of impacts, whose modes the case names; of the moments of fields "whole" alone.
std::vector<std::string> measured_modes(const MetricEntry& metric,
                                        const std::vector<std::string>& fitted, bool is_front);
// The mode that --limit takes where it names none: "forced" or "whole". Returns nullopt where a
// mode must be named.
std::optional<std::string> default_mode(const MetricEntry& metric);
// "what phase_lag is measured on"
std::string measured_on_text(const MetricEntry& metric);

// The length of the comparison's window and the period of the motion that causes the impacts [s];
// the largest value that the quantity can have (largest_in_tank()), in its unit.
struct BoundScales {
  double window;
  double impact_period = 0;
  double tank = 1e9;
};

// The smallest width of a bound that lets every candidate pass, in the metric's unit.
double widest_bound(const MetricEntry& metric, const BoundScales& scales);
// A limit on the metric must lie above 0 and below widest_bound().
Rule<double> limit_rule(const MetricEntry& metric, const std::string& unit,
                        const BoundScales& scales);
// The upper end of a range must lie above the lower one, by less than twice widest_bound(), and the
// range must not hold what `nothing` says of the metric.
Rule<double> upper_rule(const MetricEntry& metric, const std::string& unit,
                        const BoundScales& scales, double lower);

}  // namespace slosh
