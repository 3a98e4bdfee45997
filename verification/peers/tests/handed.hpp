// A case handed to a code in a directory of its own, and what was written there.
#pragma once

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/case_file/case_parser.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/peers/peer_codes.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh {

inline const std::string plain_case = R"(schema_version = 1
name = "plain"
title = "A tank"
source = "made for a test"
tags = []
[tank]
length_m = 1.0
height_m = 0.6
[liquid]
fill_depth_m = 0.35
[motion]
still = true
[time]
start = "earth"
duration_s = 2.0
sample_interval_s = 0.02
[[gauge]]
name = "right"
x_m = 0.95
[comparison]
window_begin_s = 0.5
natural_modes = 0
[[run]]
name = "potential"
solver = "potential"
)";

// 1.7 rad/s; at t = 0 the tank has the velocity 0.034 m/s.
inline const std::string surges = R"([motion.surge]
type = "sine"
amplitude_m = 0.02
angular_frequency_rad_s = 1.7
)";

inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  if (at == text.npos) throw std::invalid_argument("no " + old);
  return text.replace(at, old.size(), by);
}

// The plain case with this motion.
inline std::string moving(const std::string& motion) {
  return replaced(plain_case, "[motion]\nstill = true\n", motion);
}

class Handed {
 public:
  // The case's text, or the path of a shipped one where it is a single line.
  explicit Handed(const std::string& text) {
    const bool shipped = text.find('\n') == text.npos;
    if (!shipped) std::ofstream(home_.path() / "case.toml") << text;
    definition_ = read_case(
        shipped ? std::filesystem::path(SLOSH_SOURCE_DIR "/verification/cases") / (text + ".toml")
                : home_.path() / "case.toml");
  }

  const CaseDefinition& definition() const { return definition_; }
  std::filesystem::path directory() const { return home_.path() / "written"; }

  Handed& to(const std::string& code, double spacing = 0.05) {
    write_for_code(code, {.definition = definition_,
                          .spacing = spacing,
                          .cells_x = 20,
                          .cells_z = 12,
                          .place = directory(),
                          .openfoam_templates = SLOSH_SOURCE_DIR "/openfoam_cases/sloshing_tank"});
    return *this;
  }

  std::string file(const std::string& name) const { return read_bytes(directory() / name); }

  // The case with the written run, as our parser reads both, and that run.
  CaseDefinition with_run() const {
    const std::filesystem::path file = home_.path() / "with_run.toml";
    std::ofstream(file) << definition_.text << "\n" << this->file("run.toml");
    const std::filesystem::path records = home_.path() / "records";  // of shipped cases
    if (!std::filesystem::exists(records))
      std::filesystem::create_directory_symlink(SLOSH_SOURCE_DIR "/verification/cases/records",
                                                records);
    return read_case(file);
  }
  ExternalRun run() const { return std::get<ExternalRun>(with_run().runs.back().solver); }

  // A table with a first line of names, separated by `separator`: its columns by name.
  std::map<std::string, std::vector<std::string>> table(const std::string& name,
                                                        char separator = ',') const {
    std::istringstream stream(file(name));
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> names = split(line, separator);
    std::map<std::string, std::vector<std::string>> columns;
    while (std::getline(stream, line)) {
      const std::vector<std::string> fields = split(line, separator);
      if (fields.size() != names.size()) throw std::runtime_error(name + ": " + line);
      for (std::size_t i = 0; i < names.size(); ++i) columns[names[i]].push_back(fields[i]);
    }
    return columns;
  }

  std::vector<double> numbers(const std::string& name, const std::string& column,
                              char separator = ',') const {
    std::vector<double> values;
    const auto columns = table(name, separator);
    for (const std::string& text : columns.at(column)) values.push_back(std::stod(text));
    return values;
  }

 private:
  static std::vector<std::string> split(const std::string& line, char separator) {
    std::vector<std::string> fields;
    std::size_t begin = 0;
    for (std::size_t end; (end = line.find(separator, begin)) != line.npos; begin = end + 1)
      fields.push_back(line.substr(begin, end - begin));
    fields.push_back(line.substr(begin));
    return fields;
  }

  TemporaryDirectory home_;
  CaseDefinition definition_;
};

}  // namespace slosh
