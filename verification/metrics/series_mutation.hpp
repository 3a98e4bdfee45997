// Series made wrong on purpose, by a known kind and strength, to find out what a gate can detect: a
// gate that passes a series that is too high, late or poisoned is no gate. A mutated series keeps
// its sample times unless the kind is about them, so that it is never told by its coverage alone;
// where a shift asks for values that the record does not have, its first or last one is held.
#pragma once

#include <string>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// What the strength s means; it is never negative.
enum class MutationKind {
  louder,        // values times 1 + s
  quieter,       // values times 1 - s
  late,          // shifted by s periods
  early,         // shifted by -s periods
  faster,        // time runs 1 + s times as fast, from the first sample on
  slower,        // time runs 1 - s times as fast
  raised,        // values plus s times the datum
  lowered,       // values less s times the datum
  drifting,      // plus a ramp from zero at the window's begin to s standard deviations of the
                 // values in the window at its end
  chirped,       // runs ahead by s u^2 periods, u from 0 to 1 over the window: a frequency that
                 // changes slowly
  mode_gained,   // plus s times the part that the fit gives to one natural mode (`mode`)
  mode_damped,   // that part decays 1 + s times as fast, from the window's begin on
  noisy,         // white normal noise, standard deviation s times that of the values in the
                 // window; the same at every call
  slipped,       // late by s whole periods
  truncated,     // ends s of the window's length before the window's end
  not_a_number,  // one sample NaN, that nearest to the window's middle; s of no meaning, as below
  swapped_columns,  // values where times belong and the other way round
  thousandfold,     // values in thousandths of the unit, labelled as if in the unit
  other_unit,       // labelled as in thousandths of the unit ("mm" for "m"), values as they are
  sign_flipped      // values times -1
};

struct Mutation {
  MutationKind kind;
  double strength;
  std::string mode = {};  // of mode_gained and mode_damped alone
};

// What changes are measured by.
struct MutationFrame {
  TimeWindow window;  // of the comparison
  double period;      // [s], of the mode that is judged; without modes the window's length
  // In the series' unit: the fill depth, or the pressure under it; 0 where the quantity has none.
  double datum = 0;
  std::vector<ToneRequest> modes = {};  // that are fitted
  // The modes as fitted to the very series, once for all that changes a mode of it; where there are
  // none, each such change fits them.
  std::vector<Tone> tones = {};
};

// Throws ComparisonError as cut_to_window() does of the series before its mutation, and as
// fit_harmonics() where a mode is changed.
TimeSeries mutated(const TimeSeries& series, const Mutation& mutation, const MutationFrame& frame);

// "louder", "not a number", ...
std::string mutation_name(MutationKind kind);

// Whether the kind leaves a sound series of other values: one that only a metric can tell, where
// the others end in a series that is refused.
bool changes_values(MutationKind kind);

}  // namespace slosh
