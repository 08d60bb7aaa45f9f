// SPDX-License-Identifier: MIT
#include "command.hpp"
#include "commands.hpp"
#include "stickslip/data/case_file.hpp"

namespace stickslip::cli {

namespace {

struct CasesOptions {};

Answer listed_cases(const CasesOptions& /*options*/, Outputs& /*outputs*/) {
  Table table{.columns = {{"name", "name"}, {"title", "title"}, {"", "file"}}, .rows = {}};
  for (const auto& [name, title] : data::list_cases())
    table.rows.push_back({word(name), word(title), word(data::find_case(name).string())});
  Answer answer;
  answer.text = table.text(false);
  answer.add_members({{"cases", table.json()}});
  return answer;
}

}  // namespace

void add_cases_command(CLI::App& app) {
  add<CasesOptions>(app, {.name = "cases",
                          .help = "List the published cases",
                          .examples = {"stickslip cases", "stickslip cases --json"},
                          .add_options = [](CLI::App& command, CasesOptions&) { add_json_option(command); },
                          .run = listed_cases});
}

}  // namespace stickslip::cli
