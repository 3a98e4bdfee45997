// Maps of the solver's stability: it is run at every point of a grid of two numbers, and in each
// row the limit is found by bisection. A run either ends without a gain of energy (stable), is
// stopped by the solver's guards (unstable), or ends with a gain of energy that the guards missed
// (unnoticed), which must not happen.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sph/simulation.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability/lattice_buckling.hpp"

namespace slosh {

// The source of the analysis that every map but the viscosity's cites.
inline constexpr const char* lattice_source =
    "the staggered leapfrog's amplification factor on the lattice (Press et al. 2007, section "
    "20.1, for the method)";

enum class Stability { stable, unstable, unnoticed };

struct Probe {
  Stability stability;
  std::string message;  // why it is unstable
};

// Runs `recommended`, or the scene's variant of it, on a free wave and judges the run by its
// energy: it is unnoticed where the kinetic and potential energy have grown by more than a
// twentieth of the wave's energy.
Probe probe_of_wave(const sph::Scene& scene);

inline constexpr int steps_of_probe = 4000;

// Returns water at rest in a tank 1 m long and twice as high as the water, whose depth is given
// [m]. The caller sets the duration and the sample interval.
sph::Scene still_tank(double depth, double spacing);

// Returns one long wave in 1 m of water 0.4 m deep, with particles of 0.04 m, for `steps` steps of
// the Courant number dt c0 / h. Each is a sample, since a run shortens its own steps where the
// liquid is compressed (sph/run.cpp), and the map asks what happens if it does not.
sph::Scene wave_scene(const sph::SchemeNumbers& numbers, int steps);

// Returns the lattice analysis of `recommended`, with whose limits the maps of a free wave are
// compared.
LatticeScheme lattice_of_recommended();

struct MapAxis {
  std::string label;
  std::vector<double> values;  // increasing
};

struct StabilityMap {
  std::string id, title, caption;
  MapAxis across, up;  // stable at the low end of `across`
  std::function<Probe(double across, double up)> probe;
  std::function<double(double up)> theory;  // the lattice's limit of `across`
  bool log_across = false, log_up = false;
};

struct MapOutcome {
  // Limits of `across` for each `up`: measured to 2 % (NaN where the map has none), and
  // theoretical.
  std::vector<double> measured, expected;
  int unnoticed = 0;  // of all runs
  reports::Figure figure;
  reports::Table table;
};

MapOutcome explore(const StabilityMap& map);

// The measures of a map: the deviation of the measured limits from the theoretical ones, the
// schemes' own number `shipped` over the measured limits, and for guarded runs the number of
// unnoticed gains of energy.
enum class Guarded { no, yes };
std::vector<MeasureKind> map_measures(const std::string& step, Guarded guarded = Guarded::yes);
std::vector<MeasuredErrors> measures_of(const StabilityMap& map, const MapOutcome& outcome,
                                        const std::function<double(double up)>& shipped,
                                        Guarded guarded = Guarded::yes);

// Explores the map and returns its measures, figure and table.
ProblemOutcome outcome_of(const StabilityMap& map, const std::function<double(double up)>& shipped,
                          Guarded guarded = Guarded::yes);

}  // namespace slosh
