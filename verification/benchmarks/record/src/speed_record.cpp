// SPDX-License-Identifier: MIT
#include "stickslip/benchmarks/speed_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stickslip/data/toml_record.hpp"

namespace stickslip::benchmarks {

namespace {

SpeedComparison comparison_of(const data::Record& record) {
  SpeedComparison comparison{.work = record.text("work"),
                             .plain = record.text("plain"),
                             .fast = record.text("fast"),
                             .plain_seconds = record.number("plain_seconds"),
                             .fast_seconds = record.number("fast_seconds"),
                             .load = {}};
  if (!(comparison.plain_seconds > 0.0 && comparison.fast_seconds > 0.0))
    record.fail("plain_seconds and fast_seconds must be positive");
  if (record.has("flops_per_step"))
    comparison.load = {.flops_per_step = record.number("flops_per_step"),
                       .bytes_per_step = record.number("bytes_per_step"),
                       .share_of_flops = record.number("share_of_flops"),
                       .share_of_bytes = record.number("share_of_bytes")};
  return comparison;
}

}  // namespace

SpeedRecord read_speed_record() {
  return read_speed_record(std::filesystem::path(STICKSLIP_BENCHMARKS_DIRECTORY) / "results" / "speed.toml");
}

SpeedRecord read_speed_record(const std::filesystem::path& file) {
  SpeedRecord record;
  record.comparisons =
      data::read_all(file, "comparison",
                     {"work", "plain", "fast", "plain_seconds", "fast_seconds", "flops_per_step",
                      "bytes_per_step", "share_of_flops", "share_of_bytes"},
                     comparison_of);
  data::read_all(file, "scale", {"elements", "seconds_per_element"}, [&](const data::Record& row) {
    record.elements.push_back(static_cast<int>(row.number("elements")));
    record.seconds_per_element.push_back(row.number("seconds_per_element"));
    return 0;
  });
  data::read_all(file, "machine", {"processor"}, [&](const data::Record& row) {
    record.processor = row.text("processor");
    return 0;
  });
  return record;
}

std::string text_of(const SpeedRecord& record) {
  std::string text =
      "# Times of the same work by a plain and by a fast method in one run. Written by the benchmarks. Use "
      "the ratios.\n";
  text += fmt::format("\n[[machine]]\nprocessor = \"{}\"\n", record.processor);
  for (const SpeedComparison& line : record.comparisons) {
    text += fmt::format(
        "\n[[comparison]]\nwork = \"{}\"\nplain = \"{}\"\nfast = \"{}\"\nplain_seconds = "
        "{:.3e}\nfast_seconds = {:.3e}\n",
        line.work, line.plain, line.fast, line.plain_seconds, line.fast_seconds);
    if (line.load)
      text += fmt::format(
          "flops_per_step = {:.0f}\nbytes_per_step = {:.0f}\nshare_of_flops = {:.3f}\nshare_of_bytes = "
          "{:.3f}\n",
          line.load->flops_per_step, line.load->bytes_per_step, line.load->share_of_flops,
          line.load->share_of_bytes);
  }
  for (std::size_t i = 0; i < record.elements.size(); ++i)
    text += fmt::format("\n[[scale]]\nelements = {}\nseconds_per_element = {:.3e}\n", record.elements[i],
                        record.seconds_per_element[i]);
  return text;
}

}  // namespace stickslip::benchmarks
