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

void take_uniform_cells(const TankMesh& mesh, FieldSnapshot& snapshot) {
  const auto columns = overlaps(mesh.across()), rows = overlaps(mesh.up());
  const auto means = [&](const std::vector<double>& of_graded) {
    std::vector<double> of_uniform;
    for (const std::vector<Overlap>& row : rows)
      for (const std::vector<Overlap>& column : columns) {
        double mean = 0;
        for (const Overlap& k : row)
          for (const Overlap& i : column)
            mean += k.share * i.share * of_graded[k.index * mesh.columns() + i.index];
        of_uniform.push_back(mean);
      }
    return of_uniform;
  };
  for (std::vector<double>* field :
       {&snapshot.velocity_x, &snapshot.velocity_z, &snapshot.pressure, &snapshot.liquid_share})
    *field = means(*field);
  const CellFaces across(mesh.length(), mesh.columns()), up(mesh.up().length(), mesh.rows());
  for (int row = 0; row < mesh.rows(); ++row)
    for (int column = 0; column < mesh.columns(); ++column) {
      const int cell = row * mesh.columns() + column;
      snapshot.x[cell] = across.centre(column);
      snapshot.z[cell] = up.centre(row);
      snapshot.area[cell] = mesh.cell_width() * mesh.cell_height();
    }
}

}  // namespace slosh::openfoam
