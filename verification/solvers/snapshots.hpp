// Particle snapshots of an SPH run: <run>.snapshots.h5 and, beside it, <run>.snapshots.xmf, the
// XDMF index that ParaView opens (with its "XDMF Reader") as a time series of points. Groups
// /snapshot_00000, /snapshot_00001, ... have the attribute time_s and the data sets position (m),
// velocity (m/s), pressure (Pa) and density (kg/m3), each with its unit as an attribute. Position
// and velocity have rows (x, z, 0), so that the tank's plane is ParaView's x-y plane, which it
// shows at first.
#pragma once

#include <filesystem>
#include <string>

#include "sph/simulation.hpp"

namespace slosh {

// Returns the XDMF index of a run's snapshots in a directory.
std::filesystem::path snapshot_index(const std::filesystem::path& directory,
                                     const std::string& run_name);

// Writes the snapshots. Both files are complete after each one, so that the events before a failure
// can be looked at. Throws ResultError.
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
