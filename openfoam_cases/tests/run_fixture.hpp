// Tests that run the installed interFoam, and are skipped where there is none.
#pragma once

#include <gtest/gtest.h>

#include "openfoam_cases/surging_tank.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam {

class RunCase : public ::testing::Test {
 protected:
  void SetUp() override {
    if (installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  }

  Harvest run(const SurgingTank& tank) { return run_in(directory_, tank); }

  static Harvest run_in(const TemporaryDirectory& directory, const SurgingTank& tank) {
    write_case(tank, template_directory, directory.path());
    run_case(tank, directory.path(), {});
    return harvest(tank, directory.path());
  }

  TemporaryDirectory directory_;
};

}  // namespace slosh::openfoam
