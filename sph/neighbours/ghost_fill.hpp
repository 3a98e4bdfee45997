// How much of a ghost particle's volume counts: as much as there is liquid at its node. A mirror
// image exists only where its owner does, but a ghost particle also stands above the surface, where
// it would pull at the liquid's edge.
//
// The kernel sum of the liquid at a node, over what the solids leave of the kernel there, is 1 in
// the liquid, 1/2 at its surface, and falls by dp W_1 per spacing across it, where W_1 is the
// kernel's integral along the surface. The share is 1 where the sum is that of the outermost row of
// a lattice, half a spacing inside, 0 half a spacing outside, and linear in between.
#pragma once

#include <algorithm>
#include <vector>

#include "sph/terms/kernels.hpp"
#include "sph/walls/solid_particles.hpp"

namespace slosh::sph {

class GhostFill {
 public:
  // The places must have their final order; h is the smoothing length and dp the spacing [m]. A
  // node sees the solids that `sight` lets it see.
  void initialise(const KernelFunction& kernel, const std::vector<SolidPlace>& places, double h,
                  double dp, const LineOfSight& sight);

  // Returns the share of ghost particle i, whose node has this kernel sum of the liquid, without
  // the kernel's normalisation and 1/h^2 [m2].
  double share(std::size_t i, double liquid) const {
    return std::clamp(0.5 + (liquid / room_[i] - 0.5) / fall_, 0.0, 1.0);
  }

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("room", room_);
  }

 private:
  double fall_ = 0;           // of the kernel sum across a spacing at the surface
  std::vector<double> room_;  // the kernel sum of a whole liquid at each node, as in share() [m2]
};

}  // namespace slosh::sph
