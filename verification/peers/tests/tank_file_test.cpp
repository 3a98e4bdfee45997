// The file that a driver reads: the case's numbers, its motion as a table, and what it refuses.
#include "verification/peers/tank_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/case/motion.hpp"
#include "verification/peers/dualsphysics/acceleration.hpp"
#include "verification/peers/motion_table.hpp"
#include "verification/peers/tests/handed.hpp"

namespace slosh::tank_file_test {
namespace {

CaseDefinition surging_tank() {
  CaseDefinition definition{};
  definition.gravity = 9.81;
  definition.tank = {.length = 1, .height = 0.6};
  definition.liquid = {.fill_depth = 0.35, .density = 998, .kinematic_viscosity = 1e-6};
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 3};
  definition.start = Start::earth;
  definition.duration = 2.015;  // not a whole number of samples
  definition.sample_interval = 0.02;
  definition.gauges = {{"left", 0.05}, {"right", 0.95}};
  return definition;
}

TEST(TankFile, HoldsTheCaseInItsUnits) {
  const auto file = nlohmann::json::parse(tank_file(surging_tank()));
  EXPECT_EQ(file.at("length_m"), 1);
  EXPECT_EQ(file.at("height_m"), 0.6);
  EXPECT_EQ(file.at("fill_depth_m"), 0.35);
  EXPECT_EQ(file.at("gravity_m_s2"), 9.81);
  EXPECT_EQ(file.at("density_kg_m3"), 998);
  EXPECT_EQ(file.at("kinematic_viscosity_m2_s"), 1e-6);
  EXPECT_EQ(file.at("gauges").at(1).at("name"), "right");
  EXPECT_EQ(file.at("gauges").at(1).at("x_m"), 0.95);
  EXPECT_EQ(file.at("duration_s"), 2.015);
  EXPECT_EQ(file.at("sample_interval_s"), 0.02);
  EXPECT_EQ(file.at("initial_wave").at("amplitude_m"), 0);
}

TEST(TankFile, HoldsTheInitialWave) {
  CaseDefinition definition = surging_tank();
  definition.initial_wave = InitialWaveDefinition{.mode = 2, .amplitude = 0.01};
  const auto file = nlohmann::json::parse(tank_file(definition));
  EXPECT_EQ(file.at("initial_wave").at("mode"), 2);
  EXPECT_EQ(file.at("initial_wave").at("amplitude_m"), 0.01);
}

TEST(TankFile, TabulatesTheAccelerationFinelyUpToTheEnd) {
  const CaseDefinition definition = surging_tank();
  const auto motion = nlohmann::json::parse(tank_file(definition)).at("motion");
  const auto times = motion.at("time_s").get<std::vector<double>>();
  const auto values = motion.at("acceleration_x_m_s2").get<std::vector<double>>();
  ASSERT_EQ(times.size(), values.size());
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times.back(), definition.duration);
  for (std::size_t i = 1; i < times.size(); ++i) {
    EXPECT_LE(times[i] - times[i - 1], 0.002 + 1e-12);
    // Between two points the straight line is as good as the motion: (3 * 0.002)^2 / 8 of it.
    const double middle = (times[i - 1] + times[i]) / 2;
    EXPECT_NEAR((values[i - 1] + values[i]) / 2, surge_motion(definition).acceleration(middle),
                1e-5 * 0.02 * 9);
  }
}

TEST(TankFile, SetsTheLiquidOffAgainstATankThatStartsInTheEarthsFrame) {
  CaseDefinition definition = surging_tank();
  const auto velocity = [&] {
    return nlohmann::json::parse(tank_file(definition))
        .at("motion")
        .at("initial_velocity_x_m_s")
        .get<double>();
  };
  EXPECT_NEAR(velocity(), -0.06, 1e-15);
  definition.start = Start::tank;
  EXPECT_EQ(velocity(), 0);
}

TEST(TankFile, RefusesWhatItHasNoPlaceFor) {
  CaseDefinition rolls = surging_tank(), blocked = surging_tank(), dam = surging_tank(),
                 sloped = surging_tank();
  rolls.motion.roll = RollDefinition{SineMotion{.amplitude = 0.1, .angular_frequency = 3}, 0.5, 0};
  blocked.obstacles.push_back({"baffle", 0.4, 0.5, 0, 0.1});
  dam.liquid.column_width = 0.3;
  sloped.tank.outline = {{0, 0}, {1, 0}, {0, 1}};
  for (const CaseDefinition& definition : {rolls, blocked, dam, sloped})
    EXPECT_THROW(tank_file(definition), std::invalid_argument);
}

// What the liquid feels in the tank's frame, against the acceleration of a moving point in the
// earth's frame, which is differenced from its path: neither knows the other's signs.

using Vector = std::array<double, 2>;  // x, z

constexpr double gravity = 9.81, surge_amplitude = 0.05, surge_frequency = 2.3, angle = 0.3,
                 roll_frequency = 3.1;

const std::string rolls = R"([motion.surge]
type = "sine"
amplitude_m = 0.05
angular_frequency_rad_s = 2.3
[motion.roll]
type = "sine"
amplitude_deg = 17.188733853924695
angular_frequency_rad_s = 3.1
axis_x_m = 0.4
axis_z_m = 0.2
)";

std::string rolling_case() {
  return replaced(moving(rolls), "start = \"earth\"", "start = \"tank\"");
}

double surge(double t) { return surge_amplitude * std::sin(surge_frequency * t); }
double theta(double t) { return angle * std::sin(roll_frequency * t); }

// The force per mass, along the tank's axes, that keeps a point on its straight way through the
// tank: it passes `from_axis` at the time t with this velocity in the tank's frame.
Vector felt(double t, const Vector& from_axis, const Vector& velocity) {
  const auto path = [&](double s) -> Vector {
    const double x = from_axis[0] + velocity[0] * (s - t), z = from_axis[1] + velocity[1] * (s - t);
    return {surge(s) + x * std::cos(theta(s)) - z * std::sin(theta(s)),
            x * std::sin(theta(s)) + z * std::cos(theta(s))};
  };
  constexpr double h = 1e-3;
  const Vector before = path(t - h), now = path(t), after = path(t + h);
  const double x = -(after[0] - 2 * now[0] + before[0]) / (h * h);
  const double z = -gravity - (after[1] - 2 * now[1] + before[1]) / (h * h);
  return {x * std::cos(theta(t)) + z * std::sin(theta(t)),
          -x * std::sin(theta(t)) + z * std::cos(theta(t))};
}

constexpr double tolerance = 2e-5;  // of second differences 1 ms apart, in m/s2
const Vector places[] = {{0, 0}, {0.3, -0.1}, {-0.2, 0.4}}, speeds[] = {{0, 0}, {0.7, -0.4}};

TEST(MotionTable, HoldsTheMotionOfAnIndependentFormula) {
  const Handed handed(moving(surges));
  const std::vector<MotionPoint> table = motion_table(handed.definition());
  ASSERT_EQ(table.size(), 1001u);  // ten points a sample of 20 ms
  for (const MotionPoint& at : table) {
    EXPECT_NEAR(at.surge, 0.02 * std::sin(1.7 * at.time), 1e-14);
    EXPECT_NEAR(at.surge_velocity, 0.02 * 1.7 * std::cos(1.7 * at.time), 1e-14);
    EXPECT_NEAR(at.surge_acceleration, -0.02 * 1.7 * 1.7 * std::sin(1.7 * at.time), 1e-14);
    EXPECT_EQ(at.angle, 0);
  }
  EXPECT_EQ(table.back().time, 2);
  EXPECT_NEAR(initial_velocity_x(handed.definition()), -0.034, 1e-15);
}

TEST(MotionTable, TellsWhatALiquidFeelsInARollingTank) {
  const Handed handed(rolling_case());
  for (const MotionPoint& at : motion_table(handed.definition())) {
    const TankGravity uniform = tank_gravity(at, gravity);
    for (const Vector& place : places)
      for (const Vector& speed : speeds) {
        const Vector exact = felt(at.time, place, speed);
        const double turn = at.angular_acceleration, squared = at.rate * at.rate;
        EXPECT_NEAR(uniform.x + turn * place[1] + squared * place[0] + 2 * at.rate * speed[1],
                    exact[0], tolerance);
        EXPECT_NEAR(uniform.z - turn * place[0] + squared * place[1] - 2 * at.rate * speed[0],
                    exact[1], tolerance);
      }
  }
}

// DualSPHysics's own use of the table (JDsAccInput: ComputeVelocity and RunCpu), about y.
struct AddedBySolver {
  double x, z, rate;
};

std::vector<AddedBySolver> added_by_solver(const Handed& handed, const Vector& place,
                                           const Vector& speed) {
  const std::string file = "plain_acceleration.csv";
  const auto time = handed.numbers(file, "#time[s]", ';'),
             x = handed.numbers(file, "linx[m/s2]", ';'), z = handed.numbers(file, "linz", ';'),
             turn = handed.numbers(file, "angy", ';');
  std::vector<AddedBySolver> added;
  double velocity = 0, rate = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (k > 0) velocity += x[k] * (time[k] - time[k - 1]);
    if (k > 0) rate += turn[k] * (time[k] - time[k - 1]);
    if (time[k] < 0) continue;
    added.push_back({x[k] + turn[k] * place[1] - rate * rate * place[0] + 2 * rate * speed[1],
                     -gravity + z[k] - turn[k] * place[0] - rate * rate * place[1] -
                         2 * rate * (speed[0] - velocity),
                     rate});
  }
  return added;
}

TEST(AccInput, GivesDualSphysicsAllThatARollingTankAddsButTheCentrifugalForce) {
  Handed handed(rolling_case());
  handed.to("dualsphysics");
  const std::vector<MotionPoint> motion = motion_table(handed.definition());
  for (const Vector& place : places)
    for (const Vector& speed : speeds) {
      const std::vector<AddedBySolver> added = added_by_solver(handed, place, speed);
      ASSERT_EQ(added.size(), motion.size());
      for (std::size_t i = 0; i < added.size(); ++i) {
        // The solver sums the turning by steps of 2 ms, which errs by a step's turn at most.
        EXPECT_NEAR(added[i].rate,
                    angle * roll_frequency * std::cos(roll_frequency * motion[i].time),
                    2 * 0.002 * angle * roll_frequency * roll_frequency);
        const Vector exact = felt(motion[i].time, place, speed);
        const double twice = 2 * added[i].rate * added[i].rate, sums = 0.01;
        EXPECT_NEAR(added[i].x + twice * place[0], exact[0], sums);
        EXPECT_NEAR(added[i].z + twice * place[1], exact[1], sums);
      }
    }
}

TEST(AccInput, TellsTheLargestErrorOfTheCentrifugalForce) {
  const Handed handed(rolling_case());
  // The farthest corner from the axis is (1, 0.6).
  EXPECT_NEAR(largest_centrifugal_error(handed.definition()),
              2 * std::pow(angle * roll_frequency, 2) * std::hypot(0.6, 0.4), 1e-6);
  EXPECT_EQ(largest_centrifugal_error(Handed(moving(surges)).definition()), 0);
}

TEST(AccInput, PushesTheLiquidOfASurgingTankBackwards) {
  Handed handed(moving(surges));
  handed.to("dualsphysics");
  const std::string file = "plain_acceleration.csv";
  const auto time = handed.numbers(file, "#time[s]", ';'),
             x = handed.numbers(file, "linx[m/s2]", ';');
  ASSERT_EQ(time.size(), 1001u);
  for (std::size_t i = 0; i < time.size(); ++i)
    EXPECT_NEAR(x[i], 0.02 * 1.7 * 1.7 * std::sin(1.7 * time[i]), 1e-14);
  for (const char* none : {"liny", "linz", "angx[rad/s2]", "angy", "angz"})
    for (const double value : handed.numbers(file, none, ';')) EXPECT_EQ(value, 0) << none;
}

}  // namespace
}  // namespace slosh::tank_file_test
