#include "verification/solvers/particles/particles_in_tank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/input/tables/table_reader.hpp"

namespace slosh {
namespace {

// Larger relative differences are told.
constexpr double kept_volume = 0.02, kept_height = 0.5;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double volume_of(const ParticlesAt& moment, double spacing) {
  return moment.volume.empty() ? static_cast<double>(moment.x.size()) * spacing * spacing
                               : sum(moment.volume);
}

bool differs(double value, double expected, double share) {
  return std::abs(value - expected) > share * expected;
}

}  // namespace

// The tank rolls about an axis that surges.
std::vector<ParticlesAt> in_tank(std::vector<ParticlesAt> moments, PositionsIn frame,
                                 const CaseDefinition& definition) {
  if (frame == PositionsIn::tank) return moments;
  const SurgeMotion surge = surge_motion(definition);
  const std::optional<RollMotion> roll = roll_motion(definition);
  for (ParticlesAt& moment : moments) {
    const double shift = surge.displacement(moment.time),
                 angle = roll ? roll->angle(moment.time) : 0, axis_x = roll ? roll->axis_x : 0,
                 axis_z = roll ? roll->axis_z : 0, cosine = std::cos(angle), sine = std::sin(angle);
    for (std::size_t i = 0; i < moment.x.size(); ++i) {
      const double x = moment.x[i] - shift - axis_x, z = moment.z[i] - axis_z;
      moment.x[i] = axis_x + cosine * x + sine * z;
      moment.z[i] = axis_z - sine * x + cosine * z;
    }
  }
  return moments;
}

void require_in_tank(const std::vector<ParticlesAt>& moments, double spacing,
                     const CaseDefinition& definition, const std::filesystem::path& file) {
  const double length = definition.tank.length, height = definition.tank.height;
  const auto is_out = [&](double place, double extent) {
    return place < -spacing || place > extent + spacing;
  };
  for (const ParticlesAt& moment : moments)
    for (std::size_t i = 0; i < moment.x.size(); ++i)
      if (is_out(moment.x[i], length) || is_out(moment.z[i], height))
        throw table_error(
            file, moment.line[i], "place in the tank",
            fmt::format("({:.6g}, {:.6g}) m at {:g} s", moment.x[i], moment.z[i], moment.time),
            fmt::format("a particle of the liquid, x from 0 to {:g} m and z from 0 to {:g} m "
                        "(bottom and roof), and outside by no more than the spacing, {:g} m",
                        length, height, spacing));
}

std::vector<std::string> doubts_of_liquid(const std::vector<ParticlesAt>& moments, double spacing,
                                          const CaseDefinition& definition) {
  std::vector<std::string> doubts;
  const ParticlesAt& first = moments.front();
  const double volume = volume_of(first, spacing), liquid = liquid_area(definition),
               height = sum(first.z) / static_cast<double>(first.z.size()),
               still = definition.liquid.fill_depth / 2;
  if (differs(volume, liquid, kept_volume))
    doubts.push_back(fmt::format(
        "volume of all particles at {:g} s = {:.4g} m2: expected the {:.4g} m2 of the case's "
        "liquid, to {:g} %; is the spacing right, and are these all particles of the liquid and no "
        "others?",
        first.time, volume, liquid, 100 * kept_volume));
  if (differs(height, still, kept_height))
    doubts.push_back(fmt::format(
        "mean height of all particles at {:g} s = {:.4g} m: expected half the fill depth, {:.4g} "
        "m, to {:g} %; are x and z exchanged?",
        first.time, height, still, 100 * kept_height));
  const auto changed = std::find_if(moments.begin(), moments.end(), [&](const ParticlesAt& now) {
    return differs(volume_of(now, spacing), volume, kept_volume);
  });
  if (changed != moments.end())
    doubts.push_back(fmt::format(
        "volume of all particles at {:g} s = {:.4g} m2: expected the {:.4g} m2 of the first time, "
        "to {:g} %",
        changed->time, volume_of(*changed, spacing), volume, 100 * kept_volume));
  return doubts;
}

}  // namespace slosh
