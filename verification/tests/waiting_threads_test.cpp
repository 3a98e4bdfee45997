// How long threads that wait keep their cores busy: shortly, unless the user's environment says
// how.
#include "verification/tests/small_campaign.hpp"

namespace slosh::waiting_threads_test {
namespace {

class WaitingThreads : public SmallCampaign {
 protected:
  // OpenMP tells its settings each time that the program starts.
  std::string settings(const Environment& more) const {
    const std::string script =
        "env -u GOMP_SPINCOUNT -u OMP_WAIT_POLICY OMP_DISPLAY_ENV=VERBOSE "
        "$MORE " SLOSH_TOOL " --version";
    const Ended ended = end_of(start("/bin/sh", {"-c", script}, more));
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.out, "Slosh " SLOSH_VERSION "\n") << "one start tells the version";
    return ended.err;
  }
};

TEST_F(WaitingThreads, LookForWorkForAShortTimeOnly) {
  EXPECT_NE(settings({}).find("GOMP_SPINCOUNT = '3000'"), std::string::npos);
}

TEST_F(WaitingThreads, WaitAsTheUserSays) {
  EXPECT_EQ(settings({{"MORE", "GOMP_SPINCOUNT=17"}}).find("'3000'"), std::string::npos);
  EXPECT_EQ(settings({{"MORE", "OMP_WAIT_POLICY=active"}}).find("'3000'"), std::string::npos);
}

}  // namespace
}  // namespace slosh::waiting_threads_test
