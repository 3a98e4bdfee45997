// A face of a wall that a pressure gauge reads.
#pragma once

namespace slosh::openfoam {

struct FaceShare {
  double x, z;    // the face's centre [m] from the tank's bottom left corner
  double weight;  // the weights of a gauge's faces sum to 1
};

}  // namespace slosh::openfoam
