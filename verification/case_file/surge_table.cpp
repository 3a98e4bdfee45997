#include "verification/case_file/surge_table.hpp"

#include <fmt/format.h>

#include <utility>

#include "verification/case_file/time_table.hpp"

namespace slosh {

TableSurge read_surge_table(const std::filesystem::path& file, double duration) {
  TimeTable table = read_time_table(file, {"displacement_m"});
  constexpr int first_line = 2;
  const int last_line = static_cast<int>(table.time.size()) + 1;
  if (table.time.front() != 0) {
    throw table_error(file, first_line, "time_s", fmt::format("{}", table.time.front()),
                      "0 in the first row, in s");
  }
  if (table.time.back() < duration) {
    throw table_error(
        file, last_line, "time_s", fmt::format("{}", table.time.back()),
        fmt::format("a last time of at least the case's duration ({}), in s", duration));
  }
  return {.file = file, .time = std::move(table.time), .displacement = std::move(table.value)};
}

}  // namespace slosh
