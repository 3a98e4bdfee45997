// Particle snapshots of an SPH run: <run>.snapshots.h5 and, beside it, <run>.snapshots.xmf, the
// XDMF index that ParaView opens (with its "XDMF Reader") as a time series of points. Groups
// /snapshot_00000, /snapshot_00001, ... with the attribute time_s and the data sets position (m),
// velocity (m/s), pressure (Pa), density (kg/m3), the unit an attribute of each. Position and
// velocity have rows (x, z, 0): the tank's plane is laid into ParaView's x-y plane, which it opens
// facing.
#pragma once

#include <filesystem>
#include <string>

#include "sph/simulation.hpp"

namespace slosh {

// The XDMF index of a run's snapshots in a directory.
std::filesystem::path snapshot_index(const std::filesystem::path& directory,
                                     const std::string& run_name);

// Both files are whole after each snapshot, so that what led to a failure can be looked at. Throws
// ResultError.
class SnapshotWriter {
 public:
  SnapshotWriter(const std::filesystem::path& directory, const std::string& run_name);
  void record(const sph::Snapshot& snapshot);

 private:
  std::filesystem::path data_, index_;
  std::string grids_;  // the index's entries so far
  int count_ = 0;
};

}  // namespace slosh
