// What the report tells of the papers' schemes is what they are made of.
#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "sph/schemes.hpp"
#include "verification/papers/paper.hpp"

namespace slosh::deviations_test {
namespace {

// The deviations as they are told, against the schemes themselves.
TEST(Deviations, AreThoseOfTheSchemes) {
  using sph::Li2010, sph::Zhao2021Moving;
  static_assert(Li2010::numbers.smoothing_length_ratio == 1.5 &&
                Li2010::numbers.sound_speed_ratio == 10 &&
                Li2010::numbers.artificial_viscosity == 1 && !Li2010::TimeStep::adapts);
  static_assert(Li2010::TimeStep::step == 0.5e-3);
  static_assert(std::is_same_v<Li2010::Integrator, sph::PredictorCorrector> &&
                std::is_same_v<Li2010::Mirror, sph::NoSlipMirror> &&
                std::is_same_v<Li2010::WallContact, sph::RepulsiveWall>);
  static_assert(Zhao2021Moving::numbers.smoothing_length_ratio == 1.5 &&
                Zhao2021Moving::numbers.sound_speed_ratio == 10 &&
                Zhao2021Moving::numbers.courant_number == 0.2 &&
                Zhao2021Moving::numbers.artificial_viscosity == 0.1);
  static_assert(std::is_same_v<Zhao2021Moving::Solids, sph::DynamicSolids> &&
                std::is_same_v<Zhao2021Moving::WallContact, sph::ReflectingWall> &&
                std::is_same_v<Zhao2021Moving::EquationOfState, sph::Tait>);
  EXPECT_EQ(sph::Tait(1000, 30).pressure(1000.0), 0) << "no p_atm";
  sph::Setting setting{};
  setting.gravity = 9.81;
  setting.fill_depth = 0.35;
  setting.flattest_cell = 1;
  const sph::RepulsiveWall wall(setting);
  EXPECT_EQ(wall.strength, 5 * 9.81 * 0.35);
  EXPECT_EQ(wall.range, 0.5) << "the pitch in particle spacings";
  for (const char* paper : {"li2010", "zhao2021"}) {
    const auto& deviations = paper_named(paper).deviations;
    EXPECT_GE(deviations.size(), 10u);
    for (const Deviation& one : deviations) EXPECT_FALSE(one.here.empty()) << one.printed;
  }
}

}  // namespace
}  // namespace slosh::deviations_test
