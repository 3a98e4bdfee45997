// The tests run on one thread: their scenes are too small for more, and threads that wait for one
// another on a busy machine take many times as long.
#include <gtest/gtest.h>
#include <omp.h>

namespace slosh::sph {
namespace {

struct OneThread : testing::Environment {
  void SetUp() override { omp_set_num_threads(1); }
};

[[maybe_unused]] const auto* const one_thread = testing::AddGlobalTestEnvironment(new OneThread);

}  // namespace
}  // namespace slosh::sph
