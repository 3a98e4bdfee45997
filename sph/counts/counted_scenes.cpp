#include "sph/counts/counted_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "sph/tests/surging_scene.hpp"

namespace slosh::sph {
namespace {

// Returns a roll of 3 degrees at the surge's frequency, about the middle of the bottom.
Roll rolling() {
  const double angle = 0.05, omega = surge_frequency;
  return {.angle = [=](double t) { return angle * std::sin(omega * t); },
          .rate = [=](double t) { return angle * omega * std::cos(omega * t); },
          .acceleration = [=](double t) { return -angle * omega * omega * std::sin(omega * t); },
          .axis_x = 0.5,
          .axis_z = 0};
}

void keep_still(Scene& scene) {
  const Scene still = still_scene(scene.particle_spacing, scene.duration);
  scene.displacement = still.displacement;
  scene.velocity = still.velocity;
  scene.acceleration = still.acceleration;
}

using Change = void (*)(Scene&);
const std::map<std::string, Change> changes{
    {"coarse",
     [](Scene& scene) { scene.particle_spacing = scene.surface_particle_spacing = 0.04; }},
    {"two_spacings",
     [](Scene& scene) { scene.surface_particle_spacing = 0.5 * scene.particle_spacing; }},
    {"still", keep_still},
    {"roll", [](Scene& scene) { scene.roll = rolling(); }},
    {"baffle",
     [](Scene& scene) {
       scene.obstacles = {{0.44, 0.56, 0, 0.16}};
     }},
    {"plate",
     [](Scene& scene) {
       scene.obstacles = {{0.5, 0.52, 0, 0.16}};
     }},
    {"dam", [](Scene& scene) { scene.column_width = 0.5; }},
    {"narrow_tank",
     [](Scene& scene) {
       scene.breadth = 0.05;
       scene.kinematic_viscosity = 1e-6;
     }},
    {"no_gauge", [](Scene& scene) { scene.gauges.clear(); }},
    {"pressure_gauge",
     [](Scene& scene) {
       scene.pressure_gauges = {{"left", Wall::left, 0.1, 0}};
     }},
    {"probe",
     [](Scene& scene) {
       scene.probes = {{"middle", 0.5, 0.2}};
     }},
    {"wall_forces",
     [](Scene& scene) {
       scene.loaded_walls = {{"left", Wall::left}};
     }},
    {"energy_budget", [](Scene& scene) { scene.record_energy_budget = true; }},
    {"still_water", [](Scene& scene) { scene.record_still_water = true; }},
    {"snapshots",
     [](Scene& scene) {
       scene.snapshot_interval = scene.sample_interval;
       scene.record_snapshot = [](const Snapshot&) {};
     }},
    {"saved_states",
     [](Scene& scene) {
       scene.state_interval = scene.sample_interval;
       scene.save_state = [](const SavedState&) {};
     }},
};

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

CountedScene counted_scene(const std::string& parts, double duration) {
  CountedScene counted{"recommended", surging_scene(0.02, duration)};
  counted.scene.initial_state = InitialState::lattice;  // steps, and no projection
  std::istringstream names(parts);
  for (std::string name; std::getline(names, name, '+');) {
    const auto change = changes.find(name);
    if (holds(scheme_names(), name))
      counted.scheme = name;
    else if (holds(variant_names(), name))
      counted.scene.variant = name;
    else if (change != changes.end())
      change->second(counted.scene);
    else
      throw std::invalid_argument(
          fmt::format("\"{}\": expected a scheme, a variant or a part of "
                      "sph/counts/counted_scenes.hpp",
                      name));
  }
  return counted;
}

}  // namespace slosh::sph
