// A tank's motion as a table: a CSV file whose first line is "time_s,displacement_m" of a surge,
// "time_s,angle_deg" of a roll.
#pragma once

#include <filesystem>
#include <numbers>

#include "verification/case/case_definition.hpp"

namespace slosh {

// A turn further than once around is a slip of the unit [deg].
inline constexpr double largest_angle = 360;

inline constexpr double radians_per_degree = std::numbers::pi / 180;

// At least four rows, times strictly increasing from 0 to at least the case's duration [s]; a roll
// starts level, at 0 to within 1e-3 deg. Throw CaseFileError with the CSV file's own file:line.
TableMotion read_surge_table(const std::filesystem::path& file, double duration);
TableMotion read_roll_table(const std::filesystem::path& file, double duration);

}  // namespace slosh
