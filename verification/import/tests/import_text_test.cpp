// The texts that programs and laboratories really write: read alike by imports, records and tables
// of motions, or refused by their line with the reason.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "verification/import/import_series.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/tables/time_table.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::import_text_test {
namespace {

SeriesSource csv(const std::filesystem::path& file) {
  return {.quantity = "wall_pressure@b",
          .file = file,
          .format = "csv",
          .column = "p",
          .time_column = "t"};
}

using Change = std::function<void(SeriesSource&)>;

const Change as_it_is = [](SeriesSource&) {}, elevation = [](SeriesSource&source) {
  source.quantity = "elevation@right";
  source.column = "eta";
};

Change units(const std::string& time, const std::string& value) {
  return [=](SeriesSource& source) {
    source.time_unit = time;
    source.unit = value;
  };
}

Change columns(const std::string& time, const std::string& value) {
  return [=](SeriesSource& source) {
    source.time_column = time;
    source.column = value;
  };
}

// The message without the directory; it begins with "unusable: " where numbers cannot be used.
template <class Read>
std::string complaint_of(const Workspace& workspace, Read read) {
  std::string message;
  try {
    read();
  } catch (const ResultError& error) {
    message = std::string("unusable: ") + error.what();
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  const std::string directory = workspace.path().string() + "/";
  for (std::size_t at; (at = message.find(directory)) != message.npos;)
    message.erase(at, directory.size());
  return message;
}

std::string complaint_of(const std::string& text, const Change& change) {
  const Workspace workspace;
  SeriesSource source = csv(workspace.write("a.csv", text));
  change(source);
  return complaint_of(workspace, [&] { import_series(source); });
}

void expect_start(const std::string& message, const std::string& wanted) {
  EXPECT_TRUE(begins(message, wanted));
}

constexpr const char* table = "t [s];eta [mm]\n0;1\n0.5;2\n1;3\n1.5;4\n";

// Each holds 1000, 2000, 3000 and 4000 Pa at 0, 0.5, 1 and 1.5 s.
TEST(ImportText, IsReadInEachOfTheseForms) {
  struct Form {
    std::string text;
    Change change = as_it_is;
  };
  const std::string rows = "0 1\n0.5 2\n1 3\n1.5 4\n";
  const std::vector<Form> forms{
      {"t [s] p [kPa]\n" + rows},
      {"t[s] p[kPa]\n" + rows},
      {"t (s), p (kPa)\n0,1\n0.5,2\n1,3\n1.5,4\n"},
      {"t(s);p(kPa)\n0;1\n0.5;2\n1;3\n1.5;4\n"},
      {"t_s,p_kPa\n0,1\n0.5,2\n1,3\n1.5,4\n", columns("t_s", "p_kPa")},
      {"t [sec],p [mBar]\n0,10\n0.5,20\n1,30\n1.5,40\n"},
      {"t [ms]\tp [N/m^2]\n0\t1e3\n500\t2e3\n1000\t3e3\n1500\t4e3\n"},
      {"\xef\xbb\xbft [s];p [kPa]\r\n0;1\r\n0.5;2\r\n1;3\r\n1.5;4\r\n\r\n"},
      {"# SPHERIC 10\n# 1 kHz, sensor 1\n#\n# t [s] p [kPa]\n" + rows},
      {"% t [s] p [kPa]\n" + rows},
      {"Sampling rate;1000\nSensor;p and t\n\nt [s];p [kPa]\n0;1\n0.5;2\n1;3\n1.5;4\n"},
      {"time and p of run 5\nt p\n" + rows, units("s", "kPa")},
      {"t [s]\tp, raw [bar]\tp [kPa]\n0\t7\t1\n0.5\t7\t2\n1\t7\t3\n1.5\t7\t4\n"},
      {"t [s],p [kPa],u [0.5, 0.1, 0]\n0,1,7\n0.5,2,7\n1,3,7\n1.5,4,7\n"},
      {"t [s];p [kPa]\n0.0D+00;1.0D+00\n+5.0E-01;+2.0E+00\n1.0d0;3\n1.5;4.0D0\n"},
      {"t [s];p [kPa]\n0;1\n\n0.5;2\n   \n1;3\n# a remark\n1.5;4\n\n\n"},
      {"\"t [s]\",\"note, any\",\"p [kPa]\"\n0,,1\n0.5,\"a, b\",2\n1,,3\n1.5,,4\n"},
      {"\"t [s]\";\"p [kPa]\"\n\"0\";\"1\"\n0.5;2\n1;3\n1.5;4\n"},
      {"t [s];p [kPa]\n0;1\n0.5;9\n0.7;9\nt [s];p [kPa]\n0.5;2\n1;3\n1.5;4\n"}};
  for (const auto& [text, change] : forms) {
    const Workspace workspace;
    SeriesSource source = csv(workspace.write("a.csv", text));
    change(source);
    TimeSeries read;
    EXPECT_EQ(complaint_of(workspace, [&] { read = import_series(source); }), "") << text;
    EXPECT_EQ(read.time, (std::vector<double>{0, 0.5, 1, 1.5})) << text;
    ASSERT_EQ(read.value.size(), 4u) << text;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(read.value[i], 1000 * (static_cast<double>(i) + 1), 1e-9) << text;
  }
}

TEST(ImportText, IsRefusedWithTheReasonInEachOfTheseForms) {
  struct Mistake {
    std::string text, message;
    Change change = as_it_is;
  };
  const std::string head = "t [s];p [kPa]\n", start = head + "0;1\n0.5;2\n1;3\n";
  const std::vector<Mistake> mistakes{
      {std::string("\xff\xfet\0;\0p\0\n\0", 10),
       "a.csv:1: encoding = UTF-16: expected UTF-8, as iconv -f UTF-16 -t UTF-8 writes it"},
      {std::string("\0t\0;\0p\0\n", 8), "a.csv:1: encoding = UTF-16: expected UTF-8"},
      {start + std::string(1'000'001, '\0') + "\n",
       "a.csv:5: line = of more than a megabyte: expected a table, whose lines are shorter"},
      {start + "1.5;4", "a.csv:5: row = 1.5;4: expected an end of the line: the file may be cut"},
      {start + "1,5;4\n",
       "a.csv:5: t = 1,5: expected a number with a decimal point and no decimal comma, in s"},
      {"t [s],p [kPa]\n0,1,2,5\n",
       "a.csv:2: row = 0,1,2,5: expected 2 values, with decimal points and no decimal commas"},
      {start + "1.5;\xe2\x88\x92"
               "4\n",
       "a.csv:5: p = <U+2212>4: expected a number, in kPa"},
      {start + "1.5\xc2\xa0;4\n", "a.csv:5: t = 1.5<U+00A0>: expected a number, in s"},
      {start + "1.5;4\xe2\x80\x8b\n", "a.csv:5: p = 4<U+200B>: expected a number, in kPa"},
      {start + "1.5;4\x1a\n", "a.csv:5: p = 4<U+001A>: expected a number, in kPa"},
      {start + "1.5;\xb5\n", "a.csv:5: p = <byte B5>: expected a number, in kPa"},
      {"t [s];\xe2\x80\x8bp [kPa]\n0;1\n",
       "a.csv:1: column = p: expected one of the file's 2 columns; nearest: t, <U+200B>p"},
      {start + "1.5;-999\n", "a.csv:5: p = -999: expected a value and not a mark of none, in kPa"},
      {start + "1.5;-9999.0\n", "a.csv:5: p = -9999: expected a value and not a mark of none"},
      {start + "1.5;-1e20\n", "a.csv:5: p = -1e20: expected a value and not a mark of none"},
      {start + "1.5;1E+30\n", "a.csv:5: p = 1E+30: expected a value and not a mark of none"},
      {head + "0;-999\n1;-999\n2;-999\n3;-999\n", "a.csv:2: p = -999: expected a value and not"},
      {start + "1.5;-99\n", "a.csv:5: p = -99: expected a value and not a mark of none, in kPa"},
      {start + "1.5;-99.99\n", "a.csv:5: p = -99.99: expected a value and not a mark of none"},
      {start + "1.5;999.9\n", "a.csv:5: p = 999.9: expected a value and not a mark of none"},
      {start + "1.5;-32768\n", "a.csv:5: p = -32768: expected a value and not a mark of none"},
      {start + "1.5;32767\n", "a.csv:5: p = 32767: expected a value and not a mark of none"},
      {start + "1.5;65535\n", "a.csv:5: p = 65535: expected a value and not a mark of none"},
      {head + "0;0\n1;-99\n2;0\n3;0\n", "a.csv:3: p = -99: expected a value and not a mark"},
      {head + "0;-30\n1;-99\n2;30\n3;-99\n", "a.csv:3: p = -99: expected a value and not a mark"},
      {start + "1.5;-900\n2;4\n3;-900\n", "a.csv:5: p = -900: expected a value and not a mark"},
      {start + "0.7;4\n", "a.csv:5: t = 0.7: expected a number above the last row's 1, in s"},
      {"# t p\n0 1\n# t q\n1 2\n",
       "a.csv:3: head = # t q: expected the head of line 1 again: the columns must stay the same",
       units("s", "kPa")},
      {"0;1\n1;2\n", "a.csv:1: head = 0;1: expected a line with the columns' names above the"},
      {"t [s];p[kPa]\n0;1\n", "a.csv: unit = Pa: expected kPa, as the file says", units("", "Pa")},
      {"t [s];p (mbar)\n0;1\n", "a.csv: unit = Pa: expected mbar, as the file says",
       units("", "Pa")},
      {"t [s];p (psi)\n0;1\n", "a.csv: unit = psi: expected a unit of wall_pressure@b, one of Pa"},
      {"t [s];p [WG3]\n0;1\n",
       "a.csv: unit = Pa: expected one of Pa, kPa, mbar, bar in the file's head too, in place of "
       "WG3",
       units("", "Pa")},
      {"t(ms);p [Pa]\n0;1\n", "a.csv: time_unit = s: expected ms, as the file says",
       units("s", "")},
      {"t [s];p_kPa\n0;1\n", "a.csv: unit = Pa: expected kPa, as the file says",
       [](SeriesSource& source) {
         source.column = "p_kPa";
         source.unit = "Pa";
       }},
      {"t [s];p\n0;1\n", "a.csv: unit = Pa: expected kPa, as the column's name says",
       [](SeriesSource& source) {
         source.column = "p [kPa]";
         source.unit = "Pa";
       }}};
  for (const auto& [text, message, change] : mistakes) {
    std::string got = complaint_of(text, change);
    if (got.starts_with("unusable: ")) got.erase(0, 10);
    expect_start(got, message);
  }
}

// A signal may pass through the number.
TEST(ImportText, HasNoMarkOfNoneWhereTheSeriesComesNearIt) {
  for (const char* values : {"-500 -999 -1400 0", "0 99 12 -120", "40 99 -40 99", "1 -900 2 3",
                             "0 0 2000 2100", "32767 32767 32000 20000",
                             "100000 100000 103000 103100", "-9.99 -9.99 0.1 0.2", "30 30 30 31"}) {
    std::string rows;
    std::istringstream numbers(values);
    std::string number;
    for (int time = 0; numbers >> number; ++time)
      rows += std::to_string(time) + ";" + number + "\n";
    EXPECT_EQ(complaint_of("t [s];p [Pa]\n" + rows, as_it_is), "") << values;
  }
}

TEST(ImportText, OfAMotionOrARecordIsReadAlike) {
  const Workspace workspace;
  const auto motion = [&](const std::string& text) {
    return read_time_table(workspace.write("m.csv", text), {"displacement_m"});
  };
  const std::vector<double> time{0, 0.5, 1, 2}, value{0, 0.01, 0.02, 0.03};
  for (const std::string& text : std::vector<std::string>{
           "time_s,displacement_m\n0,0\n0.5,0.01\n1,0.02\n2,0.03\n",
           "\xef\xbb\xbf# the rig's log\ntime_s;displacement_m\r\n0;0\r\n0.5;1.0D-02\r\n1;+0.02\r\n"
           "2;0.03\r\n\r\n",
           "time [s] displacement [m] load [N]\n0 0 7\n0.5 0.01 7\n1 0.02 7\n2 0.03 7\n"}) {
    EXPECT_EQ(motion(text).time, time) << text;
    EXPECT_EQ(motion(text).value, value) << text;
  }
  EXPECT_EQ(motion("# log\ntime_s displacement_m\n0 0\n\n1 0\n2 0\n3 0\n").lines,
            (std::vector<int>{3, 5, 6, 7}));
  const auto record = [&](const std::string& text, const std::string& unit) {
    return read_time_columns(workspace.write("r.csv", text),
                             {"t", "P1", {"unit", unit, "wall_pressure@b", "Pa"}});
  };
  const TimeTable read = record(
      "# run 3\nt [ms]\tP1, left [V]\tP1 (kPa)\n0\t9\t1\n1\t9\t2\n2\t9\t3\n3\t9\t4\n", "kPa");
  EXPECT_EQ(read.time, (std::vector<double>{0, 0.001, 0.002, 0.003}));
  EXPECT_EQ(read.value, (std::vector<double>{1, 2, 3, 4}));
}

TEST(ImportText, OfAMotionOrARecordIsRefusedAlike) {
  const std::string head = "time_s,displacement_m\n", rows = "0,0\n1,0\n2,0\n";
  const std::vector<std::pair<std::string, std::string>> motions{
      {head + rows + "3,0.12", "m.csv:5: row = 3,0.12: expected an end of the line"},
      {head + rows + "3,-1e30\n", "m.csv:5: displacement_m = -1e30: expected a value and not a"},
      {head + rows + head + "1,0\n2,0\n", "m.csv:6: time_s = 1: expected a number above the last"},
      {"time [s],displacement [mm]\n" + rows,
       "m.csv:1: header = time [s],displacement [mm]: expec"},
      {"time_s;displacement_m\n0;0,5\n",
       "m.csv:2: displacement_m = 0,5: expected a number with a decimal point"},
      {std::string("\xff\xfet\0\n\0", 6), "m.csv:1: encoding = UTF-16: expected UTF-8"}};
  for (const auto& [text, message] : motions) {
    const Workspace workspace;
    const auto file = workspace.write("m.csv", text);
    expect_start(complaint_of(workspace, [&] { read_time_table(file, {"displacement_m"}); }),
                 message);
  }
  const Workspace workspace;
  const auto file = workspace.write("r.csv", "t_s,p_kPa\n0,1\n1,2\n2,3\n3,4\n");
  EXPECT_EQ(complaint_of(workspace,
                         [&] {
                           read_time_columns(file, {"t_s", "p_kPa", {"unit", "Pa", "p", "Pa"}});
                         }),
            "r.csv: unit = Pa: expected kPa, as the file says");
}

// A part takes the place of what the runs before it wrote from its first time on.
TEST(ImportText, IsStitchedOfThePartsOfARestartedRun) {
  const Workspace workspace;
  const std::string head = "t [s];p [Pa]\n";
  const auto a = workspace.write("a.csv", head + "0;1\n1;2\n2;9\n3;9\n"),
             b = workspace.write("b.csv", head + "2;3\n3;4\n"),
             c = workspace.write("c.csv", head + "4;5\n");
  const ImportedSeries all = import_series(csv(a), {a, b, c});
  EXPECT_EQ(all.series.time, (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(all.series.value, (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_EQ(all.seams,
            (std::vector<std::string>{
                b.string() + ":2: takes over at 2 s; the 2 values up to 3 s before it are left out",
                c.string() + ":2: goes on at 4 s after 3 s"}));
  EXPECT_EQ(
      complaint_of(workspace,
                   [&] {
                     import_series(csv(a), {b, a});
                   }),
      "unusable: a.csv:2: time = 0: expected a part that begins at 2 or later, in s, as the one "
      "before it");
}

TEST(ImportText, OfSphinxsysGoesOnBehindTheHeadOfItsRestart) {
  const Workspace workspace;
  const std::string head = "\"run_time\"   \"Height\"   \n";
  SeriesSource source = csv(workspace.write(
      "h.dat", head + "0   1   \n1   2   \n2   9   \n" + head + "2   3   \n3   4   \n"));
  source.format = "sphinxsys";
  source.quantity = "elevation@right";
  source.column = "Height";
  source.unit = "m";
  source.time_column.clear();
  const ImportedSeries imported = import_with_seams(source);
  EXPECT_EQ(imported.series.value, (std::vector<double>{1, 2, 3, 4}));
  ASSERT_EQ(imported.seams.size(), 1u);
  EXPECT_TRUE(holds(imported.seams[0], "h.dat:6: takes over at 2 s"));
}

TEST(ImportText, OfTimeFoldersIsThatOfTheNamedFile) {
  const Workspace workspace;
  const auto add = [&](const std::string& folder, const std::string& name,
                       const std::string& rows) {
    std::filesystem::create_directories(workspace.path() / folder);
    workspace.write(folder + "/" + name, "# Time a b\n" + rows);
  };
  add("f/0", "force.dat", "0 1 1\n1 2 2\n");
  add("f/0", "force_0.dat", "0 3 3\n1 4 4\n");  // begun anew
  add("f/10", "force.dat", "11 6 6\n");
  add("f/2.5", "force.dat", "3 5 5\n");
  add("f/0", "moment.dat", "0 9 9\n");
  SeriesSource source = csv(workspace.path() / "f/force.dat");
  source.format = "openfoam_forces";
  source.column = "a";
  source.unit = "Pa";
  source.time_column.clear();
  const ImportedSeries imported = import_with_seams(source);
  EXPECT_EQ(imported.series.time, (std::vector<double>{0, 1, 3, 11}));
  EXPECT_EQ(imported.series.value, (std::vector<double>{3, 4, 5, 6}));
  EXPECT_EQ(imported.seams.size(), 3u);
  source.file = workspace.path() / "f";
  EXPECT_EQ(complaint_of(workspace, [&] { import_series(source); }),
            "file = f: expected one of its time folders' files, f/force.dat or f/moment.dat");
  source.file = workspace.path() / "f/force.txt";
  EXPECT_EQ(complaint_of(workspace, [&] { import_series(source); }),
            "file = f/force.txt: expected a file; there is no f/force.txt");
}

TEST(ImportText, OfARestartedRunIsOfOneGaugeAtOnePlace) {
  const Workspace workspace;
  const auto complaint = [&](const char* format, const char* column, const std::string& first,
                             const std::string& later, const std::string& columns) {
    const auto part = [&](const char* name, const std::string& places, const char* rows) {
      return workspace.write(name, places + columns + rows);
    };
    SeriesSource source = csv(part("0.dat", first, "0 1 5\n1 2 6\n2 9 9\n"));
    const auto more = part("2.dat", later, "2 3 7\n3 4 8\n");
    source.format = format;
    source.column = column;
    source.unit = "Pa";
    source.time_column.clear();
    if (column[0] == 'h') {
      source.quantity = "elevation@right";
      source.unit = "m";
    }
    return complaint_of(workspace, [&] { import_series(source, {source.file, more}); });
  };
  const auto probes = [&](const char* column, const std::string& later) {
    return complaint("openfoam_probes", column,
                     "# Probe 0 (0.5 0 0.1)\n# Probe 1 (0.9 0 0.3333333)\n", later,
                     "# Probe 0 1\n# Time\n");
  };
  const auto refused = [](const std::string& complaint, const char* moved, const char* place) {
    return complaint.find(fmt::format("2.dat:5: place of the gauge = {}: expected {}, as in ",
                                      moved, place)) != complaint.npos &&
           complaint.find("0.dat:5") != complaint.npos;
  };
  const std::string moved = "# Probe 0 (0.9 0 0.1)\n# Probe 1 (0.9 0 0.333333)\n";
  EXPECT_TRUE(refused(probes("probe_0", moved), "(0.9 0 0.1)", "(0.5 0 0.1)"))
      << probes("probe_0", moved);
  EXPECT_EQ(probes("probe_1", moved), "");  // of fewer digits
  const std::string inserted = "# Probe 0 (0.5 0 0.1)\n# Probe 1 (0.7 0 0.1)\n";
  EXPECT_EQ(probes("probe_0", inserted), "");
  EXPECT_TRUE(refused(probes("probe_1", inserted), "(0.7 0 0.1)", "(0.9 0 0.3333333)"));
  const auto height =
      complaint("openfoam_interface_height", "hL_0", "# Location 0 : (0.05 0.5 0)\n# x\n",
                "# Location 0 : (0.06 0.5 0)\n# x\n", "# Location 0\n# Time hB hL\n");
  EXPECT_TRUE(refused(height, "(0.06 0.5 0)", "(0.05 0.5 0)")) << height;
}

TEST(ImportRefusal, NoScaleOrOffsetLeavesValuesThatAreNone) {
  const auto with = [](double scale, double offset) {
    return complaint_of(table, [=](SeriesSource& source) {
      elevation(source);
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

TEST(ImportRefusal, TheFirstValueIsZeroWhereItIsTheDatum) {
  const Workspace workspace;
  SeriesSource source =
      csv(workspace.write("a.csv", "t [s];eta [mm]\n0;355\n1;357\n2;355\n3;350\n"));
  elevation(source);
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
  elevation(blanks);
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
  const auto complaint = [](const Change& change, const std::string& text = table) {
    return complaint_of(text, [&](SeriesSource& source) {
      elevation(source);
      change(source);
    });
  };
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
  expect_start(complaint([](auto& source) { source.unit = "Pa"; }),
               "a.csv: unit = Pa: expected a unit of elevation@right, one of m, cm, mm");
  expect_start(complaint([](auto& source) { source.quantity = "force_x"; }),
               "a.csv: unit = mm: expected a unit of force_x, one of N/m, kN/m");
  expect_start(complaint([](auto& source) { source.file = source.file.string() + ".gz"; }),
               "file = a.csv.gz: expected a file; there is no a.csv.gz");
  expect_start(complaint([](auto& source) { source.format = "sphinxsys"; }),
               "time_column = t: expected no time column or unit: a sphinxsys file has its own");
  expect_start(complaint(as_it_is, "t [s];eta\n0;1\n"),
               "a.csv: unit = (not given): expected a unit of elevation@right, one of m, cm, mm");
  expect_start(complaint(as_it_is, "t;eta [m]\n0;1\n"),
               "a.csv: time_unit = (not given): expected a unit of time, one of s, ms, min");
  expect_start(complaint(as_it_is, "t [s];eta [m];eta [m]\n0;1;2\n"),
               "a.csv:1: column = eta: expected a name that one column has; 2 have it");
  expect_start(complaint(
                   [](auto& source) {
                     source.quantity = "force_x";
                     source.column = "force";
                   },
                   "force [N];t [s]\n0;1\n"),
               "a.csv: unit = N: expected a unit of force_x, one of N/m, kN/m");
}

TEST(ImportRefusal, NumbersThatCannotBeUsedAreToldWithTheirLine) {
  const std::string head = "t [s];eta [mm]\n";
  for (const auto& [rows, wanted] : std::vector<std::pair<std::string, std::string>>{
           {"0;1\n1;nan\n", "a.csv:3: eta = nan: expected a number, in mm"},
           {"0;1\n1;inf\n", "a.csv:3: eta = inf: expected a number, in mm"},
           {"0;1\n1;-1e300\n", "a.csv:3: eta = -1e300: expected a value and not a mark of none"},
           {"0;1\n1;\n", "a.csv:3: row = 1;: expected 2 values"},
           {"0;1\n1;2;3\n", "a.csv:3: row = 1;2;3: expected 2 values"},
           {"0;1\n1\n", "a.csv:3: row = 1: expected 2 values"},
           {"0;1\n1;2\n1;2\n", "a.csv:4: t = 1: expected a number above the last row's 1, in s"},
           {"0;1\n1;2\n2;3\n", "a.csv: rows = 3: expected at least 4"},
           {"", "a.csv: rows = 0: expected at least 4"}})
    expect_start(complaint_of(head + rows, elevation), "unusable: " + wanted);
}

std::string complaint_of_form(const std::string& format, const std::string& column,
                              const std::string& text) {
  return complaint_of(text, [&](SeriesSource& source) {
    elevation(source);
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

}  // namespace
}  // namespace slosh::import_text_test
