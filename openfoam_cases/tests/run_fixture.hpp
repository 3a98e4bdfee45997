// A fixture for tests that run the installed interFoam; they are skipped where it is not installed.
#pragma once

#include <gtest/gtest.h>

#include "openfoam_cases/output/harvest.hpp"
#include "openfoam_cases/run_case.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/small_tank.hpp"
#include "openfoam_cases/write_case.hpp"

namespace slosh::openfoam {

class RunCase : public ::testing::Test {
 protected:
  void SetUp() override {
    if (installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  }

  Harvest run(const SloshingTank& tank) { return run_in(directory_, tank); }

  static Harvest run_in(const TemporaryDirectory& directory, const SloshingTank& tank) {
    write_case(tank, template_directory, directory.path());
    run_case(tank, directory.path(), {});
    return harvest(tank, directory.path());
  }

  TemporaryDirectory directory_;
};

}  // namespace slosh::openfoam
