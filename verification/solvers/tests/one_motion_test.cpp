// One motion as a sine and as tables of several rates and digits: all solvers and all written cases
// must move the same tank. An oscillator that is integrated here judges what other codes read, at
// their own steps; it shares nothing with the code that writes it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "verification/case/motion.hpp"
#include "verification/peers/tests/handed.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::one_motion_test {
namespace {

constexpr double duration = 4, sample = 0.02, ramp_time = 2, frequency = 0.9, allowed = 0.01;

enum class Kind { surge, roll };

// [m] or [deg]
double amplitude(Kind kind) { return kind == Kind::surge ? 0.02 : 0.1; }

double position(Kind kind, double t) {
  const double s = std::clamp(t / ramp_time, 0.0, 1.0);
  return amplitude(kind) * s * s * s * (10 - 15 * s + 6 * s * s) *
         std::sin(2 * std::numbers::pi * frequency * t);
}

double acceleration(Kind kind, double t) {
  constexpr double h = 2e-4;
  return (position(kind, t + h) - 2 * position(kind, t) + position(kind, t - h)) / (h * h);
}

std::string section(Kind kind, const std::string& keys) {
  return "[motion." + std::string(kind == Kind::surge ? "surge" : "roll") + "]\n" + keys +
         (kind == Kind::surge ? "" : "axis_x_m = 0.5\naxis_z_m = 0.0\n");
}

std::string text_of_case(const std::string& motion) {
  std::string text = replaced(moving(motion), "duration_s = 2.0", "duration_s = 4.0");
  return replaced(text, "start = \"earth\"", "start = \"tank\"");
}

std::string sine_case(Kind kind) {
  return text_of_case(section(
      kind,
      kind == Kind::surge
          ? "type = \"sine\"\namplitude_m = 0.02\nfrequency_Hz = 0.9\nramp_periods = 1.8\n"
          : "type = \"sine\"\namplitude_deg = 0.1\nfrequency_Hz = 0.9\nramp_periods = 1.8\n"));
}

struct Table {
  const char* name;
  double rate;  // [Hz]
  int decimals;
  bool of_acceleration = false;
  double first_time = 0, time_offset = 0;  // [s]
};

const Table tables[] = {{"100 Hz", 100, 9},
                        {"1 kHz, six decimals", 1000, 6},
                        {"1 kHz, five decimals", 1000, 5},
                        {"1 kHz, four decimals", 1000, 4},
                        {"20 kHz", 20000, 9},
                        {"20 kHz, four decimals", 20000, 4},
                        {"accelerations at 100 Hz", 100, 6, true},
                        {"accelerations at 1 kHz", 1000, 4, true},
                        {"1 kHz, from 12.5 s of the file on", 1000, 5, false, 9.7, -12.5}};

std::string table_case(Kind kind, const Table& table, const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / "motion.csv";
  std::ofstream file(path);
  const bool surges = kind == Kind::surge;
  file << "time_s,"
       << (table.of_acceleration ? surges ? "acceleration_m_s2" : "acceleration_deg_s2"
           : surges              ? "displacement_m"
                                 : "angle_deg")
       << "\n";
  const auto value = table.of_acceleration ? acceleration : position;
  const auto first = static_cast<long>(std::lround(table.first_time * table.rate));
  for (long i = first; i <= first + std::lround((duration + 3) * table.rate); ++i) {
    const double t = static_cast<double>(i) / table.rate;
    file << fmt::format("{:.6g},{:.{}f}\n", t, value(kind, t + table.time_offset), table.decimals);
  }
  std::string keys = "type = \"table\"\nfile = \"" + path.string() + "\"\n";
  if (table.time_offset != 0) keys += fmt::format("time_offset_s = {}\n", table.time_offset);
  return text_of_case(section(kind, keys));
}

struct Points {
  std::vector<double> time, value;
};

// As a solver reads points with straight lines between them, at its own steps.
Points read_by_lines(const Points& points, double step) {
  Points read;
  std::size_t i = 0;
  for (double t = 0; t <= duration; t += step) {
    while (i + 2 < points.time.size() && points.time[i + 1] < t) ++i;
    const double share = (t - points.time[i]) / (points.time[i + 1] - points.time[i]);
    read.time.push_back(t);
    read.value.push_back(points.value[i] + share * (points.value[i + 1] - points.value[i]));
  }
  return read;
}

// As interFoam reads them: OpenFOAM's interpolateSplineXY, of equally spaced points.
Points read_by_spline(const Points& points, double step) {
  Points read;
  for (double t = 0; t <= duration; t += step) {
    const double place = t / points.time[1];
    const auto i = static_cast<std::size_t>(place);
    const double mu = place - static_cast<double>(i);
    const double b = points.value[i], c = points.value[i + 1], d = points.value[i + 2];
    const double a = i == 0 ? 2 * b - c : points.value[i - 1];
    read.time.push_back(t);
    read.value.push_back(
        (2 * b + mu * (c - a + mu * (2 * a - 5 * b + 4 * c - d + mu * (3 * b - a - 3 * c + d)))) /
        2);
  }
  return read;
}

// Integrates y'' + (2 pi 1.1 Hz)^2 y = -a from rest by the rule of Runge and Kutta, with straight
// lines between the points, and returns y at the samples.
std::vector<double> oscillation(const Points& points) {
  constexpr double stiffness = 4 * std::numbers::pi * std::numbers::pi * 1.1 * 1.1, longest = 1e-3;
  std::vector<double> samples;
  double y = 0, v = 0, next = 0;
  for (std::size_t i = 0; i + 1 < points.time.size(); ++i) {
    const double length = points.time[i + 1] - points.time[i];
    const int pieces = static_cast<int>(std::ceil(length / longest));
    const double h = length / pieces, rise = points.value[i + 1] - points.value[i];
    for (int k = 0; k < pieces; ++k) {
      if (points.time[i] + k * h >= next - 1e-9) {
        samples.push_back(y);
        next += sample;
      }
      const auto push = [&](double part) { return -points.value[i] - rise * (k + part) / pieces; };
      const double a1 = push(0) - stiffness * y, v2 = v + h / 2 * a1;
      const double a2 = push(0.5) - stiffness * (y + h / 2 * v), v3 = v + h / 2 * a2;
      const double a3 = push(0.5) - stiffness * (y + h / 2 * v2), v4 = v + h * a3;
      const double a4 = push(1) - stiffness * (y + h * v3);
      y += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
  }
  return samples;
}

Points sampled(const std::function<double(double)>& function, double step) {
  Points points;
  for (double t = 0; t <= duration; t += step) {
    points.time.push_back(t);
    points.value.push_back(function(t));
  }
  return points;
}

// The largest difference over the largest value. NaN fails.
double difference(const std::vector<double>& series, const std::vector<double>& exact) {
  double largest = 0, off = 0;
  for (std::size_t i = 0; i < std::min(series.size(), exact.size()); ++i) {
    largest = std::max(largest, std::abs(exact[i]));
    const double apart = std::abs(series[i] - exact[i]);
    if (!(apart <= off)) off = apart;
  }
  return series.size() + 2 < exact.size() ? NAN : off / largest;
}

Points interfoam_points(const Handed& handed, Kind kind) {
  std::string text = handed.file("constant/acceleration");
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
  std::istringstream stream(text);
  std::size_t rows = 0;
  stream >> rows;
  Points points;
  double row[10];
  while (stream >> row[0]) {
    for (int i = 1; i < 10; ++i) stream >> row[i];
    points.time.push_back(row[0]);
    points.value.push_back(kind == Kind::surge ? row[1] : -row[8]);
  }
  EXPECT_EQ(points.time.size(), rows);
  return points;
}

Points column(const Handed& handed, const std::string& file, const std::string& name, double sign,
              char separator = ',') {
  Points points{handed.numbers(file, separator == ';' ? "#time[s]" : "time_s", separator),
                handed.numbers(file, name, separator)};
  for (double& value : points.value) value *= sign;
  return points;
}

// Every table of accelerations that is written for another code, of the surge or of the roll.
std::vector<std::pair<std::string, Points>> written(const std::string& text, Kind kind) {
  const bool surges = kind == Kind::surge;
  std::vector<std::pair<std::string, Points>> all;
  all.emplace_back("dualsphysics", column(Handed(text).to("dualsphysics"), "plain_acceleration.csv",
                                          surges ? "linx[m/s2]" : "angy", surges ? -1 : 1, ';'));
  Handed csv(text);
  csv.to("csv");
  all.emplace_back("csv",
                   column(csv, "motion.csv",
                          surges ? "surge_acceleration_m_s2" : "roll_acceleration_rad_s2", 1));
  if (!surges) return all;
  const auto tank = nlohmann::json::parse(Handed(text).to("pysph").file("tank.json")).at("motion");
  all.emplace_back("pysph and external programs",
                   Points{tank.at("time_s"), tank.at("acceleration_x_m_s2")});
  return all;
}

std::vector<double> elevation(const CaseDefinition& definition,
                              const decltype(RunDefinition::solver)& solver) {
  return execute(definition, sample_run(solver), {}, [](double, double) {})
      .at("elevation@right")
      .value;
}

class OneMotion : public testing::TestWithParam<Kind> {
 protected:
  // Below the current directory, as the case's own is.
  void SetUp() override { std::filesystem::current_path(std::filesystem::temp_directory_path()); }

  const TemporaryDirectory directory_;
  const Kind kind_ = GetParam();
  const double unit_ = kind_ == Kind::surge ? 1 : std::numbers::pi / 180;
  std::vector<double> exact_ =
      oscillation(sampled([this](double t) { return unit_ * acceleration(kind_, t); }, 1e-3));
};

constexpr double sph_step = 1.3e-4, interfoam_step = 1.9e-3;

TEST_P(OneMotion, IsThatOfEveryTableOfAccelerationsForAnotherCode) {
  for (const Table& table : tables)
    for (const auto& [code, points] : written(table_case(kind_, table, directory_.path()), kind_))
      EXPECT_LT(difference(oscillation(read_by_lines(points, sph_step)), exact_), allowed)
          << table.name << " for " << code;
}

TEST_P(OneMotion, IsThatOfInterFoamsTable) {
  for (const Table& table : tables) {
    Handed handed(table_case(kind_, table, directory_.path()));
    handed.to("openfoam");
    const Points read = read_by_spline(interfoam_points(handed, kind_), interfoam_step);
    EXPECT_LT(difference(oscillation(read), exact_), allowed) << table.name;
  }
}

TEST_P(OneMotion, IsThatOfSphAtItsSteps) {
  for (const Table& table : tables) {
    const Handed handed(table_case(kind_, table, directory_.path()));
    const auto moves = kind_ == Kind::surge ? surge_motion(handed.definition()).acceleration
                                            : roll_motion(handed.definition())->acceleration;
    EXPECT_LT(difference(oscillation(sampled(moves, sph_step)), exact_), allowed) << table.name;
  }
}

TEST_P(OneMotion, IsThatOfLinearTheory) {
  const LinearRun linear{.modes = 20, .valid_elevation_over_depth = 0.1};
  const auto exact = elevation(Handed(sine_case(kind_)).definition(), linear);
  for (const Table& table : tables)
    EXPECT_LT(difference(elevation(Handed(table_case(kind_, table, directory_.path())).definition(),
                                   linear),
                         exact),
              allowed)
        << table.name;
}

// Steps of 0.1 mm in a surge shake the surface so that it leaves its range, and says so.
TEST_P(OneMotion, IsThatOfPotentialFlow) {
  const PotentialRun potential{.nodes_x = 40, .nodes_z = 12};
  const auto exact = elevation(Handed(sine_case(kind_)).definition(), potential);
  for (const Table& table : {tables[2], tables[3]}) {
    const Handed handed(table_case(kind_, table, directory_.path()));
    const RunResult result =
        execute(handed.definition(), sample_run(potential), {}, [](double, double) {});
    if (table.decimals == 4 && kind_ == Kind::surge)
      EXPECT_TRUE(result.provenance.contains("left_range_because"));
    else
      EXPECT_LT(difference(result.at("elevation@right").value, exact), allowed) << table.name;
  }
}

INSTANTIATE_TEST_SUITE_P(OfATank, OneMotion, testing::Values(Kind::surge, Kind::roll),
                         [](const auto& kind) {
                           return kind.param == Kind::surge ? "ThatSurges" : "ThatRolls";
                         });

}  // namespace
}  // namespace slosh::one_motion_test
