#include "openfoam_cases/outline/outline_gauge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

constexpr double place_tolerance = 1e-6;  // of the tank's size: lengths in case files are rounded
constexpr double blunt_cosine = 0.9;

// Returns the place's distance along the outline from its first corner [m].
double distance_along(const CutMesh& mesh, Corner place) {
  double nearest = std::numeric_limits<double>::infinity(), along = 0;
  Corner foot{};
  for (const WallFace& face : mesh.walls()) {
    const Corner a = mesh.points()[face.begin], b = mesh.points()[face.end];
    const double dot = (place.x - a.x) * (b.x - a.x) + (place.z - a.z) * (b.z - a.z);
    const double share = std::clamp(dot / (face.length * face.length), 0.0, 1.0);
    const Corner there{std::lerp(a.x, b.x, share), std::lerp(a.z, b.z, share)};
    const double distance = std::hypot(place.x - there.x, place.z - there.z);
    if (!(distance < nearest)) continue;
    nearest = distance;
    along = face.along + share * face.length;
    foot = there;
  }
  const double size = std::hypot(mesh.grid().length, mesh.grid().height);
  require(nearest <= place_tolerance * size, "pressure gauge x", place.x,
          fmt::format("with z = {} a place on the tank's outline, to {} m (the nearest is {:.6g}, "
                      "{:.6g} m)",
                      place.z, place_tolerance * size, foot.x, foot.z));
  return along;
}

Corner direction(const CutMesh& mesh, const WallFace& face) {
  const Corner a = mesh.points()[face.begin], b = mesh.points()[face.end];
  return {(b.x - a.x) / face.length, (b.z - a.z) / face.length};
}

// The weights of faces, by their number along the outline.
class Weights {
 public:
  explicit Weights(const CutMesh& mesh)
      : mesh_(mesh), count_(static_cast<int>(mesh.walls().size())) {}

  // Adds `weight` times the pressure at a distance [m] from a face's centre along the outline.
  void add(int face, double distance, double weight) {
    const int partner = partner_of(face, distance >= 0 ? 1 : -1);
    if (partner == face) {
      weights_[face] += weight;
      return;
    }
    const double apart = (this->face(face).length + this->face(partner).length) / 2;
    const double share = (number(face + 1) == partner ? distance : -distance) / apart;
    weights_[face] += weight * (1 - share);
    weights_[number(partner)] += weight * share;
  }

  std::vector<FaceShare> shares() const {
    std::vector<FaceShare> list;
    for (const auto& [number, weight] : weights_) {
      const Corner a = mesh_.points()[face(number).begin], b = mesh_.points()[face(number).end];
      list.push_back({(a.x + b.x) / 2, (a.z + b.z) / 2, weight});
    }
    return list;
  }

 private:
  int number(int face) const { return (face + count_) % count_; }
  const WallFace& face(int face) const { return mesh_.walls()[number(face)]; }

  // Returns the neighbour with which the pressure is linear; the face itself where there is none.
  int partner_of(int face, int towards) const {
    for (const int side : {towards, -towards})
      if (this->face(face + side).edge == this->face(face).edge) return number(face + side);
    const Corner own = direction(mesh_, this->face(face)),
                 other = direction(mesh_, this->face(face + towards));
    return own.x * other.x + own.z * other.z > blunt_cosine ? number(face + towards) : face;
  }

  const CutMesh& mesh_;
  int count_;
  std::map<int, double> weights_;
};

}  // namespace

std::vector<FaceShare> outline_face_shares(const CutMesh& mesh, Corner place, double width) {
  require(std::isfinite(place.x), "pressure gauge x", place.x, "a finite place in m");
  require(std::isfinite(place.z), "pressure gauge z", place.z, "a finite place in m");
  require(width >= 0 && width <= mesh.perimeter() / 2, "pressure gauge width", width,
          fmt::format("between 0 and half the outline's {} m", mesh.perimeter()));
  const double middle = distance_along(mesh, place);
  Weights weights(mesh);
  const auto& faces = mesh.walls();
  if (width == 0) {
    const auto above =
        std::upper_bound(faces.begin(), faces.end(), middle,
                         [](double along, const WallFace& face) { return along < face.along; });
    const WallFace& face = *(above - 1);
    weights.add(static_cast<int>(above - faces.begin()) - 1, middle - face.along - face.length / 2,
                1);
    return weights.shares();
  }
  for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
    for (const int turn : {-1, 0, 1}) {  // the gauge may reach beyond the first corner
      const double begin = faces[i].along + turn * mesh.perimeter();
      const double from = std::max(begin, middle - width / 2),
                   to = std::min(begin + faces[i].length, middle + width / 2);
      if (!(to > from)) continue;
      weights.add(i, (from + to) / 2 - begin - faces[i].length / 2, (to - from) / width);
    }
  }
  return weights.shares();
}

}  // namespace slosh::openfoam
