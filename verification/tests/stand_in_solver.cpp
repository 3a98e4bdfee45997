// Stands in for a solver of a user's own: stand_in_solver CASE_FILE OUTPUT KIND [NUMBER]. Solves
// the case by linear theory, makes the elevation at its first gauge wrong as KIND says, and leaves
// a table of t in s and eta in mm. With the kind "converges" the error falls with the square of
// NUMBER, a spacing in m. With "tells" it tells of NUMBER steps in a file of facts beside OUTPUT.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <thread>

#include "verification/case_file/case_parser.hpp"
#include "verification/runs/run_case.hpp"

int main(int count, char** arguments) {
  using namespace slosh;
  if (count < 4) return 2;
  const std::string kind = arguments[3];
  const double number = count > 4 ? std::atof(arguments[4]) : 0;
  if (kind == "sleeps") std::this_thread::sleep_for(std::chrono::seconds(60));
  if (kind == "fails") {
    std::cerr << "the Courant number is too large\n";
    return 7;
  }
  const CaseDefinition definition = read_case(arguments[1]);
  const RunResult theory =
      execute(definition, run_named(definition, "theory"), {}, [](double, double) {});
  const TimeSeries& wave = theory.at("elevation@" + definition.gauges.front().name);
  if (kind == "tells")
    std::ofstream(std::filesystem::path(arguments[2]).parent_path() / "cost.json") << fmt::format(
        R"({{"schema_version": 1, "liquid_particles": 3500, "steps": {}, "loop_wall_time_s": 2}})",
        number);
  std::ofstream output(arguments[2]);
  output << "t [s];eta [mm]\n";
  for (std::size_t i = 0; i < wave.time.size(); ++i) {
    if (kind == "truncated" && wave.time[i] > number) break;
    const double scale = kind == "scaled"      ? number
                         : kind == "converges" ? 1 + 40 * number * number
                                               : 1;
    const double shift = kind == "shifted" ? number : 0;
    const bool is_lost = kind == "nan" && i + 5 == wave.time.size();
    const double eta =
        is_lost ? std::numeric_limits<double>::quiet_NaN() : 1000 * scale * wave.value[i];
    output << fmt::format("{};{}\n", wave.time[i] + shift, eta);
  }
}
