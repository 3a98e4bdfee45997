// Errors of the usual grid. The relative error of kappa_n is
//   rectangle (depth 0.35 of the length)   1e-11 for all of 40 modes, 6e-9 for all of 100
//   walls at 45 degrees                    1e-10 for the first nine of 10
//   0.15 m chamfers in 1 m x 0.7 m, filled to 0.35 m      4e-11
//   the same filled to 0.62 m, between the upper chamfers 4e-10 for the first and 9e-8 for the last
//                                          of 40 modes; 2e-8 and 4e-7 for those of 10
//   a half-filled polygon of 64 corners    3e-8, where it differs from the cylinder by 9e-4
//   re-entrant corners of 243 degrees      5e-7
// all but the first two against a finer grid. With 40 modes the chamfered tank takes 0.8 s and a
// polygon of 128 corners 1.8 s; with 100 modes a rectangle takes 5 s. The accuracy is least where
// walls overhang the surface's ends, and for re-entrant corners: there the potential is r^a with
// a < 2 or a < 1.
#include "reference/section/section_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "reference/potential_flow/decompositions.hpp"
#include "reference/require.hpp"

namespace slosh::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_modes = 150;

// The best ratio of layers towards a singularity (Schwab, p- and hp-Finite Element Methods, 1998,
// section 3.3), and one with which a wave of any length falls by little across a layer.
constexpr double corner_ratio = 0.15, surface_ratio = 0.5;

std::vector<double> layers(double width, double ratio, int count) {
  std::vector<double> distances;
  for (int layer = 1; layer <= count; ++layer) distances.push_back(width * std::pow(ratio, layer));
  return distances;
}

int layer_count(const SectionGrid& grid) { return static_cast<int>(grid.layer_degrees.size()); }

PiecewiseGrid pieces_across(const SectionGrid& grid) {
  std::vector<double> breaks{-1, 1};
  for (const double distance : layers(2, corner_ratio, layer_count(grid))) {
    breaks.insert(breaks.end(), {distance - 1, 1 - distance});
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<int> degrees(grid.layer_degrees.rbegin(), grid.layer_degrees.rend());
  degrees.push_back(grid.middle_degree);
  degrees.insert(degrees.end(), grid.layer_degrees.begin(), grid.layer_degrees.end());
  return {breaks, degrees};
}

}  // namespace

SectionGrid SectionGrid::usual(int modes) {
  // A polynomial resolves a wave with a little more than pi nodes for its length. In units of the
  // width the highest mode's wave number is pi modes, across which the middle piece takes 0.7 and
  // the outermost layer 0.13.
  const double highest = std::numbers::pi * modes;
  const int levels = static_cast<int>(std::ceil(std::log(highest) / -std::log(surface_ratio)));
  return {.surface_layers = std::max(2, levels),
          .layer_degrees = {8 + 3 * modes / 10, 8 + modes / 20, 8},
          .middle_degree = 16 + 11 * modes / 10,
          .height_degree = 8};
}

SectionFlow::SectionFlow(const Section& section, int modes, std::string_view where)
    : SectionFlow(section, modes, SectionGrid::usual(std::clamp(modes, 1, most_modes)), where) {}

SectionFlow::SectionFlow(const Section& section, int modes, const SectionGrid& grid,
                         std::string_view where)
    : section_(section), across_(pieces_across(grid)) {
  require(modes >= 1 && modes <= most_modes, where, "number of modes", modes,
          fmt::format("1 to {}", most_modes));
  const std::vector<Slab> whole = slabs_of(section, where);
  measure(whole);
  const double width = right_ - left_;
  slabs_ = graded(whole, {.to_surface = layers(width, surface_ratio, grid.surface_layers),
                          .to_corner = layers(width, corner_ratio, layer_count(grid))});
  std::optional<Condensed> below;
  for (const Slab& slab : slabs_) {
    elements_.emplace_back(slab, across_, grid.height_degree, middle_, below);
    below = elements_.back().condensed();
  }
  solve_modes(*below, modes);
}

void SectionFlow::measure(const std::vector<Slab>& slabs) {
  const Slab& highest = slabs.back();
  left_ = highest.left_top;
  right_ = highest.right_top;
  bottom_ = slabs.front().bottom;
  middle_ = {(left_ + right_) / 2, highest.top};
  area_ = 0;
  centroid_ = {0, 0};
  for (const Slab& slab : slabs) {
    // Simpson's rule is exact for the cubics that these are at most.
    const double height = slab.top - slab.bottom;
    for (const auto& [z, weight] : {std::pair{slab.bottom, height / 6},
                                    {(slab.bottom + slab.top) / 2, 4 * height / 6},
                                    {slab.top, height / 6}}) {
      const double width = 2 * slab.half_width(z);
      area_ += weight * width;
      centroid_.x += weight * width * slab.middle(z);
      centroid_.z += weight * width * z;
    }
  }
  centroid_ = {centroid_.x / area_, centroid_.z / area_};
}

void SectionFlow::solve_modes(const Condensed& surface, int modes) {
  const double half_width = (right_ - left_) / 2;
  const MatrixXd mass =
      half_width *
      transposed_product(across_.values, across_.weights.asDiagonal() * across_.values);
  const Eigenpairs pairs = generalized_eigenpairs(surface.stiffness, mass);
  // The first eigenvector is the constant.
  const Index rest = across_.size() - 1;
  const MatrixXd shapes = pairs.vectors.rightCols(rest);
  const VectorXd kappa = pairs.values.tail(rest);

  const VectorXd x = half_width * across_.nodes;
  const VectorXd all_lines = shapes.transpose() * (mass * x),
                 all_turns = (shapes.transpose() * surface.load).cwiseQuotient(kappa);
  const VectorXd turn = shapes * all_turns;
  line_flux = x.dot(surface.stiffness * x);
  turn_flux = x.dot(surface.load);
  turn_energy = surface.energy;

  const auto sign = shapes.row(0).head(modes).array().sign().matrix();
  wave_numbers = kappa.head(modes);
  lines = all_lines.head(modes).cwiseProduct(sign.transpose());
  turns = all_turns.head(modes).cwiseProduct(sign.transpose());
  MatrixXd potentials(across_.size(), modes + 4);
  potentials << shapes.leftCols(modes) * sign.asDiagonal(), x, turn,
      shapes * all_lines.cwiseQuotient(kappa), turn;
  for (Index k = static_cast<Index>(elements_.size()) - 1; k >= 0; --k) {
    potentials = elements_[k].set_potentials(potentials);
  }
}

SlabElement::Values SectionFlow::values(std::string_view where, double x, double z) const {
  const double tolerance = rounding * (middle_.z - bottom_);
  require(z >= bottom_ - tolerance && z <= middle_.z + tolerance, where, "z", z,
          fmt::format("a height from {} m (the bottom) to {} m (the still surface)", bottom_,
                      middle_.z));
  z = std::clamp(z, bottom_, middle_.z);
  std::size_t k = 0;
  while (z > slabs_[k].top) ++k;
  const double centre = slabs_[k].middle(z), reach = slabs_[k].half_width(z);
  require(std::abs(x - centre) <= reach + rounding * (right_ - left_), where, "x", x,
          fmt::format("a position from {} m to {} m, within the liquid at z = {} m", centre - reach,
                      centre + reach, z));
  return elements_[k].at(across_, z, reach > 0 ? std::clamp((x - centre) / reach, -1.0, 1.0) : 0);
}

SlabElement::Values SectionFlow::on_surface(std::string_view where, double x) const {
  require(x >= left_ - rounding * (right_ - left_) && x <= right_ + rounding * (right_ - left_),
          where, "x", x,
          fmt::format("a position from {} m to {} m, on the still surface", left_, right_));
  return values(where, std::clamp(x, left_, right_), middle_.z);
}

}  // namespace slosh::reference
