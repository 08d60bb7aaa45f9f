// SPDX-License-Identifier: MIT
/// How far long work is, and on how many threads it runs.

#include <fcntl.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "render/progress.hpp"
#include "studies/common/parallel.hpp"
#include "support/testing.hpp"

namespace stickslip {
namespace {

using namespace std::chrono_literals;
using report::Progress;
using report::ProgressStyle;

// A progress whose clock and screen are the test's own.
class ProgressOf : public ::testing::Test {
 protected:
  [[nodiscard]] Progress::Surroundings surroundings(ProgressStyle style) {
    return {.style = style,
            .write = [this](std::string_view text) { written_.emplace_back(text); },
            .now = [this] { return now_; }};
  }

  Progress::Clock::time_point now_{};
  std::vector<std::string> written_;
};

STICKSLIP_VERIFIES(ProgressOf, "U10");
TEST_F(ProgressOf, ATerminalIsABarWithShareRateAndTimeLeft) {
  Progress progress("stickslip map", surroundings(ProgressStyle::bar), 1200);
  now_ += 2s;
  progress(0.25);
  ASSERT_EQ(written_.size(), 1u);
  EXPECT_EQ(written_[0], "\r\033[Kstickslip map  [#####---------------]  25 %  150/s  0:06 left");
}

TEST_F(ProgressOf, ATerminalIsRedrawnAtMostTenTimesASecond) {
  Progress progress("stickslip map", surroundings(ProgressStyle::bar));
  for (int i = 0; i < 1000; ++i) {
    progress(i / 1000.0);
    now_ += 1ms;
  }
  EXPECT_EQ(written_.size(), 10u);
}

TEST_F(ProgressOf, ATerminalIsErasedInTheEndAndStaysSo) {
  {
    Progress progress("stickslip map", surroundings(ProgressStyle::bar));
    progress(0.5);
    progress.finish();
    now_ += 1s;
    progress(0.6);
  }
  ASSERT_EQ(written_.size(), 2u);
  EXPECT_EQ(written_[1], "\r\033[K");
}

TEST_F(ProgressOf, ATerminalNeverBreaksTheLine) {
  Progress progress("stickslip report", surroundings(ProgressStyle::bar));
  progress.stage(std::string(200, 'x'));
  ASSERT_EQ(written_.size(), 1u);
  EXPECT_EQ(written_[0].size(), std::string_view("\r\033[K").size() + 79u);
}

TEST_F(ProgressOf, ALogIsALineEveryFiveSecondsAndNoneOfShortWork) {
  Progress progress("stickslip map", surroundings(ProgressStyle::lines));
  for (int tenths = 1; tenths <= 49; ++tenths) {
    now_ += 100ms;
    progress(tenths / 200.0);
  }
  EXPECT_TRUE(written_.empty());
  for (int tenths = 50; tenths <= 149; ++tenths) {
    now_ += 100ms;
    progress(tenths / 200.0);
  }
  EXPECT_EQ(written_, (std::vector<std::string>{"stickslip map: 25 %, 5 %/s, 0:15 left\n",
                                                "stickslip map: 50 %, 5 %/s, 0:10 left\n"}));
}

TEST_F(ProgressOf, ALogSaysWhatIsBeingDone) {
  Progress progress("stickslip report", surroundings(ProgressStyle::lines));
  now_ += 6s;
  progress.stage("drawing fig9");
  EXPECT_EQ(written_, std::vector<std::string>{"stickslip report: 0 %, drawing fig9\n"});
}

TEST_F(ProgressOf, APipeIsSilent) {
  Progress progress("stickslip map", surroundings(ProgressStyle::silent));
  for (int i = 0; i < 10; ++i) {
    now_ += 10s;
    progress(0.1 * i);
    progress.stage("drawing");
  }
  progress.finish();
  EXPECT_TRUE(written_.empty());
}

TEST_F(ProgressOf, WorkThatGoesOnDoesNotCountWhatWasDoneBefore) {
  Progress progress("stickslip map", surroundings(ProgressStyle::bar), 1000);
  now_ += 100s;
  progress.start_at(0.5);
  now_ += 10s;
  progress(0.6);
  ASSERT_EQ(written_.size(), 1u);
  EXPECT_TRUE(written_[0].ends_with("60 %  10/s  0:40 left")) << written_[0];
}

TEST_F(ProgressOf, LongWorkCountsHours) {
  Progress progress("stickslip map", surroundings(ProgressStyle::bar));
  now_ += 7384s;
  progress(0.5);
  ASSERT_EQ(written_.size(), 1u);
  EXPECT_TRUE(written_[0].ends_with("  2:03:04 left")) << written_[0];
}

STICKSLIP_VERIFIES(ProgressStyle, "U10");
TEST(ProgressStyle, IsABarOnATerminal) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) GTEST_SKIP() << "the system gives no pseudo-terminal: " << std::strerror(errno);
  EXPECT_EQ(report::progress_style_of(terminal), ProgressStyle::bar);
  ::close(terminal);
}

TEST(ProgressStyle, IsLinesInAFileAndNothingInAPipe) {
  std::string name = ::testing::TempDir() + "progress-XXXXXX";
  const int file = ::mkstemp(name.data());
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const int device = ::open("/dev/null", O_WRONLY);
  EXPECT_EQ(report::progress_style_of(file), ProgressStyle::lines);
  EXPECT_EQ(report::progress_style_of(pipe[1]), ProgressStyle::silent);
  EXPECT_EQ(report::progress_style_of(device), ProgressStyle::silent);
  EXPECT_EQ(Progress::standard_error(true).style, ProgressStyle::silent);
  for (const int descriptor : {file, pipe[0], pipe[1], device}) ::close(descriptor);
  ::unlink(name.c_str());
}

STICKSLIP_VERIFIES(InParallel, "U10");
TEST(InParallel, DoesAndSettlesEachIndexOnce) {
  for (const unsigned threads : {1U, 2U, 3U, 7U})
    for (const std::size_t count : {0U, 1U, 2U, 100U, 5000U}) {
      std::vector<std::atomic<int>> done(count);
      std::vector<int> settled(count);
      studies::in_parallel_settling(
          count, [&](std::size_t i) { ++done[i]; },
          [&](std::size_t first, std::size_t last) {
            EXPECT_LT(first, last);
            EXPECT_LE(last - first, count < 128u ? 1u : 16u);  // a 64th of a thread's share
            for (std::size_t i = first; i < last; ++i) settled[i] += done[i];
          },
          threads);
      EXPECT_EQ(settled, std::vector<int>(count, 1)) << threads << " threads, " << count;
    }
}

// Each of three indices waits until all three are at work.
TEST(InParallel, WorksOnAsManyIndicesAtATimeAsThreads) {
  std::atomic<int> at_work{0}, met{0};
  const auto work = [&](std::size_t) {
    ++at_work;
    for (int i = 0; i < 1000 && at_work < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (at_work == 3) ++met;
  };
  studies::in_parallel(3, work, {}, 3);
  EXPECT_EQ(met, 3);
}

TEST(InParallel, TellsAShareThatGrowsToOne) {
  double last = 0.0;
  studies::in_parallel(
      1000, [](std::size_t) {},
      [&](double share) {
        EXPECT_GT(share, last);
        last = share;
      },
      3);
  EXPECT_EQ(last, 1.0);
}

TEST(InParallel, EndsWithTheFirstExceptionAndThrowsItOn) {
  std::atomic<int> done{0};
  const auto work = [&](std::size_t i) {
    if (i == 10) throw std::domain_error("ten");
    ++done;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_THROW(studies::in_parallel(10'000, work, {}, 3), std::domain_error);
  EXPECT_LT(done, 9'900);
  const auto refuse = [](double) { throw std::domain_error("enough"); };
  EXPECT_THROW(studies::in_parallel(
                   100, [](std::size_t) {}, refuse, 2),
               std::domain_error);
}

STICKSLIP_VERIFIES(ThreadCount, "U10");
TEST(ThreadCount, IsThatOfTheMachineUntilItIsSet) {
  const unsigned before = studies::thread_count();
  EXPECT_EQ(before, std::max(1U, std::thread::hardware_concurrency()));
  studies::set_thread_count(3);
  EXPECT_EQ(studies::thread_count(), 3u);
  EXPECT_THROW(studies::set_thread_count(0), std::invalid_argument);
  (void)studies::ThreadsForNow(5);
  EXPECT_EQ(studies::thread_count(), 3u);
  studies::set_thread_count(before);
}

}  // namespace
}  // namespace stickslip
