// The single loops of a step, and their numbers of pairs.
#pragma once

#include <stdexcept>

#include "sph/benchmarks/flows.hpp"
#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {

enum class Loop { momentum, continuity, refresh, rebuild };

// Returns the floating-point operations of one pair, counted from the formulas of Wendland C2, the
// impact viscosity and the diffusion of the dynamic density; a square root or a division counts as
// one operation.
inline double flops_of_pair(Loop loop) {
  switch (loop) {
    case Loop::momentum:
      return 33;
    case Loop::continuity:
      return 26;
    default:
      return 0;
  }
}

// The bytes read for one listed source: its record and its index.
inline constexpr double bytes_of_source = sizeof(Source) + sizeof(std::uint32_t);

class PairLoops {
 public:
  using Measured = Scheme<WithWendlandC2>;

  PairLoops(int rows, double smoothing_length_ratio)
      : scene_(benchmark_scene(rows, smoothing_length_ratio)),
        scheme_(scene_),
        particles_(flowing(scene_, scheme_, Flow::violent)),
        neighbours_(walls_, scene_.particle_spacing, support()) {
    rates_.resize(particles_.size());
    run(Loop::rebuild, widest_instruction_set());
    run(Loop::refresh, widest_instruction_set());
    count_pairs();
  }

  void run(Loop loop, InstructionSet set) {
    switch (loop) {
      case Loop::momentum:
        return sum_momentum(scheme_, walls_, neighbours_.clusters(), neighbours_.sources(),
                            particles_, rates_, set);
      case Loop::continuity:
        return sum_continuity(scheme_, walls_, neighbours_.clusters(), neighbours_.sources(), {},
                              particles_, rates_, set);
      case Loop::refresh:
        return neighbours_.refresh_for_continuity(scheme_, particles_, walls_);
      case Loop::rebuild:
        // The short step gives lists with the smallest slack, those of a calm flow.
        if (!neighbours_.rebuild(particles_, walls_, 1e-9, WithWendlandC2::Mirror::exists))
          throw std::runtime_error("a particle is not in the tank");
    }
  }

  std::size_t particles() const { return particles_.size(); }
  double listed_sources() const { return listed_sources_; }
  double evaluated_pairs() const { return lane_count * listed_sources_; }
  double useful_pairs() const { return useful_pairs_; }  // within the support

 private:
  double support() const { return kernel_support * scheme_.setting.smoothing_length(); }

  void count_pairs() {
    neighbours_.clusters().for_each([&](const Cluster& cluster) {
      listed_sources_ += static_cast<double>(cluster.source_count);
      for (std::size_t i = cluster.first; i < cluster.first + cluster.size; ++i)
        for (std::size_t k = 0; k < cluster.source_count; ++k) {
          const Source& b = neighbours_.sources()[cluster.sources[k]];
          const double dx = particles_.x[i] - b.x, dz = particles_.z[i] - b.z;
          if (dx * dx + dz * dz < support() * support()) ++useful_pairs_;
        }
    });
  }

  const Scene scene_;
  const Measured scheme_;
  const Tank walls_ = TankWalls{.left = 0,
                                .right = scene_.tank_length,
                                .bottom = 0,
                                .roof = scene_.tank_height,
                                .velocity = 0,
                                .acceleration = 0};
  Particles particles_;
  NeighbourSources neighbours_;
  Rates rates_;
  double listed_sources_ = 0, useful_pairs_ = 0;
};

}  // namespace slosh::sph
