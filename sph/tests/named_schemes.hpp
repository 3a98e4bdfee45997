// The schemes and the variants of the recommended one, each by its own name, and what their walls
// bear.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "sph/simulation.hpp"

namespace slosh::sph {

// A scheme by its name, or a variant of the recommended one by its own.
inline RunOutput run_named(const std::string& name, Scene scene) {
  const std::vector<std::string> schemes = scheme_names();
  if (std::find(schemes.begin(), schemes.end(), name) != schemes.end()) return run(name, scene, {});
  scene.variant = name;
  return run("recommended", scene, {});
}

inline std::vector<std::string> schemes_and_variants() {
  std::vector<std::string> names = scheme_names();
  for (const std::string& variant : variant_names()) names.push_back(variant);
  return names;
}

// Of tests that every scheme and variant passes.
class EachNamedScheme : public testing::TestWithParam<std::string> {
 protected:
  RunOutput run_it(const Scene& scene) const { return run_named(GetParam(), scene); }
};

inline const std::vector<LoadedWall> four_walls{
    {"left", Wall::left}, {"right", Wall::right}, {"bottom", Wall::bottom}, {"roof", Wall::roof}};

// The forces by wall add up to those on the tank.
inline void expect_walls_to_add_up(const RunOutput& output) {
  const auto sum_of = [](const std::map<std::string, History>& forces, std::size_t sample) {
    double sum = 0;
    for (const auto& [wall, history] : forces) sum += history.value.at(sample);
    return sum;
  };
  ASSERT_EQ(output.wall_force_x.size(), 4u);
  const double weight = std::abs(output.force_z.value.front());
  for (std::size_t i = 0; i < output.force_x.time.size(); ++i) {
    EXPECT_NEAR(sum_of(output.wall_force_x, i), output.force_x.value[i], 1e-9 * weight);
    EXPECT_NEAR(sum_of(output.wall_force_z, i), output.force_z.value[i], 1e-9 * weight);
  }
}

// The largest magnitude, NaN where there is one.
inline double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values)
    result = std::isnan(value) ? value : std::max(result, std::abs(value));
  return result;
}

// Of two series, of which the second may be turned over.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b,
                                 double sign = 1) {
  EXPECT_EQ(a.size(), b.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - sign * b.at(i));
  return largest(differences);
}
inline double largest_difference(const History& a, const History& b, double sign = 1) {
  EXPECT_EQ(a.time, b.time);
  return largest_difference(a.value, b.value, sign);
}

// A series of the energy budget.
inline const std::vector<double>& budget(const RunOutput& output, const std::string& name) {
  for (const RecordedSeries& series : output.energy)
    if (series.name == name) return series.history.value;
  throw std::out_of_range(name);
}

}  // namespace slosh::sph
