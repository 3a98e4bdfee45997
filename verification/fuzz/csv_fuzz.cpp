// Any bytes as each of the tables that a user supplies or another program wrote: numbers, a
// CaseFileError or, of an import, a ResultError.
#include "verification/case_file/case_sections.hpp"
#include "verification/fuzz/memory_file.hpp"
#include "verification/import/file_formats.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/tables/time_table.hpp"
#include "verification/results/result_file.hpp"

namespace {

// The elevation from a table of this format: from the column that its row gives as an example, or
// from one that the corpus has.
slosh::SeriesSource source_of(const slosh::FileFormat& format, const std::filesystem::path& file) {
  const bool is_named = format.time_column == slosh::TimeColumn::must_be_named;
  return {.quantity = "elevation@right",
          .file = file,
          .format = format.name,
          .column = is_named ? "eta" : format.example,
          .unit = "m",
          .time_column = is_named ? "t_s" : ""};
}

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
  read_or_refuse([&] {
    slosh::read_time_columns(path, {"t_s", "p_Pa", {"unit", "Pa", "pressure", "Pa"}});
  });
  read_or_refuse([&] { slosh::read_surge_table({path, 1.0, 0}); });
  read_or_refuse([&] { slosh::read_roll_table({path, 1.0, -0.1}); });
  read_or_refuse([&] { slosh::read_peak_table(path); });
  for (const slosh::FileFormat& format : slosh::file_formats())
    if (format.read_head) read_or_refuse([&] { slosh::import_series(source_of(format, path)); });
  return 0;
}
