#include "verification/assessment/doubts/model_limits.hpp"

#include <gtest/gtest.h>

#include "verification/assessment/tests/found_limit.hpp"

namespace slosh::model_limits_test {
namespace {

TEST(ModelLimits, SayNumberLimitAndSource) {
  const std::string text =
      limit_text({"something", 0.08, 0.02, "of the wave's amplitude in each period", "Someone"});
  EXPECT_EQ(text, "something: 8 % of the wave's amplitude in each period, limit 2 % (Someone)");
}

TEST(ModelLimits, HaveTheEffectsOfEveryPart) {
  const CaseDefinition definition = violent_case({InterFoamRun{.cells_x = 20, .cells_z = 20}});
  for (const char* effect : {"the friction at walls", "the gap walls", "surface tension",
                             "the compression of trapped air"})
    EXPECT_TRUE(found_limit(definition, effect)) << effect;
}

}  // namespace
}  // namespace slosh::model_limits_test
