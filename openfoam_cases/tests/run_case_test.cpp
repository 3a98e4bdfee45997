// Runs the installed interFoam for a second on a tank of 20 x 10 cells: what a run gives, and how
// one fails.
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <numbers>
#include <sstream>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_case_test {
namespace {

namespace fs = std::filesystem;

std::vector<pid_t> child_processes() {
  std::istringstream list(contents("/proc/thread-self/children"));
  return {std::istream_iterator<pid_t>(list), {}};
}

// Returns linear theory for the antisymmetric modes that X(t) = b sin(omega t) excites from rest in
// the earth's frame (Faltinsen 1978): eta_n'' + omega_n^2 eta_n = -c_n lambda_n tanh(lambda_n h)
// X''.
double linear_elevation(const SloshingTank& tank, double time, double gauge_x) {
  double elevation = 0;
  for (int n = 0; n < 100; ++n) {
    const double lambda = (2 * n + 1) * std::numbers::pi / tank.length;
    const double c = 2 * (n % 2 == 0 ? 1 : -1) / (tank.length / 2 * lambda * lambda);
    const double drive = c * lambda * std::tanh(lambda * tank.fill_depth);
    const double omega_n = std::sqrt(tank.gravity * drive / c);
    const double forced = surge_amplitude * surge_frequency * surge_frequency * drive /
                          (omega_n * omega_n - surge_frequency * surge_frequency);
    const double free =
        -(drive * surge_amplitude * surge_frequency + forced * surge_frequency) / omega_n;
    elevation += (forced * std::sin(surge_frequency * time) + free * std::sin(omega_n * time)) *
                 std::sin(lambda * (gauge_x - tank.length / 2));
  }
  return elevation;
}

TEST_F(RunCase, GivesAWholeRecordOfAWaveAndKeepsTheLiquid) {
  const SloshingTank tank = small_tank();
  const Harvest result = run(tank);
  EXPECT_EQ(result.version, installed_version());
  EXPECT_LT(std::abs(result.relative_mass_loss), 1e-9);
  EXPECT_GE(result.steps, tank.duration / 0.0022);  // 0.01/omega of the first mode
  EXPECT_GT(result.max_courant_number, 0);
  EXPECT_LT(result.max_courant_number, 0.6);
  EXPECT_GT(result.mean_pressure_iterations, 1);
  const History& right = result.elevation.at("right");
  const History& left = result.elevation.at("left");
  ASSERT_EQ(right.time.size(), 101u);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < right.time.size(); ++i) {
    const double expected = linear_elevation(tank, right.time[i], tank.gauges[0].x);
    error += std::pow(right.value[i] - expected, 2);
    size += std::pow(expected, 2);
    EXPECT_NEAR(right.value[i], -left.value[i], 2e-3) << "a small wave is antisymmetric";
  }
  // The difference is 0.12 on this mesh; with the wrong sign of the acceleration it is 0.73, and of
  // the initial velocity 1.69.
  EXPECT_LT(std::sqrt(error / size), 0.25);
}

// Both programs solve the same equations, so that they agree on a small wave but not to the last
// digit.
TEST_F(RunCase, GivesNearlyTheSameWaveByInterIsoFoam) {
  SloshingTank tank = small_tank();
  const Harvest algebraic = run(tank);
  const TemporaryDirectory other;
  tank.program = Program::inter_iso_foam;
  const Harvest geometric = run_in(other, tank);
  EXPECT_TRUE(fs::exists(other.path() / "log.interIsoFoam"));
  EXPECT_LT(std::abs(geometric.relative_mass_loss), 1e-6) << "it clips what is beyond 0 and 1";
  const std::vector<double>&a = algebraic.elevation.at("right").value,
        &b = geometric.elevation.at("right").value;
  ASSERT_EQ(a.size(), b.size());
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += std::pow(a[i] - b[i], 2);
    size += std::pow(a[i], 2);
  }
  EXPECT_GT(difference, 0) << "it is another program";
  EXPECT_LT(std::sqrt(difference / size), 0.1);
}

TEST_F(RunCase, LeavesNothingWhereTheVersionIsAskedFor) {
  const fs::path before = fs::current_path();
  fs::current_path(directory_.path());
  const std::string version = installed_version();
  fs::current_path(before);
  EXPECT_FALSE(version.empty());
  EXPECT_TRUE(fs::is_empty(directory_.path()));
}

TEST_F(RunCase, ReportsItsProgress) {
  const SloshingTank tank = small_tank();
  write_case(tank, template_directory, directory_.path());
  double last_time = 0, last_steps = 0;
  run_case(tank, directory_.path(), [&](double time, double steps) {
    EXPECT_GE(time, last_time);
    EXPECT_GE(steps, last_steps);
    last_time = time, last_steps = steps;
  });
  EXPECT_GT(last_time, 0);
  EXPECT_GT(last_steps, 0);
  EXPECT_LE(last_time, tank.duration);
}

TEST_F(RunCase, GivesTheSameOnTwoProcessesAsOnOne) {
  SloshingTank tank = small_tank();
  tank.duration = 0.3;
  const Harvest serial = run(tank);
  tank.processes = 2;
  TemporaryDirectory parallel_directory;
  const Harvest parallel = run_in(parallel_directory, tank);
  for (const char* gauge : {"left", "right"}) {
    const History& one = serial.elevation.at(gauge);
    const History& two = parallel.elevation.at(gauge);
    ASSERT_EQ(one.time.size(), two.time.size());
    for (std::size_t i = 0; i < one.time.size(); ++i) {
      EXPECT_NEAR(one.value[i], two.value[i], 1e-6);
    }
  }
}

TEST_F(RunCase, SaysSoWhenTheSolverIsKilled) {
  const SloshingTank tank = small_tank();
  write_case(tank, template_directory, directory_.path());
  const std::string message = message_of<RunError>([&] {
    run_case(tank, directory_.path(), [](double, double) {
      for (const pid_t child : child_processes()) kill(child, SIGKILL);
    });
  });
  EXPECT_NE(message.find("interFoam: killed by signal 9"), std::string::npos) << message;
  EXPECT_NE(message.find("Time = "), std::string::npos) << message;
  EXPECT_THROW(harvest(tank, directory_.path()), RunError);
}

TEST_F(RunCase, LeavesNoProcessBehindWhenTheCallerThrows) {
  for (const int processes : {1, 2}) {
    SloshingTank tank = small_tank();
    tank.duration = 100;
    tank.processes = processes;
    TemporaryDirectory directory;
    write_case(tank, template_directory, directory.path());
    EXPECT_THROW(
        run_case(tank, directory.path(), [](double, double) { throw std::domain_error("enough"); }),
        std::domain_error);
    EXPECT_TRUE(child_processes().empty());
    const auto size = fs::file_size(directory.path() / "log.interFoam");
    usleep(300'000);
    EXPECT_EQ(fs::file_size(directory.path() / "log.interFoam"), size) << "it still runs";
  }
}

TEST_F(RunCase, ShowsTheLinesOfAFatalError) {
  const SloshingTank tank = small_tank();
  write_case(tank, template_directory, directory_.path());
  std::string schemes = contents(directory_.path() / "system/fvSchemes");
  schemes.replace(schemes.find("default Euler"), 13, "default Eular");
  std::ofstream(directory_.path() / "system/fvSchemes") << schemes;
  const std::string message = message_of<RunError>([&] { run_case(tank, directory_.path(), {}); });
  EXPECT_NE(message.find("interFoam: exit status 1, a fatal error"), std::string::npos) << message;
  EXPECT_NE(message.find("Unknown ddt type Eular"), std::string::npos) << message;
}

TEST_F(RunCase, RefusesARunThatOnlyWarns) {
  const SloshingTank tank = small_tank();
  write_case(tank, template_directory, directory_.path());
  std::string control = contents(directory_.path() / "system/controlDict");
  control.replace(control.find("libforces"), 9, "libfroces");
  std::ofstream(directory_.path() / "system/controlDict") << control;
  const std::string message = message_of<RunError>([&] { run_case(tank, directory_.path(), {}); });
  EXPECT_NE(message.find("a warning"), std::string::npos) << message;
  EXPECT_NE(message.find("libfroces"), std::string::npos) << message;
}

TEST(RunCaseWithoutOpenFoam, NamesTheProgramAndThePackage) {
  TemporaryDirectory directory;
  write_case(small_tank(), template_directory, directory.path());
  const std::string path = getenv("PATH");
  setenv("PATH", directory.path().c_str(), 1);
  EXPECT_EQ(installed_version(), "");
  const std::string message =
      message_of<RunError>([&] { run_case(small_tank(), directory.path(), {}); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(message.find("blockMesh: no such program"), std::string::npos) << message;
  EXPECT_NE(message.find("\"openfoam\""), std::string::npos) << message;
}

}  // namespace
}  // namespace slosh::openfoam::run_case_test
