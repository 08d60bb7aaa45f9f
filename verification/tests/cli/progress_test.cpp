// SPDX-License-Identifier: MIT
/// How far long work is, and on how many threads it runs.

#include <fcntl.h>
#include <unistd.h>
#include <atomic>
#include <chrono>
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
  [[nodiscard]] Progress::ProgressSink sink(ProgressStyle style) {
    return {.style = style,
            .write = [this](std::string_view text) { written_.emplace_back(text); },
            .now = [this] { return now_; }};
  }

  Progress::Clock::time_point now_{};
  std::vector<std::string> written_;
};

STICKSLIP_VERIFIES(ProgressOf, "U10");
TEST_F(ProgressOf, ATerminalIsABar) {
  struct Work {
    std::size_t items;
    std::chrono::seconds time;
    double share;
    std::string bar;
  };
  for (const auto& [items, time, share, bar] :
       {Work{1200, 2s, 0.25, "[#####---------------]  25 %  150/s  0:06 left"},
        Work{0, 7384s, 0.5, "[##########----------]  50 %  0.0068 %/s  2:03:04 left"}}) {
    Progress progress("stickslip map", sink(ProgressStyle::bar), items);
    now_ += time;
    progress(share);
    EXPECT_EQ(written_.back(), "\r\033[Kstickslip map  " + bar);
  }
}

TEST_F(ProgressOf, ATerminalIsRedrawnRarely) {
  Progress progress("stickslip map", sink(ProgressStyle::bar));
  for (int i = 0; i < 1000; ++i) {
    progress(i / 1000.0);
    now_ += 1ms;
  }
  EXPECT_EQ(written_.size(), 10u);
}

TEST_F(ProgressOf, ATerminalIsErasedInTheEnd) {
  {
    Progress progress("stickslip map", sink(ProgressStyle::bar));
    progress(0.5);
    progress.finish();
    now_ += 1s;
    progress(0.6);
  }
  ASSERT_EQ(written_.size(), 2u);
  EXPECT_EQ(written_[1], "\r\033[K");
}

TEST_F(ProgressOf, ATerminalNeverBreaksTheLine) {
  Progress progress("stickslip report", sink(ProgressStyle::bar));
  progress.stage(std::string(200, 'x'));
  ASSERT_EQ(written_.size(), 1u);
  EXPECT_EQ(written_[0].size(), std::string_view("\r\033[K").size() + 79u);
}

TEST_F(ProgressOf, ALogIsALineEveryFiveSeconds) {
  Progress progress("stickslip map", sink(ProgressStyle::lines));
  for (int tenths = 1; tenths <= 149; ++tenths) {
    now_ += 100ms;
    progress(tenths / 200.0);
  }
  now_ += 1s;
  progress.stage("drawing fig9");
  EXPECT_EQ(written_, (std::vector<std::string>{"stickslip map: 25 %, 5 %/s, 0:15 left\n",
                                                "stickslip map: 50 %, 5 %/s, 0:10 left\n",
                                                "stickslip map: 74 %, 4.7 %/s, 0:05 left, drawing fig9\n"}));
}

TEST_F(ProgressOf, APipeIsSilent) {
  Progress progress("stickslip map", sink(ProgressStyle::silent));
  for (int i = 0; i < 10; ++i) {
    now_ += 10s;
    progress(0.1 * i);
    progress.stage("drawing");
  }
  progress.finish();
  EXPECT_TRUE(written_.empty());
}

STICKSLIP_VERIFIES(ProgressStyle, "U10");
TEST(ProgressStyle, IsLinesInAFileAndNothingInAPipe) {
  std::FILE* const file = std::tmpfile();
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const int device = ::open("/dev/null", O_WRONLY);
  EXPECT_EQ(report::progress_style_of(::fileno(file)), ProgressStyle::lines);
  EXPECT_EQ(report::progress_style_of(pipe[1]), ProgressStyle::silent);
  EXPECT_EQ(report::progress_style_of(device), ProgressStyle::silent);
  EXPECT_EQ(Progress::standard_error(true).style, ProgressStyle::silent);
  for (const int descriptor : {pipe[0], pipe[1], device}) ::close(descriptor);
  std::fclose(file);
}

STICKSLIP_VERIFIES(InParallel, "U10");
TEST(InParallel, DoesEachIndexOnce) {
  for (const unsigned threads : {1U, 2U, 3U, 7U})
    for (const std::size_t count : {0U, 1U, 2U, 100U, 5000U}) {
      std::vector<std::atomic<int>> done(count);
      std::vector<double> shares{0.0};
      studies::in_parallel(
          count, [&](std::size_t i) { ++done[i]; }, [&](double share) { shares.push_back(share); }, threads);
      EXPECT_TRUE(std::ranges::all_of(done, [](int times) { return times == 1; })) << threads << ' ' << count;
      // In steps of a 64th of a thread's share, but at most 16 indices.
      const double step = (count < 128 ? 1.0 : 16.0) / static_cast<double>(std::max<std::size_t>(count, 1));
      for (std::size_t i = 1; i < shares.size(); ++i) {
        EXPECT_GT(shares[i], shares[i - 1]);
        EXPECT_LE(shares[i] - shares[i - 1], step * (1.0 + 1e-12));
      }
      EXPECT_EQ(shares.back(), count > 0 ? 1.0 : 0.0);
    }
}

// Each of three indices waits until all three are at work.
TEST(InParallel, UsesAllThreads) {
  std::atomic<int> at_work{0}, met{0};
  const auto work = [&](std::size_t) {
    ++at_work;
    for (int i = 0; i < 1000 && at_work < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (at_work == 3) ++met;
  };
  std::vector<double> shares;
  studies::in_parallel(
      3, work, [&](double share) { shares.push_back(share); }, 3);
  EXPECT_EQ(met, 3);
  EXPECT_EQ(shares, (std::vector{1.0 / 3.0, 2.0 / 3.0, 1.0}));
}

// Each index would take a millisecond.
TEST(InParallel, ThrowsTheFirstException) {
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
TEST(ThreadCount, IsTheOneThatIsSet) {
  const unsigned before = studies::thread_count();
  {
    const studies::ScopedThreadCount three(3);
    EXPECT_EQ(studies::thread_count(), 3u);
    studies::set_thread_count(5);
    EXPECT_THROW(studies::set_thread_count(0), std::invalid_argument);
    EXPECT_EQ(studies::thread_count(), 5u);
  }
  EXPECT_EQ(studies::thread_count(), before);
}

}  // namespace
}  // namespace stickslip
