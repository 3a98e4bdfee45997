#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "reference/section/section_modes.hpp"
#include "reference/section/section_surge.hpp"
#include "reference/section/section_wave.hpp"
#include "reference/section/slabs.hpp"
#include "reference/tests/sections.hpp"

namespace slosh::reference::section_outline_test {
namespace {

// Returns the message with which the section is refused.
std::string refusal(const Section& section) {
  try {
    slabs_of(section, "Test");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SectionOutline, IsCutAtTheHeightsOfItsCorners) {
  const auto slabs = slabs_of(skewed(), "Test");
  ASSERT_EQ(slabs.size(), 4);
  EXPECT_TRUE(slabs[0].pointed());
  EXPECT_DOUBLE_EQ(slabs[0].left_bottom, 0.3);
  EXPECT_DOUBLE_EQ(slabs[0].right_top, 0.9);
  EXPECT_DOUBLE_EQ(slabs[1].bottom, 0.1);
  EXPECT_DOUBLE_EQ(slabs[1].left_top, 0.1);
  EXPECT_NEAR(slabs[1].right_top, 1.1, 1e-15);
  EXPECT_DOUBLE_EQ(slabs[3].bottom, 0.4);
  EXPECT_DOUBLE_EQ(slabs[3].top, 0.6);
  EXPECT_NEAR(slabs[3].left_top, 0.05, 1e-15);
  EXPECT_NEAR(slabs[3].right_top, 1.15, 1e-15);
}

TEST(SectionOutline, IsRefusedWithTheValueAndWhatWasExpected) {
  const std::vector<Corner> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto refused = [](const std::vector<Corner>& outline, double fill_depth) {
    return refusal(with_outline(outline, fill_depth));
  };
  EXPECT_EQ(refused(square, 0.5), "accepted");
  EXPECT_EQ(refused({{0, 0}, {1, 0}}, 0.5), "Test: number of corners = 2, expected 3 or more");
  EXPECT_EQ(refused({{0, 1}, {1, 1}, {1, 0}, {0, 0}}, 0.5),
            "Test: area = -1, expected corners in counter-clockwise order, with an area > 0 m2");
  EXPECT_EQ(refused({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, 0.5),
            "Test: edges that meet = 2 and 4, expected an outline that does not cross or touch "
            "itself");
  EXPECT_EQ(refused(square, 1),
            "Test: fill depth = 1, expected a depth between 0 and the section's height, 1 m");
  EXPECT_NE(refused(square, 0), "accepted");
  EXPECT_NE(refused(square, std::numeric_limits<double>::quiet_NaN()), "accepted");
  EXPECT_NE(refused({{0, 0}, {1, 0}, {1, NAN}, {0, 1}}, 0.5), "accepted");
  EXPECT_NE(refused({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, 0.5), "accepted");
}

TEST(SectionOutline, MayNotPartTheLiquid) {
  const std::vector<Corner> two_troughs{{0, 1}, {0.2, 0}, {0.5, 0.4}, {0.8, 0}, {1, 1}};
  EXPECT_EQ(
      refusal(with_outline(two_troughs, 0.6)),
      "Test: number of walls = 4 at z = 0.2 m, expected 2 at every height below the still surface");
  const std::vector<Corner> step{{0, 0}, {0.5, 0}, {0.5, 0.4}, {1, 0.4}, {1, 1}, {0, 1}};
  EXPECT_EQ(refusal(with_outline(step, 0.6)),
            "Test: horizontal ledge = 0.5 m wide at z = 0.4 m, expected no horizontal edge between "
            "the bottom and the still "
            "surface");
  // Above the still surface neither matters.
  EXPECT_EQ(refusal(with_outline(step, 0.3)), "accepted");
  EXPECT_EQ(refusal(with_outline({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.7}, {0, 1}}, 0.6)), "accepted");
}

TEST(SectionOutline, BoundsModesAndPositions) {
  EXPECT_THROW(SectionModes(vee(1), 0), std::invalid_argument);
  EXPECT_THROW(SectionModes(vee(1), 151), std::invalid_argument);
  const SectionModes modes(vee(1), 3);
  EXPECT_EQ(modes.count(), 3);
  EXPECT_DOUBLE_EQ(modes.left(), 1);
  EXPECT_DOUBLE_EQ(modes.right(), 3);
  EXPECT_DOUBLE_EQ(modes.still_level(), 1);
  EXPECT_THROW(modes.angular_frequency(0), std::invalid_argument);
  EXPECT_THROW(modes.angular_frequency(4), std::invalid_argument);
  EXPECT_THROW(modes.shape(1, 0.99), std::invalid_argument);
  EXPECT_THROW(modes.shape(1, NAN), std::invalid_argument);
  const SectionWave wave(modes, 1, 0.1);
  EXPECT_THROW(wave.pressure(1.2, 0.5, 0), std::invalid_argument);  // beside the inclined wall
  EXPECT_THROW(wave.pressure(2, 1.01, 0), std::invalid_argument);
  EXPECT_THROW(wave.pressure(2, -0.01, 0), std::invalid_argument);
  EXPECT_THROW(wave.elevation(2, -1), std::invalid_argument);
  EXPECT_NO_THROW(wave.pressure(2, 0, 0));
  EXPECT_THROW(SectionWave(modes, 4, 0.1), std::invalid_argument);
  EXPECT_THROW(SectionSurge(modes, Start::tank, {.amplitude = 1, .angular_frequency = 0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace slosh::reference::section_outline_test
