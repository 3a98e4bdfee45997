#include <fmt/format.h>

#include <optional>
#include <utility>

#include "reference/linear_roll.hpp"
#include "reference/linear_surge.hpp"
#include "reference/standing_wave.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/theory/motion_samples.hpp"
#include "verification/solvers/theory/sampled_flow.hpp"

namespace slosh {
namespace {

std::optional<reference::Gas> gas_of(const LinearRun& linear, const CaseDefinition& definition) {
  return linear.two_layer ? std::optional(gas_of(definition)) : std::nullopt;
}

// Returns the solution for the motion, with the gas where the run counts it.
template <class Solution, class Motion>
Solution solution(const LinearRun& linear, const CaseDefinition& definition, const Motion& motion) {
  const auto gas = gas_of(linear, definition);
  if (!gas) return {tank_of(definition), start_of(definition), motion, linear.modes};
  return {tank_of(definition), *gas, start_of(definition), motion, linear.modes};
}

std::optional<reference::LinearRoll> roll_of(const LinearRun& linear,
                                             const CaseDefinition& definition) {
  const std::optional<RollMotion> roll = roll_motion(definition);
  if (!roll) return {};
  return solution<reference::LinearRoll>(
      linear, definition,
      reference::RollMotion{
          roll->angle, roll->rate, roll->acceleration, roll->axis_x - definition.tank.length / 2,
          roll->axis_z - definition.liquid.fill_depth, definition.duration, motion_step(definition),
          motion_knots(definition.motion.roll->angle, definition.duration)});
}

std::optional<reference::StandingWave> wave_of(const LinearRun& linear,
                                               const CaseDefinition& definition) {
  if (!definition.initial_wave) return {};
  return reference::StandingWave(
      tank_of(definition), gas_of(linear, definition),
      {definition.initial_wave->mode, definition.initial_wave->amplitude});
}

class FlowInRectangle : public SampledFlow {
 public:
  FlowInRectangle(const LinearRun& linear, const CaseDefinition& definition)
      : SampledFlow(definition),
        modes_(linear.modes),
        surges_(surges_of<reference::LinearSurge>(definition,
                                                  [&](const auto& motion) {
                                                    return solution<reference::LinearSurge>(
                                                        linear, definition, motion);
                                                  })),
        roll_(roll_of(linear, definition)),
        wave_(wave_of(linear, definition)) {}

  std::vector<double> elevation(double x) const override {
    const double from_centre = x - definition_.tank.length / 2;
    std::vector<double> sum(times_.size(), 0.0);
    for (const auto& surge : surges_) add(sum, surge.elevation(from_centre, times_));
    if (roll_) add(sum, roll_->elevation(from_centre, times_));
    if (wave_) add(sum, series([&](double t) { return wave_->elevation(from_centre, t); }));
    return sum;
  }

  std::vector<double> pressure(Corner place) const override {
    const auto [x, z] = from_still_centre(place);
    std::vector<double> sum(times_.size(), 0.0);
    if (roll_) add(sum, roll_->pressure(x, z, times_));
    for (const auto& surge : surges_)
      add(sum, series([&, x = x, z = z](double t) { return surge.pressure(x, z, t); }));
    if (wave_) add(sum, series([&, x = x, z = z](double t) { return wave_->pressure(x, z, t); }));
    const double still = -definition_.liquid.density * definition_.gravity * z;
    const int counted = static_cast<int>(surges_.size()) + roll_.has_value() + wave_.has_value();
    for (double& value : sum) value -= (counted - 1) * still;
    return sum;
  }

  std::vector<double> velocity_x(Corner place) const override {
    return velocity(place, [](const auto& one) { return one.x; });
  }
  std::vector<double> velocity_z(Corner place) const override {
    return velocity(place, [](const auto& one) { return one.z; });
  }

  std::vector<double> force_x() const override {
    return series([&](double t) {
      double sum = (roll_ ? roll_->force(t).x : 0) + (wave_ ? wave_->horizontal_force(t) : 0);
      for (const auto& surge : surges_) sum += surge.horizontal_force(t);
      return sum;
    });
  }
  bool has_moment() const override { return roll_ && surges_.empty() && !wave_; }
  std::vector<double> moment() const override {
    return series([&](double t) { return roll_->moment(t); });
  }

  std::string modes_text() const override { return fmt::format("{} antisymmetric modes", modes_); }

 private:
  Corner from_still_centre(Corner place) const {
    return {place.x - definition_.tank.length / 2, place.z - definition_.liquid.fill_depth};
  }

  template <class Component>
  std::vector<double> velocity(Corner place, const Component& of) const {
    const Corner at = from_still_centre(place);
    return series([&](double t) {
      double sum = (roll_ ? of(roll_->velocity(at.x, at.z, t)) : 0) +
                   (wave_ ? of(wave_->velocity(at.x, at.z, t)) : 0);
      for (const auto& surge : surges_) sum += of(surge.velocity(at.x, at.z, t));
      return sum;
    });
  }

  int modes_;
  std::vector<reference::LinearSurge> surges_;
  std::optional<reference::LinearRoll> roll_;
  std::optional<reference::StandingWave> wave_;
};

}  // namespace

std::unique_ptr<LinearFlow> linear_flow_in_rectangle(const LinearRun& linear,
                                                     const CaseDefinition& definition) {
  return std::make_unique<FlowInRectangle>(linear, definition);
}

}  // namespace slosh
