// What a file does to its reader ends the reader's process apart, within its limits, and not this
// one.
#include "verification/files/foreign/guarded_reading.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace slosh::guarded_reading_test {
namespace {

std::string refusal(const std::function<void()>& read) try {
  read_guarded(0, read);
  return "";
} catch (const std::runtime_error& error) {
  return error.what();
}

TEST(GuardedReading, ReadsHereWhatAProcessApartHasRead) {
  std::vector<double> numbers;
  EXPECT_EQ(refusal([&] { numbers.push_back(3); }), "");
  EXPECT_EQ(numbers, std::vector<double>{3}) << "the other process has its own numbers";
}

TEST(GuardedReading, TellsTheExceptionAndDoesNotReadHere) {
  int reads = 0;
  const std::string words = refusal([&] {
    ++reads;
    throw std::out_of_range("no such column");
  });
  EXPECT_EQ(words, "no such column");
  EXPECT_EQ(reads, 0);
  EXPECT_EQ(refusal([] { throw std::runtime_error(std::string(1'000'000, 'x')); }).size(),
            1'000'000u);
}

TEST(GuardedReading, OutlivesACrash) {
  // The address sanitizer turns the first ones into a status of its own.
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGKILL})
    EXPECT_NE(refusal([&] { ::raise(signal); }).find("reading it ends with "), std::string::npos);
  EXPECT_NE(refusal([] { ::raise(SIGKILL); }).find("signal 9 (Killed)"), std::string::npos);
  EXPECT_NE(refusal([] { ::_exit(9); }).find("ends with status 9"), std::string::npos);
}

TEST(GuardedReading, EndsWhatAsksForAllMemory) {
  EXPECT_NE(refusal([] {
              std::vector<std::string> held;
              while (true) held.emplace_back(std::size_t{1} << 24, 'x');
            }),
            "");
  EXPECT_NE(refusal([] { const std::vector<double> numbers(std::size_t{1} << 50); }), "");
}

TEST(GuardedReading, EndsWhatDoesNotEnd) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(refusal([] {
              volatile bool goes_on = true;
              while (goes_on) {
              }
            }),
            "reading it does not end within 10 s");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(105));
}

TEST(GuardedReading, IsSafeBesideOtherThreads) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([] {
      for (int j = 0; j < 20; ++j)
        EXPECT_EQ(refusal([] { const std::vector<double> numbers(100'000, 1); }), "");
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace slosh::guarded_reading_test
