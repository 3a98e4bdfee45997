// Files of HDF5 of which a byte was changed: each gives a series or is refused, and none crashes or
// holds up the import.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "verification/files/hdf5_handles.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::hdf5_damage_test {
namespace {

std::string sound_file() {
  std::vector<double> time, value;
  for (int i = 0; i < 100; ++i) {
    time.push_back(0.1 * i);
    value.push_back(0.01 * std::sin(time.back()));
  }
  return hdf5::image_of([&](hid_t root) {
    hdf5::write_attribute(hdf5::write_numbers(root, "time", time), "unit", "s");
    hdf5::write_attribute(hdf5::write_numbers(root, "value", value), "unit", "m");
  });
}

// Every `step`th of 400 files.
void expect_no_crash(std::size_t step) {
  const TemporaryDirectory directory;
  const SeriesSource source{.quantity = "elevation@right",
                            .file = directory.path() / "a.h5",
                            .format = "hdf5",
                            .column = "value",
                            .time_column = "time"};
  const std::string sound = sound_file();
  int taken = 0, refused = 0, ended = 0;
  for (std::size_t i = 0; i < 400; i += step) {
    std::string bytes = sound;
    // What describes the data comes first.
    const std::size_t at = 97 * i % std::min<std::size_t>(bytes.size(), 4096);
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (i % 8)) ^ (i % 3 == 0 ? 0xff : 0));
    std::ofstream(source.file, std::ios::binary) << bytes;
    try {
      EXPECT_EQ(import_series(source).time.size(), 100u);
      ++taken;
    } catch (const CaseFileError& error) {
      ++refused;
      ended += std::string(error.what()).find(": reading it ") != std::string::npos;
      EXPECT_TRUE(std::string(error.what()).starts_with(source.file.string())) << error.what();
    } catch (const ResultError&) {
      ++refused;
    }
  }
  EXPECT_GT(taken, 20 / static_cast<int>(step));
  EXPECT_GT(refused, 20 / static_cast<int>(step));
  // By a crash or a limit; their number is that of HDF5's version.
  testing::Test::RecordProperty("ended", ended);
}

TEST(Hdf5Damage, CrashesNoImportOfFortyFiles) { expect_no_crash(10); }
TEST(Hdf5Damage, CrashesNoImport) { expect_no_crash(1); }

}  // namespace
}  // namespace slosh::hdf5_damage_test
