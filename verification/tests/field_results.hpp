// Pressure fields made by hand: liquid in a rectangle, as cells or as particles that tile it.
#pragma once

#include <functional>
#include <random>

#include "verification/series/field_snapshot.hpp"

namespace slosh {

using PressureAt = std::function<double(double x, double z)>;

// Rectangles of this size [m] from the lower left corner (0, 0) on, whose middles are below
// `length` and `depth`.
struct Tiles {
  double width, height;
  double length = 1, depth = 0.35;  // [m]
  double disorder = 0;              // of a rectangle: each is moved by up to so much in x and z
};

inline FieldSnapshot tiled_field(double time, const Tiles& tiles, const PressureAt& pressure) {
  FieldSnapshot field{.time = time,
                      .width = tiles.width,
                      .height = tiles.height,
                      .x = {},
                      .z = {},
                      .velocity_x = {},
                      .velocity_z = {},
                      .pressure = {}};
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shift(-tiles.disorder, tiles.disorder);
  for (int i = 0; (i + 0.5) * tiles.width < tiles.length; ++i)
    for (int k = 0; (k + 0.5) * tiles.height < tiles.depth; ++k) {
      const double along_x = shift(generator), along_z = shift(generator);
      field.x.push_back((i + 0.5 + along_x) * tiles.width);
      field.z.push_back((k + 0.5 + along_z) * tiles.height);
      field.velocity_x.push_back(0);
      field.velocity_z.push_back(0);
      field.pressure.push_back(pressure(field.x.back(), field.z.back()));
    }
  return field;
}

}  // namespace slosh
