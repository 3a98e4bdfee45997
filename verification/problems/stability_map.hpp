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

enum class Stability { stable, unstable, unnoticed };

struct Probe {
  Stability stability;
  std::string message;  // how it was found unstable
};

// Runs `recommended`, or what the scene's variant makes of it, on a free wave, and judges by its
// energy: unnoticed where kinetic and potential energy end at more than a twentieth of the wave's
// own above their start.
Probe probe_of_wave(const sph::Scene& scene);

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
  std::string theory_label;
  std::function<double(double up)> theory;  // the limit of `across`
  bool log_across = false, log_up = false;
};

struct MapOutcome {
  std::vector<double> measured;  // limit of `across` by value of `up`, to 2 %; NaN: none in the map
  int unnoticed = 0;             // of all runs
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

}  // namespace slosh
