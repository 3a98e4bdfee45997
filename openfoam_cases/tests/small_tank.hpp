// A tank with a short run, and a directory that exists as long as a test.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "openfoam_cases/sloshing_tank.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::openfoam {

inline const std::filesystem::path template_directory =
    std::filesystem::path(SLOSH_SOURCE_DIR) / "openfoam_cases/sloshing_tank";

inline constexpr double surge_amplitude = 0.02;  // [m]
inline constexpr double surge_frequency = 1.5;   // [rad/s]

// Returns a tank in the surge X(t) = b sin(omega t), with a sudden start and the liquid at rest in
// the earth's frame.
inline SloshingTank small_tank() {
  const double b = surge_amplitude, omega = surge_frequency;
  return {.length = 1.1,
          .height = 1.3,
          .fill_depth = 0.357,
          .gravity = 9.81,
          .liquid = {.density = 998.2, .kinematic_viscosity = 1.004e-6},
          .gas = {.density = 1.2, .kinematic_viscosity = 1.5e-5},
          .velocity = [=](double t) { return b * omega * std::cos(omega * t); },
          .acceleration = [=](double t) { return -b * omega * omega * std::sin(omega * t); },
          .initial_relative_velocity = -b * omega,
          .duration = 1.0,
          .sample_interval = 0.01,
          .gauges = {{"right", 1.05}, {"left", 0.05}},
          .cells_x = 20,
          .cells_z = 10};
}

// Returns the same tank at rest.
inline SloshingTank still_tank() {
  SloshingTank tank = small_tank();
  tank.velocity = tank.acceleration = [](double) { return 0.0; };
  tank.initial_relative_velocity = 0;
  return tank;
}

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "openfoam's cäse XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace slosh::openfoam
