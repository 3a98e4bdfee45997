// The largest expected speed V_max of a run, taken from its own flow: the same scene is run at a
// coarser spacing first.
//
// V_max is the speed relative to the tank that the share `faster_share` of the particles exceeds,
// counted over all particles and samples. The tank's frame is the right one: a tank that is carried
// along evenly compresses nothing, and liquid meets walls at its speed relative to them. It is not
// the largest speed, which is that of single splashed particles and does not converge with the
// spacing (docs/notebook/scheme_choices.md). V_max is at least the speed sqrt(g h) of a long
// wave, because the liquid's weight compresses it by g h / c0^2 too (Monaghan 1994, section 4).
//
// The cost of a run in two dimensions grows as the inverse cube of the spacing. Three times the
// spacing thus costs 1/27 of the run, where the run has 24 rows of particles or more, and 1/9 with
// a fixed time step.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sph/run_output.hpp"
#include "sph/scene.hpp"

namespace slosh::sph {

inline constexpr double coarsening = 3;  // the coarse spacing over the run's, at most
// The particles across the liquid's depth, or across the width of a dam's column that is narrower.
// With fewer, waves are damped within a period.
inline constexpr int fewest_across = 8;
inline constexpr double faster_share = 1e-3;

// Counts speeds in classes of one width.
class SpeedCounts {
 public:
  explicit SpeedCounts(double width) : width_(width) {}  // [m/s], above 0

  void add(double speed);  // [m/s], finite and not negative

  // Returns the speed that at most this share of those added exceeds [m/s], rounded up to a class.
  // Throws std::logic_error where none was added.
  double exceeded_by(double share) const;

 private:
  double width_;
  std::size_t total_ = 0;
  std::vector<std::size_t> counts_;
};

// Runs a scene to its end.
using RunScene = std::function<RunOutput(const Scene&)>;

// Measures V_max with the scene's first coarser spacing that `run` takes, or with its own where it
// takes none. The coarse particles start without disorder, so that repeats of a run have one speed
// of sound. Throws std::invalid_argument for a tank at rest with liquid at rest, and
// SimulationError where the coarse run fails.
CoarseRun coarse_run(const Scene& scene, const RunScene& run);

}  // namespace slosh::sph
