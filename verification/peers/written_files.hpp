// What the writers of cases for other codes share: their files, refusals and tables.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The [[run]] table of a case file that takes the output of another code back as an external run.

// Returns the table as TOML with a comment above it. Series of quantities that the case does not
// compare are left out. Throws std::invalid_argument where none is left.
std::string run_block(const std::string& name, const ExternalRun& external,
                      const CaseDefinition& definition, const std::string& comment);

// What the writers of cases for other codes are given.

// A case, and what a code needs beside it.
struct HandedCase {
  const CaseDefinition& definition;
  double spacing;                            // [m], of particles
  int cells_x, cells_z;                      // of a mesh
  std::filesystem::path place;               // absolute: where the directory will lie
  std::filesystem::path openfoam_templates;  // what the case of interFoam is made of
};

void write_text(const std::filesystem::path& file, const std::string& text);
// Makes it executable too.
void write_script(const std::filesystem::path& file, const std::string& text);

// A number in the shortest form that reads back as the same double.
std::string exact(double value);

// A table of numbers, separated by commas, with a first line of names.
std::string number_table(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& rows);

// Throws CaseFileError with the place of the key, which is as in the case file ("motion.roll",
// "liquid.column_width_m"), and what the code expects of it.
[[noreturn]] void refuse_for_code(const CaseDefinition& definition, const std::string& key,
                                  const std::string& expected);

// The first lines of a README.md: the case and the code, then the units and the frame.
std::string readme_head(const HandedCase& handed, const std::string& code);

// The last lines: how the output becomes a run of Slosh.
std::string readme_end(const HandedCase& handed, const std::string& run);

// The inputs of a run block: all files that lie in the directory so far, under the place where it
// will lie, sorted.
std::vector<std::filesystem::path> inputs_in(const HandedCase& handed,
                                             const std::filesystem::path& directory);

// "dualsphysics_12p5mm": a run's name with the spacing.
std::string run_name(const std::string& code, double spacing);

// Whether the length is a whole number of spacings, to a millionth.
bool is_whole_multiple(double length, double spacing);

}  // namespace slosh
