// Which tables the import accepts and which it refuses, with the place and the expected text.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "verification/files/hdf5_handles.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/temporary_directory.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::import_refusal_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* table = "t [s];eta [mm]\n0;1\n0.5;2\n1;3\n1.5;4\n";

SeriesSource csv(const fs::path& file) {
  return {.quantity = "elevation@right",
          .file = file,
          .format = "csv",
          .column = "eta",
          .time_column = "t"};
}

TimeSeries read_csv(const std::string& text) {
  const Workspace workspace;
  return import_series(csv(workspace.write("a.csv", text)));
}

// The message without the directory; it begins with "unusable: " where the numbers cannot be used.
template <class Change>
std::string complaint_of(const std::string& text, Change change) {
  const Workspace workspace;
  SeriesSource source = csv(workspace.write("a.csv", text));
  change(source);
  const auto shortened = [&](std::string message) {
    const std::string directory = workspace.path().string() + "/";
    if (const std::size_t at = message.find(directory); at != message.npos)
      message.erase(at, directory.size());
    return message;
  };
  try {
    import_series(source);
    return "";
  } catch (const CaseFileError& error) {
    return shortened(error.what());
  } catch (const ResultError& error) {
    return "unusable: " + shortened(error.what());
  }
}

void expect_start(const std::string& message, const std::string& wanted) {
  EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
}

TEST(ImportRefusal, NoScaleOrOffsetLeavesValuesThatAreNone) {
  const auto with = [](double scale, double offset) {
    return complaint_of(table, [=](SeriesSource& source) {
      source.scale = scale;
      source.offset = offset;
    });
  };
  expect_start(with(1e300, 0),
               "a.csv: eta = its values times 1e+300 plus 0: expected a scale and an offset that "
               "leave values below 1e+20");
  EXPECT_NE(with(1, -1e300), "");
  EXPECT_NE(with(std::numeric_limits<double>::quiet_NaN(), 0), "");
  EXPECT_EQ(with(-2, 1e3), "");
}

TEST(ImportRefusal, CsvIsReadWhateverPartsItsColumns) {
  const std::vector<double> wanted{0.001, 0.002, 0.003, 0.004};
  EXPECT_EQ(read_csv(table).value, wanted);
  EXPECT_EQ(read_csv("t [s],eta [mm]\r\n0,1\r\n0.5,2\r\n1,3\r\n1.5,4\r\n").value, wanted);
  EXPECT_EQ(read_csv("# t [s]\teta [mm]\n0\t1\n0.5\t2\n1\t3\n1.5\t4\n\n").value, wanted);
  EXPECT_EQ(
      read_csv("\"t [s]\",\"note, any\",\"eta [mm]\"\n0,,1\n0.5,\"a, b\",2\n1,,3\n1.5,,4\n").value,
      wanted);
  EXPECT_EQ(read_csv(table).time, (std::vector<double>{0, 0.5, 1, 1.5}));
}

TEST(ImportRefusal, TheFirstValueIsZeroWhereItIsTheDatum) {
  const Workspace workspace;
  SeriesSource source =
      csv(workspace.write("a.csv", "t [s];eta [mm]\n0;355\n1;357\n2;355\n3;350\n"));
  source.scale = 2;
  source.first_is_zero = true;
  const TimeSeries series = import_series(source);
  const std::vector<double> expected{0, 0.004, 0, -0.01};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(series.value[i], expected[i], 1e-15) << i;
}

TEST(ImportRefusal, UnitsAreTheFilesOrTheUsersAndThenTheSame) {
  const Workspace workspace;
  SeriesSource blanks = csv(workspace.write("a.txt", "t eta\n0 1\n60 2\n120 3\n180 4\n"));
  blanks.unit = "cm";
  blanks.time_unit = "ms";
  blanks.scale = -1;
  blanks.offset = 0.5;
  const TimeSeries series = import_series(blanks);
  EXPECT_DOUBLE_EQ(series.time[1], 0.06);
  EXPECT_DOUBLE_EQ(series.value[1], 0.48);
  blanks.unit.clear();
  blanks.column = "eta [m]";
  EXPECT_DOUBLE_EQ(import_series(blanks).value[0], -0.5);
}

TEST(ImportRefusal, WhatTheUserSaysMustFitTheFile) {
  const auto complaint = [](auto change) { return complaint_of(table, change); };
  expect_start(complaint([](auto& source) { source.format = "cvs"; }),
               "format = cvs: expected one of csv, dualsphysics_gauge, dualsphysics_points, "
               "openfoam_probes, openfoam_interface_height, openfoam_forces, "
               "openfoam_field_value, sphinxsys, hdf5; nearest: csv");
  expect_start(complaint([](auto& source) { source.column = "etta"; }),
               "a.csv:1: column = etta: expected one of the file's 2 columns; nearest: eta, t");
  expect_start(complaint([](auto& source) { source.column = "eta [cm]"; }),
               "a.csv:1: column = eta [cm]: expected one of the file's 2 columns");
  expect_start(complaint([](auto& source) { source.time_column = ""; }),
               "time_column = (not given): expected the name of the file's column of times");
  expect_start(complaint([](auto& source) { source.time_column = "time"; }),
               "a.csv:1: time_column = time: expected one of the file's 2 columns");
  expect_start(complaint([](auto& source) { source.unit = "m"; }),
               "a.csv: unit = m: expected mm, as the file says");
  expect_start(complaint([](auto& source) { source.unit = "Pa"; }),
               "a.csv: unit = Pa: expected a unit of elevation@right, one of m, cm, mm");
  expect_start(complaint([](auto& source) { source.quantity = "force_x"; }),
               "a.csv: unit = mm: expected a unit of force_x, one of N/m, kN/m");
  expect_start(complaint([](auto& source) { source.time_unit = "ms"; }),
               "a.csv: time_unit = ms: expected s, as the file says");
  expect_start(complaint([](auto& source) { source.file = source.file.string() + ".gz"; }),
               "file = a.csv.gz: expected a file; there is none");
  expect_start(complaint([](auto& source) { source.format = "sphinxsys"; }),
               "time_column = t: expected no time column or unit: a sphinxsys file has its own");
  expect_start(complaint_of("t [s];eta\n0;1\n", [](auto&) {}),
               "a.csv: unit = (not given): expected a unit of elevation@right, one of m, cm, mm");
  expect_start(complaint_of("t;eta [m]\n0;1\n", [](auto&) {}),
               "a.csv: time_unit = (not given): expected a unit of time, one of s, ms, min");
  expect_start(complaint_of("t [s];eta [m];eta [m]\n0;1;2\n", [](auto&) {}),
               "a.csv:1: column = eta: expected a name that one column has; 2 have it");
  expect_start(complaint_of("force [N];t [s]\n0;1\n",
                            [](auto& source) {
                              source.quantity = "force_x";
                              source.column = "force";
                            }),
               "a.csv: unit = N: expected a unit of force_x, one of N/m, kN/m");
}

TEST(ImportRefusal, NumbersThatCannotBeUsedAreToldWithTheirLine) {
  const std::string head = "t [s];eta [mm]\n";
  const std::vector<std::pair<std::string, std::string>> tables{
      {"0;1\n1;nan\n", "a.csv:3: eta = nan: expected a number, in mm"},
      {"0;1\n1;inf\n", "a.csv:3: eta = inf: expected a number, in mm"},
      {"0;1\n1;-1e300\n", "a.csv:3: eta = -1e300: expected a value and not a mark of none, in mm"},
      {"0;1\n1;\n", "a.csv:3: row = 1;: expected 2 values"},
      {"0;1\n1;2;3\n", "a.csv:3: row = 1;2;3: expected 2 values"},
      {"0;1\n1\n", "a.csv:3: row = 1: expected 2 values"},
      {"0;1\n1,5;2\n",
       "a.csv:3: t = 1,5: expected a number with a decimal point and no decimal comma, in s"},
      {"0;1\n1;2\n2;3\n1.5;4\n",
       "a.csv:5: t = 1.5: expected a number above the last row's 2, in s"},
      {"0;1\n1;2\n1;2\n", "a.csv:4: t = 1: expected a number above the last row's 1, in s"},
      {"0;1\n1;2\n2;3\n3;4",
       "a.csv:5: row = 3;4: expected an end of the line: the file may be cut"},
      {"0;1\n1;2\n2;3\n", "a.csv: rows = 3: expected at least 4"},
      {"", "a.csv: rows = 0: expected at least 4"}};
  for (const auto& [rows, wanted] : tables)
    expect_start(complaint_of(head + rows, [](auto&) {}), "unusable: " + wanted);
}

std::string complaint_of_form(const std::string& format, const std::string& column,
                              const std::string& text) {
  return complaint_of(text, [&](SeriesSource& source) {
    source.format = format;
    source.column = column;
    source.unit = "m";
    source.time_column.clear();
  });
}

TEST(ImportRefusal, AFileOfAnotherProgramIsToldAsSuch) {
  expect_start(complaint_of_form("dualsphysics_gauge", "eta", table), "a.csv:1: head = t [s];eta");
  expect_start(complaint_of_form("dualsphysics_points", "eta", table), "a.csv:1: head = t [s];eta");
  expect_start(complaint_of_form("sphinxsys", "eta", table), "a.csv:1: head = t [s];eta");
  expect_start(complaint_of_form("openfoam_probes", "eta", table), "a.csv:1: head = t [s];eta");
  expect_start(complaint_of_form("openfoam_forces", "eta", table), "a.csv:1: head = t [s];eta");
  expect_start(complaint_of_form("openfoam_interface_height", "eta", table), "a.csv:1: head = t");
  expect_start(complaint_of_form("hdf5", "/eta", table), "a.csv: format = hdf5: expected a whole");
  expect_start(complaint_of_form("openfoam_forces", "total_x",
                                 "# Time  forces(pressure viscous) moment(pressure viscous)\n"
                                 "0.1 ((1 2 3) (4 5 6)) ((1 2 3) (4 5 6))\n"),
               "a.csv:1: column = total_x: expected one of the file's 19 columns; nearest: "
               "force_total_x");
}

TEST(ImportRefusal, ASeriesIsRefusedWhereItsProgramFoundNothing) {
  const std::string probes =
      "# Probe 0 (0 0 0)\n# Probe 1 (5 5 5)  # Not Found\n# Probe 0 1\n# Time\n";
  expect_start(complaint_of_form("openfoam_probes", "probe_1", probes + "0.1 1 -1e+300\n"),
               "unusable: a.csv:5: probe_1 = -1e+300: expected a value and not a mark of none");
  expect_start(complaint_of_form("openfoam_probes", "probe_0", probes + "0.1 (1 2) (3 4)\n"),
               "a.csv:5: row = 0.1 (1 2) (3 4): expected values that are numbers or vectors");
  expect_start(complaint_of_form("openfoam_probes", "probe_2", probes + "0.1 1 2\n"),
               "a.csv:4: column = probe_2: expected one of the file's 3 columns; nearest: probe_0");
}

// A surface that leaves the gauge's line is written as the line's end.
TEST(ImportRefusal, ASurfaceAtTheEndOfItsGaugesLineIsNoReading) {
  const std::string head =
      "time [s];swlx [m];swly [m];swlz [m];pos0x [m];pos0y [m];pos0z [m];pos2x [m];pos2y [m];"
      "pos2z [m]\n";
  const auto row = [](double time, const char* surface) {
    return fmt::format("{};0.95;0;{};0.95;0;0.3;0.95;0;0.45\n", time, surface);
  };
  const auto complaint = [&](const std::string& text, const char* column = "swlz") {
    return complaint_of_form("dualsphysics_gauge", column, text);
  };
  const std::string inside = head + row(0, "0.35") + row(0.1, "0.449999") + row(0.2, "0.36");
  EXPECT_EQ(complaint(inside + row(0.3, "0.37")), "");
  expect_start(complaint(inside + row(0.3, "0.45")),
               "unusable: a.csv:5: swlz = 0.45: expected a surface below the end of the gauge's "
               "line, which stands in pos2z");
  expect_start(complaint(inside + row(0.3, "0.3")),
               "unusable: a.csv:5: swlz = 0.3: expected a surface above the beginning of the "
               "gauge's line, which stands in pos0z");
  EXPECT_EQ(complaint(inside + row(0.3, "0.45"), "swlx"), "") << "another column has no mark";
}

// Files of HDF5 of which a byte was changed: each gives a series or is refused, and none crashes or
// holds up the import.

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

TEST(Hdf5Damage, CrashesNoImport) {
  const TemporaryDirectory directory;
  const SeriesSource source{.quantity = "elevation@right",
                            .file = directory.path() / "a.h5",
                            .format = "hdf5",
                            .column = "value",
                            .time_column = "time"};
  const std::string sound = sound_file();
  int taken = 0, refused = 0, ended = 0;
  for (std::size_t i = 0; i < 400; ++i) {
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
  EXPECT_GT(taken, 20);
  EXPECT_GT(refused, 20);
  RecordProperty("ended", ended);  // by a crash or a limit; their number is that of HDF5's version
}

}  // namespace
}  // namespace slosh::import_refusal_test
