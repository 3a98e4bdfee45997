// The drawings of a case file: the tank to scale, and its motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/drawing/figure_layout.hpp"
#include "reports/figures/case_figures.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::case_drawings_test {
namespace {

const reports::Curve& named(const reports::Figure& figure, const std::string& begin) {
  for (const reports::Curve& curve : figure.curves)
    if (curve.label.starts_with(begin)) return curve;
  throw std::out_of_range("no curve " + begin);
}

CaseDefinition tanker() {
  CaseDefinition definition = surge_case();
  definition.tank.length = 12;
  definition.tank.height = 2.4;
  definition.tank.outline = {{1, 0}, {11, 0}, {12, 1}, {12, 2.4}, {0, 2.4}, {0, 1}};
  definition.liquid.fill_depth = 0.5;
  definition.gauges = {{"right", 11.9}};
  definition.pressure_gauges = {{.name = "A", .wall = {}, .position = 0, .at = Corner{12, 1.5}}};
  definition.probes = {{"P", 6, 0.2}};
  definition.motion.surge = SineMotion{0.5, 1.5};
  return definition;
}

TEST(TankFigure, HasTheOutlineTheLiquidTheGaugesAndTheMotion) {
  CaseDefinition definition = tanker();
  const reports::Figure figure = tank_figure(definition);
  EXPECT_EQ(named(figure, "tank").x, (std::vector<double>{1, 11, 12, 12, 0, 0, 1}));
  const reports::Curve& liquid = named(figure, "liquid at the start, 0.5 m deep");
  EXPECT_EQ(liquid.lower[100], 0);
  EXPECT_EQ(liquid.upper[100], 0.5);
  EXPECT_TRUE(std::isnan(liquid.y[0])) << "the chamfer's corner is dry";
  EXPECT_EQ(named(figure, "pressure sensors A").y, std::vector<double>{1.5});
  EXPECT_EQ(named(figure, "probes P").x, std::vector<double>{6});
  ASSERT_EQ(figure.markers.size(), 1u);
  EXPECT_EQ(figure.markers[0].x, 11.9);
  EXPECT_NEAR(std::abs(named(figure, "the tank at").x[0] - 1), 0.5, 1e-4);
  EXPECT_TRUE(holds(figure.caption, "; at most 0.5 m, 0.75 m/s and 1.12 m/s2"));
  definition.motion.roll = RollDefinition{SineMotion{0.1, 1}, 6, 1};
  EXPECT_EQ(named(tank_figure(definition), "axis of the roll").x, std::vector<double>{6});
}

TEST(TankFigure, IsToScaleAndNotStretchedByAFarAxisOrALongWay) {
  CaseDefinition definition = tanker();
  const auto shape = [&] {
    const reports::Figure figure = tank_figure(definition);
    EXPECT_TRUE(figure.to_scale);
    return (figure.x_range.second - figure.x_range.first) /
           (figure.y_range.second - figure.y_range.first);
  };
  const double own = shape();
  definition.motion.surge = SineMotion{100, 0.5};
  definition.motion.roll = RollDefinition{SineMotion{1e-6, 1}, 6, -1000};
  EXPECT_NEAR(shape(), own, 0.4);
  EXPECT_LT(reports::canvas_of(tank_figure(definition)).plot_height, 220);
  definition.tank.outline = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
  definition.tank.height = 12;
  EXPECT_GT(reports::canvas_of(tank_figure(definition)).plot_height, 400);
}

TEST(MotionFigures, ShowPositionSpeedAndAccelerationWithTheirPeaks) {
  CaseDefinition definition = tanker();
  const std::vector<reports::Figure> figures = motion_figures(definition);
  ASSERT_EQ(figures.size(), 3u);
  const reports::Figure& last = figures[2];
  EXPECT_EQ(last.y_label, "surge acceleration [m/s2]");
  const reports::Curve& peak = named(last, "peak, ");
  EXPECT_NEAR(std::abs(peak.y.at(0)), 0.5 * 1.5 * 1.5, 1e-3);
  const auto& y = last.curves[0].y;
  EXPECT_EQ(std::abs(peak.y[0]), std::max(*std::max_element(y.begin(), y.end()),
                                          -*std::min_element(y.begin(), y.end())));
  definition.motion = {};
  EXPECT_TRUE(motion_figures(definition).empty());
}

}  // namespace
}  // namespace slosh::case_drawings_test
