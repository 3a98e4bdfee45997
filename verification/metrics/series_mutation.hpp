// Deliberately wrong series of a known kind and strength, which show what a gate can detect: a gate
// that passes a series that is too high, late or poisoned is useless. A mutated series keeps its
// sample times unless the kind changes them, so that its coverage alone never reveals it. Where a
// shift in time needs values beyond the record, the first or last value is held.
#pragma once

#include <string>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The comments give the meaning of the strength s, which is never negative.
enum class MutationKind {
  louder,           // values times 1 + s
  quieter,          // values times 1 - s
  late,             // shifted by s periods
  early,            // shifted by -s periods
  faster,           // time runs 1 + s times as fast, from the first sample on
  slower,           // time runs 1 - s times as fast
  raised,           // values plus s times the datum
  lowered,          // values less s times the datum
  drifting,         // plus a ramp from zero at the window's begin to s standard deviations of the
                    // values in the window at its end
  chirped,          // runs ahead by s u^2 periods, u from 0 to 1 over the window: a frequency that
                    // changes slowly
  mode_gained,      // plus s times the fitted part of one natural mode (`mode`)
  mode_damped,      // that part decays 1 + s times as fast, from the window's begin on
  noisy,            // white normal noise, standard deviation s times that of the values in the
                    // window; the same at every call
  slipped,          // late by s whole periods
  truncated,        // ends s of the window's length before the window's end
  not_a_number,     // one sample NaN, the closest to the window's middle; s has no meaning here and
                    // below
  swapped_columns,  // times and values exchanged
  thousandfold,     // values in thousandths of the unit, labelled as if in the unit
  other_unit,       // labelled in thousandths of the unit ("mm" for "m"), values unchanged
  sign_flipped      // values times -1
};

struct Mutation {
  MutationKind kind;
  double strength;
  std::string mode = {};  // only for mode_gained and mode_damped
};

// The scales of the mutations.
struct MutationFrame {
  TimeWindow window;  // of the comparison
  double period;      // [s], of the judged mode; without modes the window's length
  // In the series' unit: the fill depth, or the pressure under it; 0 where the quantity has none.
  double datum = 0;
  std::vector<ToneRequest> modes = {};  // the fitted modes
  std::vector<Tone> tones = {};         // these modes, fitted to the unmutated series
};

// Throws ComparisonError as cut_to_window() does for the series before its mutation, and when the
// mode that is to be changed is not among the frame's tones.
TimeSeries mutated(const TimeSeries& series, const Mutation& mutation, const MutationFrame& frame);

// "louder", "not a number", ...
std::string mutation_name(MutationKind kind);

// Whether the kind leaves a sound series with other values, which only a metric can detect; the
// other kinds end in a series that is refused.
bool changes_values(MutationKind kind);

}  // namespace slosh
