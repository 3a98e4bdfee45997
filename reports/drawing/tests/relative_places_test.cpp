#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::relative_places_test {
namespace {

using Places = std::vector<std::pair<double, double>>;

// A wave of 1000 places whose hundredths of a pixel are of no rule.
Places wave() {
  Places places;
  for (int i = 0; i < 1000; ++i)
    places.emplace_back(84.5 + 0.4481 * i, 220 + 150.37 * std::sin(0.07 * i));
  return places;
}

// As gnuplot writes them: with a command at each place, or with none in a polygon.
std::string absolute(const Places& places, bool with_commands = true) {
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
    text += fmt::format("{}{:.2f},{:.2f}{}",
                        !with_commands ? ""
                        : i == 0       ? "M"
                                       : "L",
                        places[i].first, places[i].second, i % 4 == 3 ? "\n\t\t" : " ");
  return text;
}

// The places of a path of one M and one l, read as SVG 1.1 (8.3) reads them.
Places places_of(std::string path) {
  EXPECT_EQ(path.front(), 'M');
  EXPECT_EQ(path.find('l'), path.rfind('l'));
  for (const auto& [from, to] : {std::pair{"M", " "}, {"l", " "}, {"z", ""}, {"-", " -"}})
    boost::replace_all(path, from, to);
  std::istringstream numbers(path);
  Places places;
  for (double x = 0, z = 0; numbers >> x >> z;)
    places.empty() ? places.emplace_back(x, z)
                   : places.emplace_back(places.back().first + x, places.back().second + z);
  return places;
}

void expect_near(const Places& read, const Places& expected) {
  ASSERT_EQ(read.size(), expected.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_NEAR(read[i].first, expected[i].first, 0.056) << i;
    EXPECT_NEAR(read[i].second, expected[i].second, 0.056) << i;
  }
}

std::string path_data(const std::string& tag) {
  const auto start = tag.find(" d='") + 4;
  return tag.substr(start, tag.find('\'', start) - start);
}

TEST(RelativePlaces, AreWithinATenthOfAPixelAlongALongLineAndAPolygonThatIsClosed) {
  const std::string fill = " fill = '#0069a8' fill-opacity = '0.16' ";
  for (const bool polygon : {false, true}) {
    const std::string tag = (polygon ? "<polygon" : "<path") + fill +
                            (polygon ? "points = '" : "d='") + absolute(wave(), !polygon) + "'/>";
    const std::string relative = with_relative_places(tag);
    expect_near(places_of(path_data(relative)), wave());
    EXPECT_LT(relative.size(), tag.size() * 0.55);
    EXPECT_TRUE(begins(relative, "<path" + fill + "d='M84.5 220l"));
    EXPECT_TRUE(relative.ends_with(polygon ? "z'/>" : "'/>"));
  }
}

TEST(RelativePlaces, KeepTheGapsOfALineAndArePrintedWithoutNeedlessDigits) {
  const std::string line = absolute(wave()),
                    one = path_data(with_relative_places("<path d='" + line + "'/>"));
  EXPECT_EQ(path_data(with_relative_places("<path d='" + line + line + "M1,2 M3,4 '/>")),
            one + one + "M1 2M3 4");
  std::string places = "M0.04,-0.06 L0.50,0.50 L-0.5,10 ";
  for (int i = 0; i < 40; ++i) places += "L-0.5,10 ";
  EXPECT_TRUE(begins(path_data(with_relative_places("<path d='" + places + "'/>")),
                     "M0-.1l.5 .6-1 9.5 0 0 0 0"));
}

TEST(RelativePlaces, LeaveWhatTheyCannotOrNeedNotShorten) {
  const Places line = wave(), few(line.begin(), line.begin() + 20);
  for (const std::string& tag :
       {"<path d='" + absolute(few) + "'/>", "<polygon points = '" + absolute(few, false) + "'/>",
        "<path d='" + absolute(line) + "h2'/>", "<path d='" + absolute(line) + "Lx,y'/>",
        "<path d='" + absolute(line) + "L1.2'/>", "<path d='" + absolute(line) + "z'/>",
        "<text d='" + absolute(line) + "'>", std::string("<path stroke='none'/>"),
        std::string("<path d='M0,1.330 L1.265,0.411 L0.782,-1.067 z'/>")})
    EXPECT_EQ(with_relative_places(tag), tag) << tag.substr(0, 60);
}

}  // namespace
}  // namespace slosh::reports::relative_places_test
