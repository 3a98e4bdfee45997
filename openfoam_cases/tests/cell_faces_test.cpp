#include "openfoam_cases/geometry/cell_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::cell_faces_test {
namespace {

TEST(CellFaces, AreUniformWithoutAWallCell) {
  const CellFaces faces(1.1, 20);
  EXPECT_FALSE(faces.is_graded());
  EXPECT_EQ(faces.face(20), 1.1);
  EXPECT_EQ(faces.graded_part().cells, 0);
  EXPECT_NEAR(faces.centres_to(0.055), 0.5, 1e-14);
}

TEST(CellFaces, GrowFromBothWallsByAFifthAtMostToAUniformMiddle) {
  const CellFaces faces(0.9, 180, 0.001, "cells_x");
  EXPECT_TRUE(faces.is_graded());
  EXPECT_EQ(faces.face(0), 0);
  EXPECT_EQ(faces.face(180), 0.9);
  EXPECT_NEAR(faces.size(0), 0.001, 1e-12);
  EXPECT_NEAR(faces.size(179), 0.001, 1e-12);
  for (int i = 0; i + 1 < 180; ++i) {
    const double ratio = faces.size(i + 1) / faces.size(i);
    EXPECT_LE(std::max(ratio, 1 / ratio), 1.2 + 1e-9) << i;
    EXPECT_NEAR(faces.size(i), faces.size(179 - i), 1e-12) << i;
  }
  EXPECT_NEAR(faces.size(80), faces.size(90), 1e-12);
  EXPECT_LT(faces.size(90), 0.0055) << "the middle stays near the 5 mm of uniform cells";
  const CellFaces::Part end = faces.graded_part();
  EXPECT_NEAR(end.length, faces.face(end.cells), 1e-15);
  EXPECT_NEAR(end.ratio, faces.size(end.cells - 1) / faces.size(0), 1e-9);
}

TEST(CellFaces, TellPlacesInCellsAndInCentresAndBack) {
  const CellFaces faces(1.3, 21, 0.03, "cells_z");
  for (int i = 0; i <= 200; ++i) {
    const double place = 1.3 * i / 200;
    const double cells = faces.cells_to(place);
    const int cell = std::min(static_cast<int>(cells), 20);
    EXPECT_NEAR(faces.face(cell) + (cells - cell) * faces.size(cell), place, 1e-12);
    EXPECT_NEAR(faces.at_centres(faces.centres_to(place)), place, 1e-12);
  }
}

TEST(CellFaces, TakeTheUniformCellItself) {
  const CellFaces faces(1.1, 20, 1.1 / 20, "cells_x");
  EXPECT_EQ(faces.graded_part().cells, 0);
  EXPECT_NEAR(faces.face(7), 7 * 0.055, 1e-12);
}

TEST(CellFaces, RefuseAWallCellThatIsTooThickOrTooThin) {
  const auto refused = [](double wall_cell) {
    return message_of<std::invalid_argument>([&] { CellFaces(1, 20, wall_cell, "cells_x"); });
  };
  EXPECT_EQ(refused(0.06),
            "OpenFOAM tank: wall_cell = 0.06: expected above 0 and at most the 0.05 m of cells_x = "
            "20 uniform cells");
  EXPECT_NE(refused(0).find("wall_cell = 0: expected above 0"), std::string::npos);
  EXPECT_NE(refused(NAN).find("wall_cell = nan"), std::string::npos);
  EXPECT_NE(refused(0.001).find("wall_cell = 0.001: expected at least 0.0"), std::string::npos);
  EXPECT_NE(refused(0.001).find("m for cells_x = 20, as each cell is at most 1.2 times as thick as "
                                "its neighbour"),
            std::string::npos)
      << refused(0.001);
}

}  // namespace
}  // namespace slosh::openfoam::cell_faces_test
