// The difference of two pressure fields at one moment, on the mesh of the reference. The reference
// is the liquid of a volume-of-fluid solver: the cells with a volume fraction of 1/2 or more. The
// candidate is particles or cells; each is a rectangle around its middle (field_snapshot.hpp).
//
// Onto the mesh. A candidate's place a counts in the cell c with the area A_ac that its rectangle
// has in common with the box of c, which has the cell's middle and is as wide and as high as the
// larger of a cell and a place:
//   p_c        = sum_a A_ac p_a / sum_a A_ac
//   coverage_c = sum_a A_ac / area of the box
// This is a normalised (Shepard) kernel mean: the kernel is the product of two trapezoids, with the
// radius (place + box) / 2 in x and in z. It needs no particles behind the walls, as the boxes end
// with the tank where places are no larger than cells. It is exact for a uniform pressure. A linear
// pressure is exact on places that tile the boxes; elsewhere its error falls with their size. Of a
// mesh finer than the reference's it is the mean over the common area, of a coarser one the linear
// interpolation, held beyond the middles next to the walls.
//
// Compared are the cells that are liquid in the reference and covered by half or more. With d_c the
// candidate's p_c less the reference's pressure of the cell, over n compared cells:
//   pressure_rms    = sqrt(sum d_c^2 / n)
//   pressure_offset = sum d_c / n
#pragma once

#include <cstddef>

#include "verification/series/field_snapshot.hpp"

namespace slosh {

struct FieldDifference {
  double time;                                        // [s], the reference's
  std::size_t compared_cells;                         // one or more
  double pressure_rms;                                // [Pa]
  double pressure_offset;                             // [Pa], mean of candidate less reference
  double candidate_rms;                               // [Pa], the candidate's pressure itself
  double lowest_pressure, reference_lowest_pressure;  // [Pa], the lowest cell's
  // Shares of the compared cells whose pressure lies further below the gas's than what the caller
  // declares to be small.
  double tension_share, reference_tension_share;
  // Over the reference's liquid cells: those that the candidate does not cover, and the cells that
  // it covers where the reference has no liquid.
  double uncovered_share, excess_share;
};

// Where the candidate covers less of the reference's liquid than this, nothing is compared: the rms
// over what little is left would not tell of the field.
inline constexpr double least_covered_share = 0.5;

// A pressure below -small_tension [Pa] counts as tension; small_tension is not negative. Throws
// ComparisonError where a field is empty, incomplete or has a number that is not finite, where the
// reference's middles are not those of a mesh, where the candidate's places are a hundred times as
// large as the cells or lie a million cells away, and where less than least_covered_share of the
// reference's liquid is covered.
FieldDifference field_difference(const FieldSnapshot& candidate, const FieldSnapshot& reference,
                                 double small_tension);

}  // namespace slosh
