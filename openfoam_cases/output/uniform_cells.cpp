#include "openfoam_cases/output/uniform_cells.hpp"

#include <algorithm>

namespace slosh::openfoam {
namespace {

struct Overlap {
  int index;     // of a graded cell along a side
  double share;  // of a uniform cell's size
};

// Returns the graded cells that each uniform cell overlaps.
std::vector<std::vector<Overlap>> overlaps(const CellFaces& graded) {
  const CellFaces uniform(graded.length(), graded.cells());
  std::vector<std::vector<Overlap>> all(uniform.cells());
  for (int i = 0; i < uniform.cells(); ++i)
    for (int j = 0; j < graded.cells(); ++j) {
      const double common = std::min(uniform.face(i + 1), graded.face(j + 1)) -
                            std::max(uniform.face(i), graded.face(j));
      if (common > 0) all[i].push_back({j, common / uniform.size(i)});
    }
  return all;
}

}  // namespace

std::vector<double> means_over_uniform_cells(const TankMesh& mesh,
                                             const std::vector<double>& field) {
  const auto columns = overlaps(mesh.across()), rows = overlaps(mesh.up());
  std::vector<double> means;
  for (const std::vector<Overlap>& row : rows)
    for (const std::vector<Overlap>& column : columns) {
      double mean = 0;
      for (const Overlap& k : row)
        for (const Overlap& i : column)
          mean += k.share * i.share * field[k.index * mesh.columns() + i.index];
      means.push_back(mean);
    }
  return means;
}

}  // namespace slosh::openfoam
