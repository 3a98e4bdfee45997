// The texts of a small case, with runs and rows that take seconds.
#pragma once

#include <stdexcept>
#include <string>

namespace slosh {

inline const std::string small_case = R"(schema_version = 1
name = "small"
title = "A small surge"
source = "made for a test"
tags = []
gravity_m_s2 = 9.81
[tank]
length_m = 1.0
height_m = 1.0
[liquid]
fill_depth_m = 0.35
density_kg_m3 = 1000.0
kinematic_viscosity_m2_s = 1e-6
[gas]
density_kg_m3 = 1.2
kinematic_viscosity_m2_s = 1.5e-5
[motion.surge]
type = "sine"
amplitude_m = 0.02
angular_frequency_rad_s = 3.0
[time]
start = "tank"
duration_s = 8.0
sample_interval_s = 0.01
[[gauge]]
name = "right"
x_m = 0.95
[comparison]
window_begin_s = 1.0
window_end_s = 8.0
natural_modes = 1
[[run]]
name = "theory"
solver = "linear"
modes = 500
valid_elevation_over_depth = 0.2
quick = true
)";

// The coarsest runs that still follow theory.
inline const std::string particles_run = R"([[run]]
name = "particles"
solver = "sph"
scheme = "recommended"
particle_spacing_m = 0.025
)";
inline const std::string mesh_run = R"([[run]]
name = "mesh"
solver = "interfoam"
cells_x = 20
cells_z = 20
)";

inline std::string gate_on(const std::string& candidate) {
  return "[[gate]]\ncandidate = \"" + candidate + R"("
reference = "theory"
quantity = "elevation@right"
mode = "forced"
metric = "amplitude_error"
unit = "1"
limit = 0.3
reason = "The runs are coarse."
source = "made for a test"
)";
}

// What a program of the user's leaves.
inline const std::string wave_series = R"([[run.series]]
quantity = "elevation@right"
file = "wave.csv"
format = "csv"
time_column = "t"
column = "eta"
)";
// A row on that program, the run "mine".
inline std::string own_row(const std::string& metric, const std::string& limit) {
  return "[[gate]]\ncandidate = \"mine\"\nreference = \"theory\"\nquantity = \"elevation@right\"\n"
         "mode = \"" +
         std::string(metric == "normalised_rms" ? "whole" : "forced") + "\"\nmetric = \"" + metric +
         "\"\nunit = \"" + (metric == "phase_lag" ? "deg" : "1") + "\"\nlimit = " + limit +
         "\nreason = \"It is theory, made wrong.\"\nsource = \"made for a test\"\n";
}

inline const std::string particles_case = small_case + particles_run + gate_on("particles");
inline const std::string mesh_case = small_case + mesh_run + gate_on("mesh");

inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace slosh
