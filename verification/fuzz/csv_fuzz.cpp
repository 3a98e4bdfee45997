// Any bytes as each of the tables that a user supplies: numbers or a CaseFileError.
#include "verification/case_file/motion_table.hpp"
#include "verification/case_file/peak_table.hpp"
#include "verification/case_file/time_table.hpp"
#include "verification/fuzz/memory_file.hpp"

namespace {

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const slosh::CaseFileError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static slosh::MemoryFile file;
  file.replace(bytes, count);
  const auto path = file.path();
  read_or_refuse([&] { slosh::read_time_table(path, {"displacement_m", "elevation_m"}); });
  read_or_refuse([&] { slosh::read_time_columns(path, {"t_s", "p_Pa", "Pa"}); });
  read_or_refuse([&] { slosh::read_surge_table(path, 1.0); });
  read_or_refuse([&] { slosh::read_roll_table(path, 1.0); });
  read_or_refuse([&] { slosh::read_peak_table(path); });
  return 0;
}
