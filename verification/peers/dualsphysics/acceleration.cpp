#include "verification/peers/dualsphysics/acceleration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/peers/motion_table.hpp"

namespace slosh {
namespace {

AccInputRow row_of(const MotionPoint& at, double gravity) {
  const TankGravity felt = tank_gravity(at, gravity);
  return {at.time, felt.x, felt.z + gravity, at.angular_acceleration};
}

// The sum of the angular acceleration begins in the first row at 0. A second row, 1 s before the
// start, makes it the roll's rate at the start.
void begin_at_rate(double rate, std::vector<AccInputRow>& rows) {
  if (rate == 0) return;
  const double angular = rate - rows.front().angular_y;
  rows.insert(rows.begin(), {{-2, 0, 0, 0}, {-1, 0, 0, angular}});
}

void take_off_coriolis_of_sum(std::vector<AccInputRow>& rows) {
  double velocity = 0, rate = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double step = rows[i].time - rows[i - 1].time;
    velocity += rows[i].x * step;
    rate += rows[i].angular_y * step;
    rows[i].z -= 2 * rate * velocity;
  }
}

}  // namespace

std::vector<AccInputRow> acc_input(const CaseDefinition& definition) {
  std::vector<AccInputRow> rows;
  if (definition.motion.still()) return rows;
  const std::vector<MotionPoint> motion = motion_table(definition);
  for (const MotionPoint& at : motion) rows.push_back(row_of(at, definition.gravity));
  if (!definition.motion.roll) return rows;
  begin_at_rate(motion.front().rate, rows);
  take_off_coriolis_of_sum(rows);
  return rows;
}

std::string acc_input_file(const std::vector<AccInputRow>& rows) {
  std::string text = "#time[s];linx[m/s2];liny;linz;angx[rad/s2];angy;angz\n";
  for (const AccInputRow& row : rows)
    text +=
        fmt::format("{};{};0;{};0;{};0\n", row.time, row.x + 0.0, row.z + 0.0, row.angular_y + 0.0);
  return text;
}

double largest_centrifugal_error(const CaseDefinition& definition) {
  if (!definition.motion.roll) return 0;
  double rate = 0, distance = 0;
  for (const MotionPoint& at : motion_table(definition)) rate = std::max(rate, std::abs(at.rate));
  const RollDefinition& roll = *definition.motion.roll;
  for (const double x : {0.0, definition.tank.length})
    for (const double z : {0.0, definition.tank.height})
      distance = std::max(distance, std::hypot(x - roll.axis_x, z - roll.axis_z));
  return 2 * rate * rate * distance;
}

}  // namespace slosh
