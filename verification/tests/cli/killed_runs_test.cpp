// SPDX-License-Identifier: MIT
/// Reports that are killed before changes of files, and the whole report, ended by a signal while LaTeX is at work.

#include "render/report.hpp"
#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class KilledReport : public KilledRun {};

STICKSLIP_VERIFIES(KilledReport, "U12");
TEST_F(KilledReport, LeavesOnlyWhatIsWhole) {
  kill("report --quiet --only fig2 --output out/",
       {"fig2-values.csv", "fig2.csv", "fig2.pdf", "fig2.png", "studies/friction_curve.json"}, 5);
}

class WholeReport : public SignalledRun {};

STICKSLIP_VERIFIES(WholeReport, "U12");
TEST_F(WholeReport, EndedDuringLatexKeepsWhatWasThere) {
  std::filesystem::create_directory("out");
  std::ofstream("out/vv-report.pdf") << "old";
  const std::string said = said_after(SIGINT, false, "lualatex", "report --quiet --output out");
  EXPECT_TRUE(said.starts_with("interrupted after 9")) << said;
  const Contents files = contents_of("out");
  for (const std::string& name : report::figure_names())
    for (const std::string& file : {name + ".pdf", name + ".png"}) EXPECT_TRUE(files.contains(file)) << file;
  EXPECT_GT(std::ranges::count_if(files, [](const auto& file) { return file.first.ends_with(".csv"); }), 20);
  EXPECT_EQ(files.at("vv-report.pdf"), "old");
}

}  // namespace
}  // namespace stickslip::testing
