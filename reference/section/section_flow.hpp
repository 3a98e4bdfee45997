// The potentials of the liquid at rest in a section, by spectral elements: the natural modes, and
// what a tank that surges or turns adds to them. Positions are in the outline's coordinates; xm is
// the middle of the still surface, h its height, and <a, b> the integral of a b along it.
//   modes       phi_n: harmonic, no normal velocity on the walls, phi_z = kappa_n phi on the
//               surface (the Steklov problem; Faltinsen & Timokha, Sloshing, 2009, section 4.1),
//               <phi_m, phi_n> = 1 or 0, <phi_n, 1> = 0
//   line        chi: as the modes on the walls, chi = x - xm on the surface
//   turn        Psi: the Stokes-Joukowski potential about (xm, h), <Psi, 1> = 0:
//               dPsi/dn = n . (-(z - h), x - xm) on the walls and on a lid on the surface
//   lid         as the modes on the walls, lid = Psi on the surface
//   lifted_line as the modes on the walls, d/dz = x - xm on the surface, <lifted_line, 1> = 0
// For another axis (x0, z0), the Stokes-Joukowski potential is Psi + (z0 - h)(x - xm)
// - (x0 - xm)(z - h), since the axes' motions differ by a translation.
//
// Each slab of the liquid (slabs.hpp) is one element (slab_element.hpp) with the same pieces across
// it, which are thinned towards both walls. Eliminated from the bottom up, they leave one symmetric
// matrix on the surface, of which the modes are the eigenvectors.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "reference/section/slab_element.hpp"

namespace slosh::reference {

// How finely the liquid is divided. Towards walls and singular corners the layers' distances are
// the tank's width times the powers of 0.15; towards the surface they are times those of 0.5, down
// to where the highest mode still has a third of its motion on the surface.
struct SectionGrid {
  int surface_layers;              // towards the surface
  std::vector<int> layer_degrees;  // of the layers next to a wall, from the outermost
  int middle_degree;               // of the piece between the walls' layers
  int height_degree;               // of every slab, in z

  // The errors of this one are measured in section_flow.cpp.
  static SectionGrid usual(int modes);
};

class SectionFlow {
 public:
  // Computes the first `modes` modes. Throws std::invalid_argument, which names `where`, for an
  // impossible section (slabs.hpp) and for a number of modes below 1 or above 150.
  SectionFlow(const Section& section, int modes, std::string_view where);
  SectionFlow(const Section& section, int modes, const SectionGrid& grid, std::string_view where);

  const Section& section() const { return section_; }
  double left() const { return left_; }             // of the still surface [m]
  double right() const { return right_; }           // [m]
  const Corner& middle() const { return middle_; }  // (xm, h)
  double area() const { return area_; }             // of the liquid at rest [m2]
  const Corner& centroid() const { return centroid_; }

  // kappa_n [1/m], <x, phi_n> and <Psi, phi_n>, each [modes].
  Eigen::VectorXd wave_numbers, lines, turns;
  double line_flux;    // <chi, chi_z> [m2], the sum of kappa_n <x, phi_n>^2 over all modes
  double turn_flux;    // <chi, lid_z> [m3], that of kappa_n <x, phi_n> <Psi, phi_n>
  double turn_energy;  // the integral of |grad(Psi - lid)|^2 over the liquid [m4]

  // The columns of what values() returns: the modes are 0, 1, ..., and these follow.
  Eigen::Index modes() const { return wave_numbers.size(); }
  Eigen::Index line() const { return modes(); }
  Eigen::Index lid() const { return modes() + 1; }
  Eigen::Index lifted_line() const { return modes() + 2; }
  Eigen::Index turn() const { return modes() + 3; }

  // Every potential with its gradient in the liquid at rest, or on its surface. They throw
  // std::invalid_argument, which names `where`, for a position outside and for NaN.
  SlabElement::Values values(std::string_view where, double x, double z) const;
  SlabElement::Values on_surface(std::string_view where, double x) const;

 private:
  void measure(const std::vector<Slab>& slabs);
  void solve_modes(const Condensed& surface, int modes);

  Section section_;
  double left_, right_, bottom_;
  Corner middle_, centroid_;
  double area_;
  PiecewiseGrid across_;
  std::vector<Slab> slabs_;
  std::vector<SlabElement> elements_;
};

}  // namespace slosh::reference
