#include <fmt/format.h>

#include <optional>

#include "reference/section/section_roll.hpp"
#include "reference/section/section_surge.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/theory/motion_samples.hpp"
#include "verification/solvers/theory/sampled_flow.hpp"

namespace slosh {
namespace {

std::optional<reference::SectionRoll> roll_of(const reference::SectionModes& modes,
                                              const CaseDefinition& definition) {
  const std::optional<RollMotion> roll = roll_motion(definition);
  if (!roll) return {};
  return reference::SectionRoll(modes, start_of(definition),
                                {roll->angle,
                                 roll->rate,
                                 roll->acceleration,
                                 {roll->axis_x, roll->axis_z},
                                 definition.duration,
                                 motion_step(definition),
                                 motion_knots(definition.motion.roll->angle, definition.duration)});
}

class FlowInOutline : public SampledFlow {
 public:
  FlowInOutline(const LinearRun& linear, const CaseDefinition& definition)
      : SampledFlow(definition),
        modes_(section_of(definition), linear.modes),
        surges_(surges_of<reference::SectionSurge>(definition,
                                                   [&](const auto& motion) {
                                                     return reference::SectionSurge(
                                                         modes_, start_of(definition), motion);
                                                   })),
        roll_(roll_of(modes_, definition)) {}

  std::vector<double> elevation(double x) const override {
    std::vector<double> sum(times_.size(), 0.0);
    for (const auto& surge : surges_) add(sum, surge.elevation(x, times_));
    if (roll_) add(sum, roll_->elevation(x, times_));
    return sum;
  }

  std::vector<double> pressure(Corner place) const override {
    std::vector<double> sum(times_.size(), 0.0);
    for (const auto& surge : surges_) add(sum, surge.pressure(place.x, place.z, times_));
    if (roll_) add(sum, roll_->pressure(place.x, place.z, times_));
    const double still = definition_.liquid.density * definition_.gravity *
                         (definition_.liquid.fill_depth - place.z);
    const int counted = static_cast<int>(surges_.size()) + roll_.has_value();
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
      double sum = roll_ ? roll_->force(t).x : 0;
      for (const auto& surge : surges_) sum += surge.horizontal_force(t);
      return sum;
    });
  }
  bool has_moment() const override { return roll_ && surges_.empty(); }
  std::vector<double> moment() const override {
    return series([&](double t) { return roll_->moment(t); });
  }

  std::string modes_text() const override {
    return fmt::format("{} modes of the tank's section, by spectral elements", modes_.count());
  }

 private:
  template <class Component>
  std::vector<double> velocity(Corner place, const Component& of) const {
    return series([&](double t) {
      double sum = roll_ ? of(roll_->velocity(place.x, place.z, t)) : 0;
      for (const auto& surge : surges_) sum += of(surge.velocity(place.x, place.z, t));
      return sum;
    });
  }

  reference::SectionModes modes_;
  std::vector<reference::SectionSurge> surges_;
  std::optional<reference::SectionRoll> roll_;
};

}  // namespace

std::unique_ptr<LinearFlow> linear_flow_in_outline(const LinearRun& linear,
                                                   const CaseDefinition& definition) {
  return std::make_unique<FlowInOutline>(linear, definition);
}

}  // namespace slosh
