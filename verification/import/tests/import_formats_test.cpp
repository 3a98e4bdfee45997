// Each format is tried on a file of its program; tests/imports/README.md gives their origins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>

#include "verification/files/hdf5_handles.hpp"
#include "verification/import/file_formats.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::import_formats_test {
namespace {

namespace fs = std::filesystem;

const fs::path samples = fs::path(SLOSH_SOURCE_DIR) / "verification/tests/imports";

// The wave of those samples that were made by hand.
double wave(double time) { return 0.02 * std::sin(2 * std::numbers::pi * 0.8 * time); }

void expect_wave(const TimeSeries& series, double factor, double mean, double tolerance) {
  ASSERT_GE(series.time.size(), 20u);
  for (std::size_t i = 0; i < series.time.size(); ++i)
    EXPECT_NEAR(series.value[i], mean + factor * wave(series.time[i]), tolerance);
}

SeriesSource source(const std::string& quantity, const std::string& file, const std::string& format,
                    const std::string& column, const std::string& unit = "") {
  return {.quantity = quantity,
          .file = samples / file,
          .format = format,
          .column = column,
          .unit = unit};
}

SeriesSource of_column(const std::string& column, SeriesSource source) {
  source.column = column;
  return source;
}

TEST(ImportFormats, HaveOneReaderAndOneNameEach) {
  std::set<std::string> names;
  for (const FileFormat& format : file_formats()) {
    EXPECT_NE(format.read_head == nullptr, format.read_series == nullptr) << format.name;
    EXPECT_TRUE(names.insert(format.name).second) << format.name << " is there twice";
  }
}

TEST(ImportFormats, AreThoseOfTheDocuments) {
  std::ifstream stream(SLOSH_SOURCE_DIR "/docs/other_solvers.md");
  std::string page{std::istreambuf_iterator<char>(stream), {}};
  std::erase(page, '`');
  std::string table = "| format | files | columns |\n|---|---|---|\n";
  for (const FileFormat& format : file_formats())
    table += "| " + format.name + " | " + format.files + " | " + format.columns + " |\n";
  EXPECT_TRUE(holds(page, table + "\n")) << table;
}

TEST(ImportFormats, ReadTheSurfaceThatAGaugeOfDualSPHysicsFound) {
  SeriesSource swl =
      source("elevation@right", "dualsphysics/GaugesSWL_right.csv", "dualsphysics_gauge", "swlz");
  swl.offset = -0.35;
  const TimeSeries elevation = import_series(swl);
  EXPECT_EQ(elevation.name, "elevation@right");
  EXPECT_EQ(elevation.unit, "m");
  EXPECT_EQ(elevation.time.front(), 0);
  expect_wave(elevation, 1, 0, 1e-6);
  swl = of_column("swlz [m]", swl);
  EXPECT_EQ(import_series(swl).value, elevation.value);
  swl.time_offset = -2.5;
  EXPECT_EQ(import_series(swl).time.front(), -2.5);
  EXPECT_EQ(import_series(swl).time.back(), elevation.time.back() - 2.5);
}

TEST(ImportFormats, ReadTheForceThatAGaugeOfDualSPHysicsFoundAsOnePerMetreWhereThatIsSaid) {
  SeriesSource force =
      source("force_x", "dualsphysics/GaugesForce_tank.csv", "dualsphysics_gauge", "forcex", "N/m");
  force.scale = 2;
  force.whole_tank = true;
  expect_wave(import_series(force), 6000, 0, 1e-3);
}

TEST(ImportFormats, TakeAForceOfDualSPHysicsAsThatOfAWallUnlessItIsToldToBeThatOfTheTank) {
  SeriesSource force =
      source("force_x", "dualsphysics/GaugesForce_tank.csv", "dualsphysics_gauge", "forcex", "N/m");
  const std::string message = message_of<CaseFileError>([&] { import_series(force); });
  EXPECT_TRUE(holds(message, "quantity = force_x: expected the force on one wall"));
  force.quantity = "force_x@right";
  EXPECT_EQ(import_series(force).name, "force_x@right");
}

// The directory of files that other programs wrote for Li's tank, which is not a part of the
// project.
const fs::path peers = fs::path(SLOSH_SOURCE_DIR) / "../shared/peers_output/dualsphysics";

TEST(ImportFormats, ReadWhatDualSPHysicsWroteAtAPlaceAndOfAWall) {
  if (!fs::is_directory(peers)) GTEST_SKIP() << "there is no " << peers;
  const auto of = [](const char* quantity, const char* file, const char* format, const char* column,
                     const char* unit = "") {
    return import_series({.quantity = quantity,
                          .file = peers / file,
                          .format = format,
                          .column = column,
                          .unit = unit});
  };
  const TimeSeries u =
      of("velocity_x@middle", "GaugesVel_middle_tank_mdbc_10mm.csv", "dualsphysics_gauge", "velx");
  EXPECT_EQ(u.unit, "m/s");
  EXPECT_NEAR(u.value.front(), -0.0296, 1e-4);  // -X'(0): seen from the tank, the liquid moves
  EXPECT_EQ(of("velocity_z@middle", "MeasuredB_Vel.csv", "dualsphysics_points", "Vel_0.z").time[1],
            0.10019);
  EXPECT_NEAR(
      of("pressure@middle", "MeasuredB_Press.csv", "dualsphysics_points", "Press_0").value.front(),
      1348.87, 1e-9);
  const TimeSeries force = of("force_x@right", "GaugesForce_rightwall_tank_mdbc_10mm.csv",
                              "dualsphysics_gauge", "forcex", "N/m");
  EXPECT_NEAR(force.value.front(), 289.57, 1e-9);
}

TEST(ImportFormats, ReadAGaugeOfDualSPHysicsThatIsPartedByCommas) {
  const std::string file = "dualsphysics/GaugesVel_middle.csv";
  const auto place = source("elevation@middle", file, "dualsphysics_gauge", "posz");
  EXPECT_EQ(import_series(place).value, std::vector<double>(24, 0.2));
  const auto velocity = source("elevation@middle", file, "dualsphysics_gauge", "velx");
  EXPECT_THROW(import_series(velocity), CaseFileError);  // in m/s
  EXPECT_EQ(import_series(source("velocity_x@middle", file, "dualsphysics_gauge", "velx")).unit,
            "m/s");
}

TEST(ImportFormats, ReadThePressuresOfMeasureTool) {
  const std::string file = "dualsphysics/PointsPressure_Press.csv";
  const auto press_0 = source("wall_pressure@low", file, "dualsphysics_points", "Press_0");
  const auto press_1 = source("wall_pressure@high", file, "dualsphysics_points", "Press_1");
  expect_wave(import_series(press_0), -9810, 2452.5, 0.01);
  expect_wave(import_series(press_1), 9810, 490.5, 0.01);
}

TEST(ImportFormats, ReadScalarsAndVectorsOfOpenFoamsProbes) {
  const TimeSeries pressure = import_series([] {
    SeriesSource of =
        source("wall_pressure@p", "openfoam/probes_p", "openfoam_probes", "probe_1", "Pa");
    return of;
  }());
  ASSERT_EQ(pressure.time.size(), 15u);
  EXPECT_DOUBLE_EQ(pressure.time[1], 0.04);
  EXPECT_DOUBLE_EQ(pressure.value[0], 1569.56516284);
  SeriesSource velocity =
      source("momentum_z", "openfoam/probes_U", "openfoam_probes", "probe_1.z", "kg/s");
  EXPECT_DOUBLE_EQ(import_series(velocity).value[1], -0.0168105356845);
  SeriesSource wall =
      source("wall_pressure@p", "openfoam/patchProbes_p", "openfoam_probes", "probe_0", "Pa");
  EXPECT_DOUBLE_EQ(import_series(wall).value[2], 2547.44160787);
}

TEST(ImportFormats, ReadForcesMomentsAndFieldValuesOfOpenFoam) {
  SeriesSource force = source("force_x", "openfoam/force.dat", "openfoam_forces", "total_x", "N/m");
  const TimeSeries total = import_series(force);
  EXPECT_DOUBLE_EQ(total.time.front(), 0.02);
  EXPECT_DOUBLE_EQ(total.value[1], -8.542250749746);
  force = of_column("viscous_z", force);
  EXPECT_DOUBLE_EQ(import_series(force).value[0], -2.189654232253e-06);
  SeriesSource moment =
      source("moment", "openfoam/moment.dat", "openfoam_forces", "pressure_y", "N");
  EXPECT_DOUBLE_EQ(import_series(moment).value[0], 1.718542258825e+03);
  SeriesSource momentum = source("momentum_x", "openfoam/volFieldValue.dat", "openfoam_field_value",
                                 "weightedVolIntegrate(U).x", "kg/s");
  momentum.scale = 1000;
  EXPECT_DOUBLE_EQ(import_series(momentum).value[0], -6.566656739096);
}

TEST(ImportFormats, ReadTheHeightsAndPositionsOfOpenFoamsInterfaceHeight) {
  SeriesSource height =
      source("elevation@right", "openfoam/height.dat", "openfoam_interface_height", "hB_1", "m");
  height.offset = -0.35;
  expect_wave(import_series(height), 1, 0, 1e-6);
  height = of_column("hL_0", height);
  expect_wave(import_series(height), -1, 0, 1e-6);
  height.file = samples / "openfoam/position.dat";
  height = of_column("p_1.z", height);
  expect_wave(import_series(height), 1, 0, 1e-6);
}

TEST(ImportFormats, ReadObservedAndReducedQuantitiesOfSphinxsys) {
  SeriesSource position = source("elevation@right", "sphinxsys/WaveGauge_Position.dat", "sphinxsys",
                                 "Position[0][1]", "m");
  position.offset = -0.35;
  expect_wave(import_series(position), 1, 0, 1e-8);
  SeriesSource force = source("force_x", "sphinxsys/Tank_TotalPressureForceFromFluid.dat",
                              "sphinxsys", "TotalPressureForceFromFluid[0]", "N/m");
  expect_wave(import_series(force), 3000, 0, 1e-6);
}

TEST(ImportFormats, ReadTheForcesOfOpenFoamOrgAndTheirSums) {
  const std::string file = "openfoam_org/forces/0.6/forces.dat";
  const auto of = [&](const char* quantity, const char* column, const char* unit) {
    return import_series(source(quantity, file, "openfoam_forces", column, unit)).value.front();
  };
  const double first = wave(0.65);
  EXPECT_NEAR(of("force_x", "force_pressure_x", "N/m"), 2900 * first, 1e-4);
  EXPECT_NEAR(of("force_x", "force_total_x", "N/m"), 3000 * first, 1e-4);
  EXPECT_NEAR(of("force_z", "force_total_z", "N/m"), -3433.5, 1e-9);
  EXPECT_NEAR(of("moment", "moment_total_y", "N"), 520 * first, 1e-4);
}

TEST(ImportFormats, StitchTheTimeFoldersOfOpenFoam) {
  for (const char* path : {"openfoam_org/forces", "openfoam_org/forces/forces.dat"}) {
    const SeriesSource folders = source("force_x", path, "openfoam_forces", "force_total_x", "N/m");
    const ImportedSeries imported = import_with_seams(folders);
    expect_wave(imported.series, 3000, 0, 1e-3);
    EXPECT_EQ(imported.series.time.size(), 24u);
    const std::string seam = (samples / "openfoam_org/forces/0.6/forces.dat").string() +
                             ":4: takes over at 0.65 s; the 4 values up to 0.8 s before it are "
                             "left out";
    EXPECT_EQ(imported.seams, std::vector<std::string>{seam}) << path;
  }
}

TEST(ImportFormats, ReadTheGaugesOfProteusAndKratosAsTables) {
  const auto of = [](const char* quantity, const char* file, const char* column, const char* time,
                     const char* unit) {
    SeriesSource table = source(quantity, file, "csv", column, unit);
    table.time_column = time;
    table.time_unit = "s";
    return table;
  };
  expect_wave(
      import_series(of("pressure@p", "proteus/point_gauges.csv", "p [1 0.1 0]", "time", "Pa")),
      9810, 2452.5, 1e-6);
  SeriesSource height = of("elevation@right", "proteus/column_gauges.csv",
                           "vof [0.95 0 0] - [0.95 1 0]", "time", "m");
  height.scale = -1;  // of the gas above
  height.offset = 0.65;
  expect_wave(import_series(height), 1, 0, 1e-9);
  expect_wave(import_series(of("pressure@p", "kratos/point_output.dat", "PRESSURE", "time", "Pa")),
              9810, 2452.5, 1e-6);
  expect_wave(import_series(of("elevation@right", "kratos/gauge_0.95.dat", "Height", "Time", "m")),
              1, 0, 1e-6);
}

// A file of HDF5 that holds what `fill` writes.
template <class Fill>
fs::path made(const TemporaryDirectory& directory, const Fill& fill) {
  const fs::path file = directory.path() / "probes.h5";
  std::ofstream(file, std::ios::binary) << hdf5::image_of(fill);
  return file;
}

TEST(ImportFormats, ReadDataSetsOfHdf5ByTheirPathsAndOwnResultsByTheirGroup) {
  const TemporaryDirectory directory;
  const std::vector<double> time{0, 1, 2, 3}, eta{4, 5, 6, 7};
  const fs::path file = made(directory, [&](hid_t root) {
    const hdf5::Handle group = hdf5::create_group(root, "elevation@right");
    hdf5::write_attribute(hdf5::write_numbers(group, "time", time), "unit", "s");
    hdf5::write_attribute(hdf5::write_numbers(group, "value", eta), "unit", "mm");
    hdf5::write_numbers(group, "bare", eta);
  });
  SeriesSource of{
      .quantity = "elevation@right", .file = file, .format = "hdf5", .column = "/elevation@right"};
  EXPECT_EQ(import_series(of).value, (std::vector<double>{0.004, 0.005, 0.006, 0.007}));
  of.time_column = "/elevation@right/time";
  of = of_column("/elevation@right/bare", of);
  of.unit = "cm";
  const TimeSeries bare = import_series(of);
  EXPECT_EQ(bare.time, time);
  EXPECT_DOUBLE_EQ(bare.value[3], 0.07);
}

// A gauge that stays dry takes few bytes when it is compressed. What is declared and not stored is
// no series.
TEST(ImportFormats, ReadCompressedValuesAndNoneThatAreNotStored) {
  const TemporaryDirectory directory;
  const hsize_t count = 200'000;
  std::vector<double> time(count), still(count, 0.25);
  for (hsize_t i = 0; i < count; ++i) time[i] = 0.001 * static_cast<double>(i);
  const fs::path file = made(directory, [&](hid_t root) {
    hdf5::write_attribute(hdf5::write_numbers(root, "t", time), "unit", "s");
    const hdf5::Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "a space");
    const hdf5::Handle packed(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
    H5Pset_chunk(packed, 1, &count);
    H5Pset_deflate(packed, 9);
    for (const char* name : {"stored", "declared"}) {
      const hdf5::Handle set(
          H5Dcreate2(root, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, packed, H5P_DEFAULT), H5Dclose,
          "a data set");
      hdf5::write_attribute(set, "unit", "m");
      if (name == std::string("stored"))
        H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, still.data());
    }
  });
  const SeriesSource source{.quantity = "elevation@right",
                            .file = file,
                            .format = "hdf5",
                            .column = "/stored",
                            .time_column = "/t"};
  EXPECT_EQ(import_series(source).value, still);
  EXPECT_THROW(import_series(of_column("/declared", source)), CaseFileError);
}

// As C programs and netCDF write them.
TEST(ImportFormats, ReadUnitsOfAnyLengthInAscii) {
  const TemporaryDirectory directory;
  const fs::path file = made(directory, [&](hid_t root) {
    const hdf5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a type");
    H5Tset_size(type, H5T_VARIABLE);
    const hdf5::Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "a space");
    for (const auto& [name, unit] : {std::pair{"t", "ms"}, std::pair{"p", "kPa"}}) {
      const hdf5::Handle set = hdf5::write_numbers(root, name, {1, 2, 3, 4});
      const hdf5::Handle attribute(H5Acreate2(set, "unit", type, scalar, H5P_DEFAULT, H5P_DEFAULT),
                                   H5Aclose, "an attribute");
      H5Awrite(attribute, type, &unit);
    }
  });
  const TimeSeries series = import_series({.quantity = "wall_pressure@p",
                                           .file = file,
                                           .format = "hdf5",
                                           .column = "/p",
                                           .time_column = "/t"});
  EXPECT_EQ(series.value, (std::vector<double>{1000, 2000, 3000, 4000}));
  EXPECT_DOUBLE_EQ(series.time[3], 0.004);
}

// A data set of this shape, with a unit of fixed length as h5py and MATLAB write it.
void write_in_shape(hid_t file, const char* name, std::vector<hsize_t> shape,
                    const std::string& unit) {
  const hdf5::Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                           H5Sclose, "a space");
  const hdf5::Handle set(
      H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "a data set");
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) + 1;
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  const hdf5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a type");
  H5Tset_size(type, 8);
  const hsize_t one = 1;
  const hdf5::Handle single(H5Screate_simple(1, &one, nullptr), H5Sclose, "a space");
  const hdf5::Handle attribute(H5Acreate2(set, "units", type, single, H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose, "an attribute");
  std::string text = unit;
  text.resize(8);
  H5Awrite(attribute, type, text.data());
}

TEST(ImportFormats, ReadRowsAndColumnsOfHdf5WithTheirUnitsOfFixedLength) {
  const TemporaryDirectory directory;
  const fs::path file = made(directory, [&](hid_t root) {
    write_in_shape(root, "t", {1, 4}, "ms");
    write_in_shape(root, "p", {4, 1, 1}, "kPa  ");
    write_in_shape(root, "field", {2, 2}, "Pa");
  });
  SeriesSource of{.quantity = "wall_pressure@p",
                  .file = file,
                  .format = "hdf5",
                  .column = "/p",
                  .time_column = "/t"};
  EXPECT_EQ(import_series(of).value, (std::vector<double>{1000, 2000, 3000, 4000}));
  EXPECT_DOUBLE_EQ(import_series(of).time[1], 0.002);
  const auto complaint = [](const SeriesSource& wrong) {
    return message_of<CaseFileError>([&] { import_series(wrong); });
  };
  of.unit = "Pa";
  EXPECT_EQ(complaint(of), file.string() + ": unit = Pa: expected kPa, as the file says");
  EXPECT_EQ(complaint(of_column("/field", of)),
            file.string() +
                ": column = /field: expected a data set of one row or column, not of "
                "2 x 2");
}

}  // namespace
}  // namespace slosh::import_formats_test
