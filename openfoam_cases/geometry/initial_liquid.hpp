// Where the liquid is at the start: under a horizontal level from wall to wall, under a wave, or in
// a column at the left wall. Cells that the edge cuts get their exact volume fraction, so that the
// volume is exact. A wavy level has the height, with x from the left wall,
//   height(x) = fill_depth + A cos(m pi x / length).
// The part of a cell below it is an exact integral: over x the level is a cosine between the places
// where it crosses the cell's bottom and top, and beyond them the cell is full or empty.
// (setAlphaField of OpenFOAM 1912 ignores a sine's phase. With its origin shifted instead, it
// approximates the level inside a cell by a straight line, and the volume fractions are wrong by up
// to 3e-4 for a wave of 0.02 m at 50 x 75 cells.)
#pragma once

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// Returns the fraction of a cell that the liquid covers, 0 to 1, as if there were no obstacles. In
// a cell that an outline cuts, a wavy level consists of 16 straight parts in the width of a cell,
// each with the level's mean height; a horizontal level is exact.
double liquid_share(const SloshingTank& tank, const TankMesh& mesh, Cell cell);

// Returns the liquid's volume per metre of width [m2], without what obstacles displace.
double initial_volume(const SloshingTank& tank, const TankMesh& mesh);

// Returns the liquid's depth in a column of cells [m], without what obstacles displace.
double initial_depth(const SloshingTank& tank, const TankMesh& mesh, int column);

// Returns the mean height of the level over from < x < to [m].
double mean_height(const SloshingTank& tank, double from, double to);

// A rectangle in the tank [m].
struct CellBox {
  double left, right, bottom, top;
};

// Returns the fraction of the box that lies below the level, 0 to 1.
double share_below_level(const SloshingTank& tank, const CellBox& cell);

// Returns the disturbance of the level that makes repeats of a run differ: a wave far smaller than
// a cell, which a violent flow amplifies into another realisation of the same flow. The seed
// decides which of the first eight modes it is (25 cells resolve all of them well), its amplitude,
// between half of `largest` and `largest` [m] > 0, and its sign. A cosine of whole half waves
// conserves the liquid's volume.
InitialWave start_disturbance(double largest, unsigned seed);

}  // namespace slosh::openfoam
