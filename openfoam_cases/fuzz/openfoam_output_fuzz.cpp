// Reads any bytes as a log, as a function object's series and as each field of a snapshot. The
// readers must return a value or throw a RunError.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/output/read_log.hpp"
#include "openfoam_cases/output/read_series.hpp"
#include "openfoam_cases/output/read_snapshot.hpp"

namespace {

namespace fs = std::filesystem;
using namespace slosh::openfoam;

// A directory in memory that is removed with the process.
class CaseDirectory {
 public:
  CaseDirectory() {
    std::string pattern = "/dev/shm/slosh_fuzz_XXXXXX";
    if (!mkdtemp(pattern.data())) std::abort();
    path_ = pattern;
    fs::create_directory(path_ / "0.1");
  }
  ~CaseDirectory() { fs::remove_all(path_); }
  const fs::path& path() const { return path_; }
  fs::path field(const std::string& name) const { return path_ / "0.1" / name; }

 private:
  fs::path path_;
};

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

SloshingTank tank_of_four_cells() {
  return {.length = 1,
          .height = 1,
          .fill_depth = 0.5,
          .gravity = 9.81,
          .liquid = {1000, 1e-6},
          .gas = {1.2, 1.5e-5},
          .velocity = [](double) { return 0.0; },
          .acceleration = [](double) { return 0.0; },
          .initial_relative_velocity = 0,
          .duration = 0.4,
          .sample_interval = 0.1,
          .gauges = {},
          .cells_x = 2,
          .cells_z = 2};
}

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const RunError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static const CaseDirectory directory;
  static const SloshingTank tank = tank_of_four_cells();
  static const TankMesh mesh(tank);
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  const fs::path file = directory.path() / "output";
  write(file, text);
  read_or_refuse([&] {
    const LogReader log = read_log(file);
    if (log.failure().empty()) log.mean_pressure_iterations();
    log.meaningful_lines();
  });
  for (const std::size_t columns : {2, 5})
    read_or_refuse([&] { read_series(tank, file, columns); });
  for (const std::string fuzzed : {"U", "alpha.liquid", "p"}) {
    for (const std::string name : {"U", "alpha.liquid", "p"})
      write(directory.field(name), name == fuzzed ? text
                                   : name == "U"  ? "internalField uniform (0 0 0);\n"
                                                  : "internalField uniform 0;\n");
    read_or_refuse([&] { read_snapshot(tank, mesh, directory.path(), 0.1); });
  }
  return 0;
}
