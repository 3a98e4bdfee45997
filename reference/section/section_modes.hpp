// The natural modes of a liquid in a tank of any polygonal section (section.hpp), symmetric or not:
// harmonic potentials without a normal velocity on the walls, with phi_z = kappa phi on the still
// surface, which oscillate with omega^2 = g kappa (Faltinsen & Timokha, Sloshing, 2009, chapter 4).
// They are found by spectral elements (section_flow.hpp). The relative error of omega is below 3e-8
// in tanks with chamfers and in cylinders with 64 corners or more, 2e-7 in the higher modes where
// walls overhang the surface's ends, and 3e-7 with re-entrant corners; section_flow.cpp lists it.
#pragma once

#include <memory>

#include "reference/section/section.hpp"

namespace slosh::reference {

class SectionFlow;

// Copies share what was computed. Every function throws std::invalid_argument for an impossible
// section, mode or number of modes (1 to 150) and for a position off the still surface.
class SectionModes {
 public:
  SectionModes(const Section& section, int modes);

  int count() const;
  double left() const;         // x of the still surface's ends [m]
  double right() const;        // [m]
  double still_level() const;  // z of the still surface [m]
  // omega of mode n = 1, 2, ..., count() [rad/s], ascending.
  double angular_frequency(int n) const;
  // The elevation of mode n at x, divided by its value at the surface's left end.
  double shape(int n, double x) const;

  // What the solutions of this folder read.
  const std::shared_ptr<const SectionFlow>& flow() const { return flow_; }

 private:
  std::shared_ptr<const SectionFlow> flow_;
};

}  // namespace slosh::reference
