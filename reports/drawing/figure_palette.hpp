// The colours and dashes of the figures, on white paper and on dark.
//
// The hues are Okabe & Ito's (Color Universal Design, 2008) blue, vermillion, green and sky blue,
// with a violet and a brown, which is gold on dark paper. Each has a contrast of at least 3:1 to
// its paper (WCAG 2.1, 1.4.11). Any two of them and of the references' black and grey differ by at
// least 12 CIELAB units, with full colour vision and in Machado's (2009) simulations of protanopia,
// deuteranopia and tritanopia. Dashes and point types tell curves apart without any colour.
#pragma once

#include <array>

namespace slosh::reports {

// One role in both schemes, as #rrggbb. The SVG carries the light colour; dark_rules() (in
// draw_figure.hpp) replace it by the dark one.
struct PaletteColour {
  const char* light;
  const char* dark;
};

inline constexpr PaletteColour paper{"#ffffff", "#12161b"};
inline constexpr PaletteColour ink{"#1f2933", "#e4e8ec"};        // text, axes
inline constexpr PaletteColour faint_ink{"#67727e", "#9aa5b1"};  // markers, zero line
inline constexpr PaletteColour grid{"#e3e7eb", "#2b323a"};

inline constexpr std::array<PaletteColour, 6> hues{{{"#0069a8", "#3f97dc"},
                                                    {"#d55e00", "#f07a35"},
                                                    {"#00936b", "#1fae84"},
                                                    {"#8800d0", "#a060ff"},
                                                    {"#803000", "#e8c800"},
                                                    {"#3d9ad6", "#9fd8ff"}}};

// Theory, records, and whatever else the runs are compared with.
inline constexpr std::array<PaletteColour, 2> reference_colours{ink, faint_ink};

inline constexpr std::array<PaletteColour, 3> band_colours{
    {{"#00936b", "#1fae84"}, {"#3d9ad6", "#9fd8ff"}, {"#a88400", "#e8bc3c"}}};

// A scalar of a flow field, from low to high: viridis at tenths (S. van der Walt and N. Smith,
// 2015; the ten colours as in R's viridisLite), perceptually uniform and monotonous in lightness
// for those with colour blindness too; between them colours are mixed linearly. The same on every
// paper: these pictures bring their own.
inline constexpr std::array<const char*, 10> field_colours{
    "#440154", "#482878", "#3e4a89", "#31688e", "#26828e",
    "#1f9e89", "#35b779", "#6dcd59", "#b4de2c", "#fde725"};

// gnuplot dash types. The curves of one style take them in turn: lines have short gaps, dashed
// curves long ones.
inline constexpr std::array<const char*, 4> line_dashes{"solid", "(14,3)", "(14,3,2,3)",
                                                        "(24,3,2,3,2,3)"};
inline constexpr std::array<const char*, 4> dashed_dashes{"(6,4)", "(2,3)", "(6,3,2,3)", "(9,6)"};

// gnuplot point types: filled circle, square, triangle, diamond and inverted triangle, then hollow.
inline constexpr std::array<int, 10> point_types{7, 5, 9, 13, 11, 6, 4, 8, 12, 10};

// Those of the references, hollow first: circle, square, triangle, diamond, inverted triangle.
inline constexpr std::array<int, 10> reference_points{6, 4, 8, 12, 10, 7, 5, 9, 13, 11};

inline constexpr double band_opacity =
    0.16;  // two nested bands stay apart, and the grid shows through

}  // namespace slosh::reports
