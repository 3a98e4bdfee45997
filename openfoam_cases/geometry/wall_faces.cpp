#include "openfoam_cases/geometry/wall_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/outline/outline_gauge.hpp"

namespace slosh::openfoam {
namespace {

using Wall = PressureGauge::Wall;

// In faces. Round-off may move a gauge's end this far past a corner or an obstacle's edge.
constexpr double end_tolerance = 1e-9;

struct Span {
  int first, last;
};

Cell cell_at(const TankMesh& mesh, Wall wall, int face) {
  switch (wall) {
    case Wall::left:
      return {0, face};
    case Wall::right:
      return {mesh.columns() - 1, face};
    case Wall::roof:
      return {face, mesh.rows() - 1};
    case Wall::bottom:
      break;
  }
  return {face, 0};
}

FaceShare share_of(const TankMesh& mesh, Wall wall, int face, double weight) {
  switch (wall) {
    case Wall::left:
      return {0, mesh.centre_z(face), weight};
    case Wall::right:
      return {mesh.length(), mesh.centre_z(face), weight};
    case Wall::roof:
      return {mesh.centre_x(face), mesh.face_z(mesh.rows()), weight};
    case Wall::bottom:
      break;
  }
  return {mesh.centre_x(face), 0, weight};
}

void check_place(const PressureGauge& gauge, double length) {
  require(gauge.width >= 0 && std::isfinite(gauge.width), "pressure gauge width", gauge.width,
          "m, zero or above");
  const double slack = end_tolerance * length;
  require(gauge.position - gauge.width / 2 >= -slack &&
              gauge.position + gauge.width / 2 <= length + slack,
          "pressure gauge position", gauge.position,
          fmt::format("with half the width of {} m to both sides between the wall's ends, 0 and "
                      "{} m",
                      gauge.width, length));
}

// Returns the place in the rectangle around an outline.
Corner place_on_wall(const TankMesh& mesh, const PressureGauge& gauge) {
  switch (gauge.wall) {
    case Wall::left:
      return {0, gauge.position};
    case Wall::right:
      return {mesh.length(), gauge.position};
    case Wall::roof:
      return {gauge.position, mesh.face_z(mesh.rows())};
    case Wall::bottom:
      break;
  }
  return {gauge.position, 0};
}

}  // namespace

std::vector<FaceShare> face_shares(const TankMesh& mesh, const PressureGauge& gauge) {
  if (mesh.cut())
    return outline_face_shares(*mesh.cut(), gauge.at ? *gauge.at : place_on_wall(mesh, gauge),
                               gauge.width);
  require(!gauge.at, "pressure gauge x", gauge.at ? gauge.at->x : 0,
          "a wall and a position along it in a tank without an outline");
  const bool is_level = gauge.wall == Wall::bottom || gauge.wall == Wall::roof;
  const CellFaces& wall = is_level ? mesh.across() : mesh.up();
  const int faces = wall.cells();
  check_place(gauge, wall.length());
  const double lower = gauge.position - gauge.width / 2, upper = gauge.position + gauge.width / 2;
  // In faces from the wall's end.
  const double begin = wall.cells_to(lower), end = wall.cells_to(upper);
  Span span{std::clamp(static_cast<int>(std::floor(begin + end_tolerance)), 0, faces - 1), 0};
  span.last =
      std::clamp(static_cast<int>(std::ceil(end - end_tolerance)) - 1, span.first, faces - 1);
  const auto is_free = [&](int face) { return mesh.is_free(cell_at(mesh, gauge.wall, face)); };
  for (int face = span.first; face <= span.last; ++face) {
    require(is_free(face), "pressure gauge position", gauge.position,
            "a part of the wall that no obstacle covers");
  }
  // The next face on either side counts where the gauge ends before the centre of the last face.
  if (is_free(span.first - 1)) --span.first;
  if (is_free(span.last + 1)) ++span.last;
  if (span.first == span.last) return {share_of(mesh, gauge.wall, span.first, 1)};

  // Between centres the pressure is linear, so that its mean is the value in the middle.
  const double last_cut = wall.centres_to(upper);
  std::vector<double> cuts{wall.centres_to(lower)};  // in faces from the first centre
  for (int face = span.first; face <= span.last; ++face) {
    if (face > cuts.back() && face < last_cut) cuts.push_back(face);
  }
  cuts.push_back(last_cut);
  std::map<int, double> weights;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = (cuts[i] + cuts[i + 1]) / 2;
    const double part =
        end > begin ? (wall.at_centres(cuts[i + 1]) - wall.at_centres(cuts[i])) / gauge.width : 1;
    const int left = std::clamp(static_cast<int>(std::floor(middle)), span.first, span.last - 1);
    weights[left] += part * (1 - (middle - left));
    weights[left + 1] += part * (middle - left);
  }
  std::vector<FaceShare> shares;
  for (const auto& [face, weight] : weights) {
    shares.push_back(share_of(mesh, gauge.wall, face, weight));
  }
  return shares;
}

}  // namespace slosh::openfoam
