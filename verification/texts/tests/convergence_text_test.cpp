#include "verification/texts/convergence_text.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::convergence_text_test {
namespace {

TEST(ConvergenceText, TellsBesideItsFiguresThatARunIsNotSound) {
  CaseRuns runs = surge_runs();
  const auto told = [&](const std::string& words) {
    const ConvergenceStudy study{
        assess(surge_case(), runs), {"particles", "theory", surge_quantity}, {}};
    EXPECT_EQ(text_of(study).find("doubtful: ") != std::string::npos, !words.empty());
    return text_of(study).find(words) != std::string::npos &&
           json_of(study).find("\"doubtful\": \"" + words) != std::string::npos;
  };
  EXPECT_TRUE(told(""));
  runs.results.at("particles").series.push_back({"mach_number", "1", {0, 10, 20}, {0.5, 0.5, 0.5}});
  EXPECT_TRUE(told("particles is not sound: its Mach number but for 5 % of the time is 0.5"));
}

}  // namespace
}  // namespace slosh::convergence_text_test
