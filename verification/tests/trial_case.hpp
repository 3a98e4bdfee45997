// A valid case file's text, edits of it, and what the parser says to them.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "verification/case_file/case_parser.hpp"

namespace slosh {

inline const std::string valid_text = R"(schema_version = 1
name = "trial"
title = "A trial"
source = "none"
tags = ["surge"]
gravity_m_s2 = 9.81
[tank]
length_m = 2
height_m = 1.0
[liquid]
fill_depth_m = 0.5
density_kg_m3 = 1000.0
kinematic_viscosity_m2_s = 1e-6
[gas]
density_kg_m3 = 1.2
kinematic_viscosity_m2_s = 1.5e-5
[motion.surge]
type = "sine"
amplitude_m = 0.02
angular_frequency_rad_s = 1.5
[time]
start = "earth"
duration_s = 20.0
sample_interval_s = 0.01
[[gauge]]
name = "right"
x_m = 1.95
[[gauge]]
name = "left"
x_m = 0.05
[comparison]
window_begin_s = 1.0
window_end_s = 20.0
natural_modes = 2
[[run]]
name = "theory"
solver = "linear"
modes = 500
valid_elevation_over_depth = 0.1
[[run]]
name = "coarse"
solver = "sph"
scheme = "any"
particle_spacing_m = 0.02
surface_particle_spacing_m = 0.01
quick = true
[[run]]
name = "mesh"
solver = "interfoam"
cells_x = 50
cells_z = 40
[[gate]]
candidate = "coarse"
reference = "theory"
quantity = "elevation@right"
mode = "forced"
metric = "amplitude_error"
unit = "1"
limit = 0.05
reason = "a reason"
source = "a source"
)";

inline const std::string sine_surge =
    "[motion.surge]\ntype = \"sine\"\namplitude_m = 0.02\nangular_frequency_rad_s = 1.5\n";

// A directory of the test's own, removed with all its files.
class Workspace {
 public:
  Workspace() {
    std::string name = (std::filesystem::temp_directory_path() / "slosh_case_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make " + name);
    directory_ = name;
  }
  ~Workspace() { std::filesystem::remove_all(directory_); }
  const std::filesystem::path& path() const { return directory_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_ / name, std::ios::binary) << text;
    return directory_ / name;
  }

 private:
  std::filesystem::path directory_;
};

inline CaseDefinition read_text(const std::string& text) {
  const Workspace workspace;
  return read_case(workspace.write("trial.toml", text));
}

// The parser's message without the directory of the file; "" when it found nothing wrong.
inline std::string complaint(const std::filesystem::path& file,
                             const std::filesystem::path& experiments = {}) {
  try {
    read_case(file, experiments);
    return "";
  } catch (const CaseFileError& error) {
    const std::string directory = file.parent_path().string() + "/";
    std::string message = error.what();
    if (message.starts_with(directory)) message.erase(0, directory.size());
    return message;
  }
}

struct Edit {
  std::string from, to;
};

inline std::string edited(const Edit& edit) {
  std::string text = valid_text;
  const std::size_t at = text.find(edit.from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + edit.from);
  return text.replace(at, edit.from.size(), edit.to);
}

inline std::string complaint_about(const Edit& edit) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", edited(edit)));
}

}  // namespace slosh
