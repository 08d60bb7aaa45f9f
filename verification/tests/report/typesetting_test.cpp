// SPDX-License-Identifier: MIT
/// LaTeX that is missing, or cannot typeset the report: a sentence that says so, and every file that was
/// there.

#include "render/document.hpp"
#include "render/output_folder.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class Typesetting : public Drawing {
 protected:
  /// What is said of a report whose folder holds a figure and an older PDF, both of which stay.
  [[nodiscard]] std::string complaint() const {
    report::OutputFolder output(folder());
    output.write("fig2.png", "figure");
    output.write("vv-report.pdf", "old");
    const std::string sentence =
        error_message_of<std::runtime_error>([&] { report::typeset(output.scratch(), output); });
    EXPECT_EQ(contents(folder() + "/fig2.png"), "figure");
    EXPECT_EQ(contents(folder() + "/vv-report.pdf"), "old");
    return sentence;
  }

  [[nodiscard]] std::string folder() const {
    return std::filesystem::canonical(path("")).string() + "/report";
  }
};

STICKSLIP_VERIFIES(Typesetting, "U12");
TEST_F(Typesetting, SaysThatLatexIsMissingAndWhereTheFiguresAre) {
  ::setenv("PATH", path("tools").c_str(), 1);
  EXPECT_EQ(
      complaint(),
      "lualatex is not installed or not on the search path, so that there is no PDF report; the figures "
      "are in " +
          folder());
}

TEST_F(Typesetting, SaysWhatLatexLacks) {
  install_tool("lualatex",
               "printf \"! LaTeX Error: File \\`lmodern.sty' not found.\\n\\n\" >vv-report.log\nexit 1\n");
  EXPECT_EQ(complaint(),
            "lualatex could not typeset the report (status 1): LaTeX Error: File `lmodern.sty' not found. ");
}

}  // namespace
}  // namespace stickslip::testing
