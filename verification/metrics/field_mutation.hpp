// Deliberately wrong pressure fields of a known kind and strength, as series_mutation.hpp has them
// of series. A field that is late shows its waves elsewhere: it is moved along the tank. Kinds that
// a field does not have (a frequency, a drift, a mode, a unit) are refused.
#pragma once

#include <vector>

#include "verification/metrics/series_mutation.hpp"
#include "verification/series/field_snapshot.hpp"

namespace slosh {

struct FieldMutationFrame {
  double datum;   // [Pa], the pressure under the fill depth
  double length;  // [m], the tank's
};

// The kinds that a field has. With the strength s:
//   louder, quieter, thousandfold, sign_flipped  the pressure scaled as a series is
//   raised, lowered                              the pressure plus or less s times the datum
//   late, early      all places moved along x by s or -s times the tank's length
//   noisy            white normal noise on each place's pressure, with the standard deviation
//                    s times that of the moment's pressures; the same at every call
//   truncated        the last moments are lost: s of them, rounded up
//   not_a_number     the pressure of one place in each moment, the middle one of the list
inline constexpr MutationKind field_mutations[] = {
    MutationKind::louder,       MutationKind::quieter,     MutationKind::late,
    MutationKind::early,        MutationKind::raised,      MutationKind::lowered,
    MutationKind::noisy,        MutationKind::truncated,   MutationKind::not_a_number,
    MutationKind::thousandfold, MutationKind::sign_flipped};

// How many of so many moments a truncation of strength s leaves.
std::size_t moments_left(std::size_t moments, double s);

// `fields` are the moments of one run in the order of time. Throws std::logic_error for a kind that
// is not among field_mutations.
std::vector<FieldSnapshot> mutated(std::vector<FieldSnapshot> fields, const Mutation& mutation,
                                   const FieldMutationFrame& frame);

}  // namespace slosh
