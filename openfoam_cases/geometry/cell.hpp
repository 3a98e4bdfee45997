#pragma once

namespace slosh::openfoam {

// A uniform cell's indices, counted from the left wall and from the bottom.
struct Cell {
  int column, row;
};

}  // namespace slosh::openfoam
