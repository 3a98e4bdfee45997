#include "openfoam_cases/geometry/cell_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/geometry/growth_ratio.hpp"

namespace slosh::openfoam {
namespace {

// Between a cell of the size s and one of r s the face lies (r - 1) s / 4 off the middle of their
// centres, where the centred gradient belongs: a twentieth of a cell.
constexpr double largest_ratio = 1.2;

// Returns the length of a side over the cell beside its ends, for n graded cells at either end.
double length_in_wall_cells(int cells, int n, double ratio) {
  double sum = 0, size = 1;
  for (int i = 0; i < n; ++i, size *= ratio) sum += 2 * size;
  return sum + (cells - 2 * n) * size;
}

}  // namespace

CellFaces::CellFaces(double length, int cells) : length_(length), cells_(cells) {}

CellFaces::CellFaces(double length, int cells, double wall_cell, const char* key)
    : CellFaces(length, cells) {
  const double uniform = length / cells;
  // A wall cell that was computed from the length and the number of cells may be off by round-off.
  require(wall_cell > 0 && wall_cell <= uniform * (1 + 1e-9), "wall_cell", wall_cell,
          fmt::format("above 0 and at most the {:.6g} m of {} = {} uniform cells", uniform, key,
                      cells));
  const double in_wall_cells = length / wall_cell;
  const int most = (cells - 1) / 2;
  while (graded_cells_ < most &&
         length_in_wall_cells(cells, graded_cells_, largest_ratio) < in_wall_cells)
    ++graded_cells_;
  const double longest = length_in_wall_cells(cells, graded_cells_, largest_ratio);
  require(longest >= in_wall_cells * (1 - 1e-9), "wall_cell", wall_cell,
          fmt::format("at least {:.3g} m for {} = {}, as each cell is at most {} times as thick as "
                      "its neighbour",
                      length / longest, key, cells, largest_ratio));
  if (graded_cells_ > 0)
    ratio_ = growth_ratio(
        [&](double ratio) { return length_in_wall_cells(cells, graded_cells_, ratio); },
        in_wall_cells, largest_ratio);
  const double first = length / length_in_wall_cells(cells, graded_cells_, ratio_);
  faces_.assign(cells + 1, 0);
  for (int i = 0; i < cells; ++i) {
    const int from_end = std::min({i, cells - 1 - i, graded_cells_});
    faces_[i + 1] = faces_[i] + first * std::pow(ratio_, from_end);
  }
  faces_.back() = length;
}

// This form returns the ends of uniform cells exactly as they were given.
double CellFaces::face(int index) const {
  return is_graded() ? faces_[index] : length_ * (static_cast<double>(index) / cells_);
}

double CellFaces::centre(int index) const {
  return is_graded() ? std::midpoint(faces_[index], faces_[index + 1])
                     : (index + 0.5) * (length_ / cells_);
}

double CellFaces::size(int index) const {
  return is_graded() ? faces_[index + 1] - faces_[index] : length_ / cells_;
}

double CellFaces::smallest() const { return size(0); }

double CellFaces::cells_to(double place) const {
  if (!is_graded()) return place / (length_ / cells_);
  const auto after = std::upper_bound(faces_.begin() + 1, faces_.end() - 1, place);
  const int index = static_cast<int>(after - faces_.begin()) - 1;
  return index + (place - faces_[index]) / size(index);
}

double CellFaces::cells_over(double place) const {
  return is_graded() ? cells_to(place) : place / length_ * cells_;
}

double CellFaces::centres_to(double place) const {
  if (!is_graded()) return cells_to(place) - 0.5;
  const int cell = std::clamp(static_cast<int>(cells_to(place)), 0, cells_ - 1);
  const int left = std::clamp(place < centre(cell) ? cell - 1 : cell, 0, cells_ - 2);
  return left + (place - centre(left)) / (centre(left + 1) - centre(left));
}

double CellFaces::at_centres(double distance) const {
  const int left = std::clamp(static_cast<int>(std::floor(distance)), 0, cells_ - 2);
  return std::lerp(centre(left), centre(left + 1), distance - left);
}

CellFaces::Part CellFaces::graded_part() const {
  if (graded_cells_ == 0) return {0, 0, 1};
  return {graded_cells_, faces_[graded_cells_], std::pow(ratio_, graded_cells_ - 1)};
}

}  // namespace slosh::openfoam
