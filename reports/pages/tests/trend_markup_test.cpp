#include "reports/pages/trend_markup.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <regex>

namespace slosh::reports {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Trend trend() {
  return {{{0.0, 0.5, -1, 1, true}, {0.5, 0.25, -1, 1, false}, {1.0, 0, -1, 1, false}},
          "approved 2026-01-02: 0 -> 1",
          true};
}

// The places of a polygon or polyline, as text.
std::string points_of(const std::string& markup, const std::string& element) {
  std::smatch found;
  const std::regex pattern("<" + element + "[^>]* points=\"([^\"]*)\"");
  return std::regex_search(markup, found, pattern) ? found[1].str() : "";
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(TrendMarkup, PutsTheValuesOnOneScaleWithTheirTolerance) {
  const std::string markup = trend_markup(trend());
  EXPECT_EQ(points_of(markup, "polyline"), "4.0,15.0 60.0,9.5 116.0,4.0 ");
  EXPECT_EQ(points_of(markup, "polygon"),
            "4.0,4.0 60.0,4.0 116.0,4.0 116.0,26.0 60.0,26.0 4.0,26.0 ");
  EXPECT_NE(markup.find("<path d=\"M4.0 20.5V9.5\"/>"), std::string::npos) << markup;
}

TEST(TrendMarkup, MarksTheApprovedValuesAndThePresentOne) {
  const std::string markup = trend_markup(trend());
  EXPECT_EQ(count(markup, "<circle"), 2u);
  EXPECT_EQ(count(markup, "<path"), 2u);  // the present value has no interval
}

TEST(TrendMarkup, ShowsItsWordsOnlyWhereTheValueHasChanged) {
  Trend one = trend();
  EXPECT_EQ(count(trend_markup(one), "0 -&gt; 1"), 2u) << trend_markup(one);
  one.has_changed = false;
  EXPECT_EQ(count(trend_markup(one), "0 -&gt; 1"), 1u);  // the picture's name
}

TEST(TrendMarkup, DrawsAToleranceWithoutAnEndToTheEdge) {
  Trend one = trend();
  for (Trend::Point& point : one.points) {
    point.lower = -unbounded;
    point.upper = 2;
  }
  EXPECT_EQ(points_of(trend_markup(one), "polygon"),
            "4.0,4.0 60.0,4.0 116.0,4.0 116.0,30.0 60.0,30.0 4.0,30.0 ");
}

TEST(TrendMarkup, DrawsEqualValuesWithoutToleranceInTheMiddle) {
  const Trend one{{{3, 0, -unbounded, unbounded, false}, {3, 0, -unbounded, unbounded, false}}};
  EXPECT_EQ(points_of(trend_markup(one), "polyline"), "4.0,15.0 116.0,15.0 ");
  EXPECT_EQ(points_of(trend_markup(one), "polygon"), "");
}

TEST(TrendMarkup, IsEmptyWithoutValues) { EXPECT_EQ(trend_markup({}), ""); }

}  // namespace
}  // namespace slosh::reports
