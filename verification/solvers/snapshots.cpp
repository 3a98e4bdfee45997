#include "verification/solvers/snapshots.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "verification/files/atomic_file.hpp"
#include "verification/files/hdf5_handles.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* index_frame = R"(<?xml version="1.0" encoding="UTF-8"?>
<Xdmf Version="2.0">
  <Domain>
    <Grid Name="particles" GridType="Collection" CollectionType="Temporal">
{}    </Grid>
  </Domain>
</Xdmf>
)";

constexpr const char* grid_entry = R"(      <Grid Name="{group}" GridType="Uniform">
        <Time Value="{time}"/>
        <Topology TopologyType="Polyvertex" NodesPerElement="1" NumberOfElements="{count}"/>
        <Geometry GeometryType="XYZ">{position}</Geometry>
        <Attribute Name="velocity" AttributeType="Vector" Center="Node">{velocity}</Attribute>
        <Attribute Name="pressure" AttributeType="Scalar" Center="Node">{pressure}</Attribute>
        <Attribute Name="density" AttributeType="Scalar" Center="Node">{density}</Attribute>
      </Grid>
)";

std::vector<double> in_plane(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<double> rows;
  rows.reserve(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) rows.insert(rows.end(), {x[i], z[i], 0.0});
  return rows;
}

// The case parser only accepts run names that are safe in file names, and these are safe in XML.
std::string data_item(const std::string& place, const std::string& dimensions) {
  return fmt::format(
      R"(<DataItem Dimensions="{}" NumberType="Float" Precision="8" Format="HDF">{}</DataItem>)",
      dimensions, place);
}

void write_values(hid_t group, const char* name, const char* unit,
                  const std::vector<double>& values, int columns = 1) {
  hdf5::write_attribute(hdf5::write_numbers(group, name, values, columns), "unit", unit);
}

// HDF5 crashes where a file cannot be completed, so the space that it may need is allocated first.
// The rest is freed when HDF5 closes the file.
void reserve(const fs::path& data, std::size_t places) {
  constexpr std::size_t columns = 8;          // of a snapshot
  constexpr std::size_t structure = 1 << 16;  // [byte]: names, shapes and trees take some 20 kB
  const int descriptor = ::open(data.c_str(), O_WRONLY | O_CLOEXEC);
  int error = descriptor < 0 ? errno : 0;
  if (descriptor >= 0) {
    error = ::posix_fallocate(descriptor, static_cast<off_t>(fs::file_size(data)),
                              static_cast<off_t>(sizeof(double) * columns * places + structure));
    ::close(descriptor);
  }
  if (error != 0)
    throw fs::filesystem_error("cannot write", data,
                               std::error_code(error, std::generic_category()));
}

void write_group(const fs::path& data, const std::string& name, const sph::Snapshot& snapshot) {
  reserve(data, snapshot.x.size());
  const hdf5::Handle file(H5Fopen(data.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                          "open " + data.string());
  const hdf5::Handle group = hdf5::create_group(file, name);
  hdf5::write_attribute(group, "time_s", snapshot.time);
  write_values(group, "position", "m", in_plane(snapshot.x, snapshot.z), 3);
  write_values(group, "velocity", "m/s", in_plane(snapshot.velocity_x, snapshot.velocity_z), 3);
  write_values(group, "pressure", "Pa", snapshot.pressure);
  write_values(group, "density", "kg/m3", snapshot.density);
}

}  // namespace

fs::path snapshot_index(const fs::path& directory, const std::string& run_name) {
  return directory / (run_name + ".snapshots.xmf");
}

SnapshotWriter::SnapshotWriter(const fs::path& directory, const std::string& run_name) try
    : data_(directory / (run_name + ".snapshots.h5")), index_(snapshot_index(directory, run_name)) {
  const hdf5::QuietErrors quiet;
  replace_file(data_, hdf5::image_of([](hid_t) {}), Durability::process_crash);
} catch (const std::runtime_error& error) {
  throw ResultError(
      fmt::format("cannot write snapshots into {}: {}", directory.string(), error.what()));
}

void SnapshotWriter::record(const sph::Snapshot& snapshot) try {
  const hdf5::QuietErrors quiet;
  const std::string name = fmt::format("snapshot_{:05d}", count_++);
  write_group(data_, name, snapshot);
  const std::string scalar = fmt::format("{}", snapshot.x.size()), vector = scalar + " 3";
  const auto item = [&](const char* data_set, const std::string& dimensions) {
    return data_item(fmt::format("{}:/{}/{}", data_.filename().string(), name, data_set),
                     dimensions);
  };
  grids_ += fmt::format(grid_entry, fmt::arg("group", name), fmt::arg("time", snapshot.time),
                        fmt::arg("count", scalar), fmt::arg("position", item("position", vector)),
                        fmt::arg("velocity", item("velocity", vector)),
                        fmt::arg("pressure", item("pressure", scalar)),
                        fmt::arg("density", item("density", scalar)));
  replace_file(index_, fmt::format(index_frame, grids_), Durability::process_crash);
} catch (const std::runtime_error& error) {
  throw ResultError(
      fmt::format("cannot write a snapshot for {}: {}", index_.string(), error.what()));
}

}  // namespace slosh
