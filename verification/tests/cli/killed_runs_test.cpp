// SPDX-License-Identifier: MIT
/// Runs that are killed at fifty random moments: what has a name of its own is whole each time, and the same
/// command completes. The whole report, ended by a signal while LaTeX is at work.

#include <signal.h>

#include "render/report.hpp"
#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

class KilledRunLong : public KilledRun {};

STICKSLIP_VERIFIES(KilledRunLong, "U12");
TEST_F(KilledRunLong, OfReportLeavesOnlyWhatIsWholeAtFiftyMoments) {
  kill(50, "report --quiet --only fig1,fig2,fig7 --output out/",
       {"fig1-values.csv", "fig1.pdf", "fig1.png", "fig2.csv", "fig2-values.csv", "fig2.pdf", "fig2.png",
        "fig7.csv", "fig7-values.csv", "fig7.pdf", "fig7.png", "studies/friction_curve.json",
        "studies/mode_shapes.json"});
}

TEST_F(KilledRunLong, OfMapLeavesOnlyWhatIsWholeAtFiftyMoments) {
  const std::string map =
      "map paper-figure14 --set damping.kelvin_voigt=1e-5 --duration 0.3 --method fe "
      "--x frequency=10:50:15 --y length=1:2:16 ";
  kill(50, map + "--output out/map.csv --figure out/map.png", {"map.csv", "map.png"});
  const std::string whole = contents("out/map.csv");
  for (const std::string part : {"1", "2"}) {
    kill(25, map + "--shard " + part + "/2 --output out/shard", {"shard"});
    fs::rename("out/shard", "shard-" + part);
  }
  EXPECT_EQ(run("map --merge shard-1 shard-2").output, whole);
}

class WholeReport : public SleepingTool {};

STICKSLIP_VERIFIES(WholeReport, "U12");
TEST_F(WholeReport, EndedDuringLatexKeepsWhatWasThere) {
  fs::create_directory(out());
  std::ofstream(out("vv-report.pdf")) << "old";
  install_sleeper("lualatex");
  const std::string said = said_after(SIGINT, "report --quiet --output '" + out() + "'");
  EXPECT_TRUE(said.starts_with("interrupted after 9")) << said;
  const std::vector<std::string> files = all_files(out());
  for (const std::string& name : report::figure_names())
    for (const std::string& file : {name + ".pdf", name + ".png"})
      EXPECT_TRUE(std::ranges::binary_search(files, file)) << file;
  EXPECT_GT(std::ranges::count_if(files, [](const auto& name) { return name.ends_with(".csv"); }), 20);
  EXPECT_EQ(contents(out("vv-report.pdf")), "old");
}

}  // namespace
}  // namespace stickslip::testing
