// Maps of where the solver is stable: it is run at every point of a grid of two numbers, and along
// each row the limit is found by bisection. A run that its guards watch either ends with no more
// energy than it had, is stopped, or ends and has gained energy unnoticed, which none may.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sph/simulation.hpp"
#include "verification/problems/lattice_stability.hpp"
#include "verification/problems/problem.hpp"

namespace slosh {

// Of the analysis that every map but the viscosity's cites.
inline constexpr const char* lattice_source =
    "the staggered leapfrog's amplification factor on the lattice (Press et al. 2007, section "
    "20.1, for the method)";

enum class Stability { stable, unstable, unnoticed };

struct Probe {
  Stability stability;
  std::string message;  // how it was found unstable
};

// Runs `recommended`, or what the scene's variant makes of it, on a free wave, and judges by its
// energy: unnoticed where kinetic and potential energy end at more than a twentieth of the wave's
// own above their start.
Probe probe_of_wave(const sph::Scene& scene);

inline constexpr int steps_of_probe = 4000;

// One long wave in 1 m of water 0.4 m deep, at 0.04 m, for that many steps of the Courant number
// and twenty to a sample.
sph::Scene wave_scene(const sph::SchemeNumbers& numbers, int steps);

// The sums of `recommended` on its lattice, whose limits a free wave's map is held against.
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
  // Limits of `across` by value of `up`: measured to 2 %, NaN for none in the map, and in theory.
  std::vector<double> measured, expected;
  int unnoticed = 0;  // of all runs
  reports::Figure figure;
  reports::Table table;
};

MapOutcome explore(const StabilityMap& map);

// What a map leaves: how far the measured limits are from the theory's, the schemes' own number,
// `shipped`, over them, and of guarded runs how many gained energy unnoticed.
enum class Guarded { no, yes };
std::vector<MeasureKind> map_measures(const std::string& step, Guarded guarded = Guarded::yes);
std::vector<MeasuredErrors> measures_of(const StabilityMap& map, const MapOutcome& outcome,
                                        const std::function<double(double up)>& shipped,
                                        Guarded guarded = Guarded::yes);

// The map explored, with what it leaves.
ProblemOutcome outcome_of(const StabilityMap& map, const std::function<double(double up)>& shipped,
                          Guarded guarded = Guarded::yes);

}  // namespace slosh
