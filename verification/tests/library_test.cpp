// The installed libraries, as a project of their user finds them: in a directory whose name has a
// space and a letter beyond ASCII.
#include <gtest/gtest.h>

#include <boost/process.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "verification/tests/temporary_directory.hpp"

namespace slosh::library_test {
namespace {

namespace bp = boost::process;
namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Library : public ::testing::Test {
 protected:
  Library() { fs::create_directories(root_); }

  fs::path prefix() const { return root_ / "installed"; }

  // All that the command prints, which must succeed.
  std::string output_of(const std::string& program,
                        const std::vector<std::string>& arguments) const {
    const fs::path log = temporary_.path() / "log";
    fs::remove(log);  // not truncated
    const int status =
        bp::system(bp::exe = program, bp::args = arguments,
                   (bp::std_out & bp::std_err) > log.string(), bp::std_in < bp::null);
    EXPECT_EQ(status, 0) << program << " " << ::testing::PrintToString(arguments) << "\n"
                         << read(log);
    return read(log);
  }
  void install() const {
    output_of(CMAKE, {"--install", SLOSH_BUILD_DIR, "--prefix", prefix().string()});
  }

  TemporaryDirectory temporary_;
  const fs::path root_ = temporary_.path() / "a tänk";
};

TEST_F(Library, IsFoundBuiltAgainstAndRunByTheExample) {
  install();
  const fs::path project = root_ / "example", build = root_ / "build";
  fs::copy(fs::path(SLOSH_SOURCE_DIR) / "sph/example", project);
  // Ninja, as Slosh needs it itself: a bare machine has no make.
  output_of(CMAKE, {"-S", project.string(), "-B", build.string(), "-G", "Ninja",
                    "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=" CXX,
                    "-DCMAKE_CXX_FLAGS=-Wall -Werror", "-DCMAKE_PREFIX_PATH=" + prefix().string()});
  output_of(CMAKE, {"--build", build.string()});
  const std::string printed = output_of((build / "surge").string(), {});
  std::smatch numbers;
  ASSERT_TRUE(
      std::regex_match(printed, numbers,
                       std::regex("error of the forced amplitude: (-?[0-9.]+) \\+- ([0-9.]+) %\n")))
      << printed;
  // So coarse a run is within 5 % of theory (measured: 1.0 +- 1.4 %).
  EXPECT_LT(std::abs(std::stod(numbers[1])), 5);
  EXPECT_GT(std::stod(numbers[2]), 0);
}

TEST_F(Library, InstallsHeadersThatFindOneAnotherAndNothingOfItsTests) {
  install();
  const fs::path include = prefix() / "include/slosh";
  std::string all;
  for (const auto& entry : fs::recursive_directory_iterator(include)) {
    const fs::path header = entry.path().lexically_relative(include);
    EXPECT_EQ(header.string().find("test"), std::string::npos) << header;
    if (entry.is_regular_file()) all += "#include \"" + header.string() + "\"\n";
  }
  for (const char* part : {"\"sph/simulation.hpp\"", "\"reference/linear_surge.hpp\"",
                           "\"verification/metrics/comparison.hpp\""})
    EXPECT_NE(all.find(part), std::string::npos) << part;
  std::ofstream(root_ / "all.cpp") << all;
  output_of(CXX, {"-std=c++20", "-fopenmp", "-fsyntax-only", "-w", "-isystem", EIGEN_INCLUDE, "-I",
                  include.string(), (root_ / "all.cpp").string()});
}

}  // namespace
}  // namespace slosh::library_test
