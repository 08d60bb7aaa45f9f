// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "case_options.hpp"
#include "commands.hpp"

namespace stickslip::cli {

namespace {

void print_table(const std::vector<data::CaseListing>& cases) {
  std::size_t width = 0;
  for (const auto& listing : cases) width = std::max(width, listing.name.size());
  for (const auto& listing : cases) fmt::print("{:<{}}  {}\n", listing.name, width, listing.title);
}

Json to_json(const std::vector<data::CaseListing>& cases) {
  Json list = Json::array();
  for (const auto& listing : cases)
    list.push_back(
        {{"name", listing.name}, {"title", listing.title}, {"file", data::find_case(listing.name).string()}});
  return {{"cases", list}};
}

}  // namespace

void add_cases_command(CLI::App& app) {
  auto* command = app.add_subcommand("cases", "List the published cases");
  auto json = std::make_shared<bool>(false);
  add_json_option(*command, *json);
  add_examples(*command, {"stickslip cases", "stickslip cases --json"});
  command->callback([json] {
    const auto cases = data::list_cases();
    if (*json)
      print_json(to_json(cases));
    else
      print_table(cases);
  });
}

}  // namespace stickslip::cli
