// What the writers of cases for other codes are given.
#pragma once

#include <filesystem>

#include "verification/case/case_definition.hpp"

namespace slosh {

// A case, and what a code needs beside it.
struct HandedCase {
  const CaseDefinition& definition;
  double spacing;                            // [m], of particles
  int cells_x, cells_z;                      // of a mesh
  std::filesystem::path place;               // absolute: where the directory will lie
  std::filesystem::path openfoam_templates;  // what the case of interFoam is made of
};

}  // namespace slosh
