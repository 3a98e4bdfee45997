// The angles of a roll that a case may ask for.
#pragma once

namespace slosh {

// [deg]. A larger angle is more than one turn, and probably given in another unit.
inline constexpr double largest_angle = 360;

// [deg]. The tank starts level. The tolerance is far above rounding errors and far below any roll.
inline constexpr double level_angle = 1e-3;

}  // namespace slosh
