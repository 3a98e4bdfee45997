// What readers see of our files: a process beside one that is killed, h5dump, Python's h5py and an
// XML reader on the snapshots' index.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "verification/files/child_process.hpp"
#include "verification/results/result_file.hpp"
#include "verification/solvers/snapshots.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::result_readers_test {
namespace {

class ResultReaders : public ::testing::Test {
 protected:
  ResultReaders() {
    write_result(
        {.case_name = "small_surge",
         .run_name = "sph",
         .solver = "sph",
         .case_text = "title = \"über\"\n",
         .key = "00",
         .provenance = {{"command", "slosh"}},
         .active_terms = {"Tait", "δ-SPH"},
         .diagnostics = {{"mass_loss", 0.5}},
         .cost = {1, 2, 3, 4, 5, 6},
         .series = {{"elevation@right", "m", {0, 0.5}, {0.25, -0.125}}, {"a/b", "Pa", {0}, {1}}}},
        file);
  }

  bool succeeds(const std::vector<std::string>& command) try {
    ChildProcess reader(command, {.log_file = log});
    while (!reader.is_over()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::ifstream stream(log);
    output = {std::istreambuf_iterator<char>(stream), {}};
    return reader.wait_status() == 0;
  } catch (const std::runtime_error&) {  // there is none
    return false;
  }

  // An interpreter that has h5py; empty where there is none.
  std::string python() {
    for (const char* candidate : {"/usr/bin/python3", "/usr/local/bin/python3"}) {
      if (succeeds({candidate, "-c", "import h5py"})) return candidate;
    }
    return "";
  }

  TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "a run.h5";
  const std::filesystem::path log = directory.path() / "log";
  std::string output;
};

TEST_F(ResultReaders, H5dumpShowsTheWholeFile) {
  if (!succeeds({"/usr/bin/h5dump", "--version"}))
    GTEST_SKIP() << "h5dump (hdf5-tools) is not installed";
  ASSERT_TRUE(succeeds({"/usr/bin/h5dump", file.string()})) << output;
  for (const char* text :
       {"slosh result", "elevation@right", "a%2Fb", "-0.125", "mass_loss", "wall_time_s"}) {
    EXPECT_TRUE(holds(output, text));
  }
}

TEST_F(ResultReaders, H5pyReadsSeriesTextsAndAttributes) {
  const std::string interpreter = python();
  if (interpreter.empty()) GTEST_SKIP() << "Python's h5py (python3-h5py) is not installed";
  ASSERT_TRUE(succeeds({interpreter, "-c", R"(
import sys, h5py
f = h5py.File(sys.argv[1], 'r')
assert f.attrs['format'] == 'slosh result' and f.attrs['format_version'] == 2
assert f.attrs['run_name'] == 'sph'
assert f['case_text'][0].decode() == 'title = "über"\n'
assert [t.decode() for t in f['active_terms']] == ['Tait', 'δ-SPH']
assert f['cost'].attrs['peak_memory_byte'] == 4 and f['diagnostics'].attrs['mass_loss'] == 0.5
s = f['series/elevation@right']
assert list(s['time']) == [0, 0.5] and s['time'].attrs['unit'] == 's'
assert list(s['value']) == [0.25, -0.125] and s['value'].attrs['unit'] == 'm'
assert s['value'].fletcher32
assert [g.attrs['name'] for g in f['series'].values()] == ['elevation@right', 'a/b']
)",
                        file.string()}))
      << output;
}

TEST_F(ResultReaders, TheSnapshotIndexNamesDataOfTheDimensionsThatItSays) {
  const std::string interpreter = python();
  if (interpreter.empty()) GTEST_SKIP() << "Python's h5py (python3-h5py) is not installed";
  SnapshotWriter writer(directory.path() / "snap shots", "sph");
  writer.record({0, {0.1, 0.2}, {0.3, 0.4}, {1, 2}, {3, 4}, {5, 6}, {1000, 1001}});
  writer.record({0.5, {0.1}, {0.3}, {1}, {3}, {5}, {1000}});
  ASSERT_TRUE(succeeds({interpreter, "-c", R"(
import sys, os, h5py, xml.etree.ElementTree as tree
grids = tree.parse(sys.argv[1]).findall('.//Grid[@GridType="Uniform"]')
assert [float(g.find('Time').get('Value')) for g in grids] == [0, 0.5]
items = []
for grid in grids:
    count = int(grid.find('Topology').get('NumberOfElements'))
    for item in grid.iter('DataItem'):
        name, place = item.text.split(':')
        with h5py.File(os.path.join(os.path.dirname(sys.argv[1]), name), 'r') as f:
            assert list(f[place].shape) == [int(n) for n in item.get('Dimensions').split()]
            assert f[place].shape[0] == count
            items.append((place, f[place][:].tolist(), f[place].attrs['unit']))
assert items[0] == ('/snapshot_00000/position', [[0.1, 0.3, 0], [0.2, 0.4, 0]], 'm')
assert items[1] == ('/snapshot_00000/velocity', [[1, 3, 0], [2, 4, 0]], 'm/s')
assert items[2] == ('/snapshot_00000/pressure', [5, 6], 'Pa')
assert items[3] == ('/snapshot_00000/density', [1000, 1001], 'kg/m3')
assert len(items) == 8
)",
                        (directory.path() / "snap shots" / "sph.snapshots.xmf").string()}))
      << output;
}

// In a process that is sanitized this takes a minute.
TEST_F(ResultReaders, NeverSeeOneHalfWrittenThoughItsWriterIsKilled) {
  RunResult large{};
  large.series = {{"elevation@right", "m", std::vector(200000, 0.0), std::vector(200000, 0.0)}};
  for (int killed = 0; killed < 10; ++killed) {
    std::filesystem::remove(file);
    const pid_t writer = fork();
    if (writer == 0) {
      for (;;) write_result(large, file);
    }
    // From the first whole file on the writer replaces it over and over, so each pause ends the
    // writer at another point of a write.
    while (!std::filesystem::exists(file))
      ASSERT_EQ(waitpid(writer, nullptr, WNOHANG), 0) << "no writer";
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * killed));
    EXPECT_NO_THROW(read_result(file));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    EXPECT_NO_THROW(read_result(file));
  }
}

}  // namespace
}  // namespace slosh::result_readers_test
