// Any bytes as each of the tables that a user supplies or another program wrote: numbers, a
// CaseFileError or, of an import, a ResultError.
#include "verification/case_file/motion_table.hpp"
#include "verification/fuzz/memory_file.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/peak_table.hpp"
#include "verification/input/time_table.hpp"
#include "verification/results/result_file.hpp"

namespace {

struct Import {
  const char *format, *column, *time;
};
constexpr Import imports[] = {{"csv", "eta", "t_s"},
                              {"dualsphysics_gauge", "swlz", ""},
                              {"dualsphysics_points", "Elevation_0", ""},
                              {"openfoam_probes", "probe_0", ""},
                              {"openfoam_interface_height", "hB_0", ""},
                              {"openfoam_field_value", "volAverage(alpha.water)", ""},
                              {"sphinxsys", "Position[0][1]", ""}};

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const slosh::CaseFileError&) {
  } catch (const slosh::ResultError&) {
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
  for (const auto& [format, column, time] : imports)
    read_or_refuse([&, format = format, column = column, time = time] {
      slosh::import_series({.quantity = "elevation@right",
                            .file = path,
                            .format = format,
                            .column = column,
                            .unit = "m",
                            .time_column = time});
    });
  return 0;
}
