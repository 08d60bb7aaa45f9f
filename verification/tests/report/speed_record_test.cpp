// SPDX-License-Identifier: MIT
/// The record of the benchmarks: written, read back, and refused where it cannot be used.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "render/text_file.hpp"
#include "stickslip/benchmarks/speed_record.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

using benchmarks::SpeedRecord;

SpeedRecord sample_record() {
  SpeedRecord record{
      .processor = "A & B", .comparisons = {}, .elements = {20, 80}, .seconds_per_element = {5e-8, 6e-8}};
  record.comparisons.push_back(
      {.work = "run of 10 steps",
       .plain = "loop",
       .fast = "product",
       .plain_seconds = 0.1,
       .fast_seconds = 0.002,
       .load = benchmarks::SpeedComparison::Load{
           .flops_per_step = 256.0, .bytes_per_step = 46.0, .share_of_flops = 0.85, .share_of_bytes = 0.02}});
  record.comparisons.push_back({.work = "map",
                                .plain = "loop",
                                .fast = "table",
                                .plain_seconds = 3.0,
                                .fast_seconds = 0.25,
                                .load = {}});
  return record;
}

class SpeedRecordFile : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  SpeedRecord read(const std::string& text) const {
    report::write_text(file_, text);
    return benchmarks::read_speed_record(file_);
  }
  std::filesystem::path file_ = std::filesystem::temp_directory_path() /
                                ("stickslip-speed-record-" + std::to_string(::getpid()) + ".toml");
};

STICKSLIP_VERIFIES(SpeedRecordFile, "U8");
TEST_F(SpeedRecordFile, ReturnsWhatWasWritten) {
  const SpeedRecord written = sample_record(), found = read(text_of(written));
  EXPECT_EQ(found.processor, written.processor);
  EXPECT_EQ(found.elements, written.elements);
  EXPECT_EQ(found.seconds_per_element, written.seconds_per_element);
  ASSERT_EQ(found.comparisons.size(), 2u);
  EXPECT_EQ(found.comparisons[0].work, "run of 10 steps");
  EXPECT_EQ(found.comparisons[0].plain, "loop");
  EXPECT_EQ(found.comparisons[0].fast, "product");
  EXPECT_EQ(found.comparisons[0].plain_seconds, 0.1);
  EXPECT_EQ(found.comparisons[0].fast_seconds, 0.002);
  ASSERT_TRUE(found.comparisons[0].load.has_value());
  EXPECT_EQ(found.comparisons[0].load->flops_per_step, 256.0);
  EXPECT_EQ(found.comparisons[0].load->bytes_per_step, 46.0);
  EXPECT_EQ(found.comparisons[0].load->share_of_flops, 0.85);
  EXPECT_EQ(found.comparisons[0].load->share_of_bytes, 0.02);
  EXPECT_FALSE(found.comparisons[1].load.has_value());
}

TEST_F(SpeedRecordFile, RefusesWhatCannotBeUsed) {
  const std::string good = text_of(sample_record());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  for (const std::string& bad :
       {std::string("nonsense"), with("fast_seconds = 2", "fast_seconds = -2"), with("plain = ", "plane = "),
        with("[[machine]]", "[[machines]]"), with("bytes_per_step = 46", "bytes_per_step = nan")})
    EXPECT_THROW((void)read(bad), data::InputError) << bad;
}

STICKSLIP_VERIFIES(SpeedRecord, "U8");
TEST(SpeedRecord, OfTheReportHoldsWhatWasMeasured) {
  const SpeedRecord record = benchmarks::read_speed_record();
  EXPECT_GE(record.comparisons.size(), 10u);
  EXPECT_EQ(record.elements.front(), 20);
  EXPECT_EQ(record.elements.back(), 20000);
}

}  // namespace
}  // namespace stickslip::testing
