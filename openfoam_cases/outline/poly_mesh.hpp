// The files of constant/polyMesh for a cut mesh, as blockMesh writes them for a rectangular tank:
// one cell of 1 m in y, the patch "walls" around the liquid or those of facing.hpp in a group of
// this name, and "frontAndBack" without a flow.
#pragma once

#include <filesystem>

#include "openfoam_cases/outline/cut_mesh.hpp"

namespace slosh::openfoam {

// Writes which process has which cell into the case's constant/decomposition, as decomposePar reads
// it.
void write_decomposition(const CutMesh& mesh, const std::filesystem::path& case_directory);

// Writes points, faces, owner, neighbour and boundary into the case's constant/polyMesh. The cells
// are numbered as in the mesh, and `origin` [m] becomes the origin of the points. With `by_wall`
// the walls have patches of their own.
void write_poly_mesh(const CutMesh& mesh, Corner origin, bool by_wall,
                     const std::filesystem::path& case_directory);

}  // namespace slosh::openfoam
