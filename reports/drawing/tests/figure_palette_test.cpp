// The colours as people with and without full colour vision tell them apart.
#include "reports/drawing/figure_palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace slosh::reports::figure_palette_test {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

// Machado, Oliveira & Fernandes 2009 (IEEE TVCG 15:1291), severity 1, in linear sRGB.
constexpr std::array<Matrix, 4> kinds_of_vision{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                                 {{{0.152286, 1.052583, -0.204868},
                                                   {0.114503, 0.786281, 0.099216},
                                                   {-0.003882, -0.048116, 1.051998}}},
                                                 {{{0.367322, 0.860646, -0.227968},
                                                   {0.280085, 0.672501, 0.047413},
                                                   {-0.011820, 0.042940, 0.968881}}},
                                                 {{{1.255528, -0.076749, -0.178779},
                                                   {-0.078411, 0.930809, 0.147602},
                                                   {0.004733, 0.691367, 0.303900}}}}};

constexpr Matrix xyz_of_rgb{{{0.4124564, 0.3575761, 0.1804375},
                             {0.2126729, 0.7151522, 0.0721750},
                             {0.0193339, 0.1191920, 0.9503041}}};

Triple product(const Matrix& matrix, const Triple& vector) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += matrix[i][j] * vector[j];
  return result;
}

Triple linear_rgb(const std::string& colour) {
  Triple rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    rgb[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

Triple lab(Triple rgb) {
  for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
  const Triple xyz = product(xyz_of_rgb, rgb), white{0.95047, 1, 1.08883};
  Triple f{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = xyz[i] / white[i];
    f[i] = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

// The smallest distance of the two colours in CIELAB, over all kinds of colour vision.
double distance(const std::string& one, const std::string& other) {
  double smallest = INFINITY;
  for (const Matrix& vision : kinds_of_vision) {
    const Triple a = lab(product(vision, linear_rgb(one))),
                 b = lab(product(vision, linear_rgb(other)));
    smallest = std::min(smallest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  return smallest;
}

double contrast(const std::string& one, const std::string& other) {
  const double a = product(xyz_of_rgb, linear_rgb(one))[1],
               b = product(xyz_of_rgb, linear_rgb(other))[1];
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

std::vector<std::string> curve_colours(const char* PaletteColour::*scheme) {
  std::vector<std::string> colours;
  for (const PaletteColour& one : hues) colours.emplace_back(one.*scheme);
  for (const PaletteColour& one : reference_colours) colours.emplace_back(one.*scheme);
  return colours;
}

TEST(CurveColours, AreToldApartWithAnyColourVisionOnEitherPaper) {
  for (const auto scheme : {&PaletteColour::light, &PaletteColour::dark}) {
    const std::vector<std::string> colours = curve_colours(scheme);
    for (std::size_t i = 0; i < colours.size(); ++i) {
      EXPECT_GE(contrast(colours[i], paper.*scheme), 3) << colours[i];
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(distance(colours[i], colours[j]), 12) << colours[i] << " and " << colours[j];
    }
  }
}

// The purple that the palette had beside a grey: equal to those who see no green.
TEST(CurveColours, WouldFailWithAPairThatOnlySomeTellApart) {
  EXPECT_LT(distance("#a63d80", "#67727e"), 12);
  EXPECT_LT(contrast("#f0e442", "#ffffff"), 3);
}

}  // namespace
}  // namespace slosh::reports::figure_palette_test
