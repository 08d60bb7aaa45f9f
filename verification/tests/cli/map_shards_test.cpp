// SPDX-License-Identifier: MIT
/// Maps made by several threads and in parts, which are the same bytes when joined, and drawn.

#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

class MapShards : public SignalledRun {
 protected:
  static inline const std::string closed_form =
      "map paper-figure14 --duration 0.5 --x length=0.8:3:5 --y force=200:800:3 ";
  static inline const std::string ratios =
      "map paper-figure14 --duration 0.5 --x length=0.8:3:5:log --y force=200:800:6 ";
  static inline const std::string finite_elements =
      "map paper-figure14 --duration 0.1 --method fe --x frequency=10:50:3 --y friction=0.3:0.6:4 ";
  static inline const std::string motion =
      "map paper-figure14 --set numerics.time_step=1e-3 --duration 0.5 --quantity work,period --transient "
      "0.2 --x amplitude=1e-3:3e-3:3 --y damping=0:0.02:2 ";

  [[nodiscard]] static std::string output(const std::string& name) { return "--output " + name + " "; }

  [[nodiscard]] std::string made(const std::string& arguments, const std::string& name) const {
    const Outcome outcome = run(arguments + output(name));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return contents(name);
  }

  [[nodiscard]] static std::string shard(int part, int parts) {
    return fmt::format("--shard {}/{} ", part, parts);
  }

  void join(std::vector<int> parts, const std::string& name) const {
    std::ofstream joined(name);
    for (const int part : parts) joined << contents("shard-" + std::to_string(part));
  }
};

STICKSLIP_VERIFIES(MapShards, "U10");
TEST_F(MapShards, AreTheSameMapOnAnyNumberOfThreads) {
  for (const std::string& map : {closed_form, finite_elements, motion}) {
    const std::string one = made(map + "--threads 1 ", "map.csv");
    for (const std::string threads : {"2", "7"})
      EXPECT_EQ(made(map + "--threads " + threads + " ", "map.csv"), one) << threads;
  }
}

TEST_F(MapShards, JoinToTheBytesOfTheWholeMap) {
  for (const std::string& map : {closed_form, finite_elements, closed_form + "--set friction.decay=inf ",
                                 motion, closed_form + "--states-only "}) {
    const std::string whole = made(map, "whole.csv");
    for (const int parts : {1, 3, 7, 20}) {  // the maps have 15, 12 and 6 cells
      std::string joined;
      for (int part = 1; part <= parts; ++part) joined += made(map + shard(part, parts), "shard");
      EXPECT_EQ(joined, whole) << parts;
    }
  }
}

// With an axis in equal ratios, quantities and states alone; in any order behind the first.
TEST_F(MapShards, AreDrawnAsTheWholeMap) {
  install_gnuplot("cat \"${folder}map.csv\" \"${folder}map-values.csv\" > $output\n");
  for (const std::string& map : {closed_form, ratios, motion, closed_form + "--states-only "}) {
    const auto whole = json(map + "--output whole.csv --figure whole.svg");
    for (int part = 1; part <= 3; ++part) (void)made(map + shard(part, 3), fmt::format("shard-{}", part));
    for (const auto& order : {std::vector{1, 2, 3}, {1, 3, 2}}) {
      join(order, "joined.csv");
      const auto drawn = json("map --from joined.csv --figure joined.svg");
      for (const std::string member : {"cells", "states", "converged"})
        EXPECT_EQ(drawn.value(member, nlohmann::json()), whole.value(member, nlohmann::json())) << map;
      EXPECT_EQ(csv(contents("joined.svg")), csv(contents("whole.svg"))) << map;
    }
  }
}

TEST_F(MapShards, ThatAreNoWholeMapAreNotDrawn) {
  for (int part = 1; part <= 3; ++part) (void)made(ratios + shard(part, 3), fmt::format("shard-{}", part));
  const std::string whole = "is a part missing or double?";
  for (const auto& [parts, sentence] : std::vector<std::pair<std::vector<int>, std::string>>{
           {{1, 3}, "beam.axial_force must have two or more values"},
           {{2, 3}, "joined.csv"},
           {{1, 2, 2, 3}, whole},
           {{1, 1, 2, 3}, "joined.csv: line "},
           {{}, "joined.csv: is empty"}}) {
    join(parts, "joined.csv");
    expect_refused("map --from joined.csv --figure map.svg", sentence);
  }
  const std::string names = "length_m,axial_force_N,force_ratio,state\n";
  for (const auto& [text, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"mode,frequency\n1,2\n", "is no map: its columns are mode, frequency"},
           {"length_m,axial_force_N,work_J,state\n", "is no map: "},
           {"length_m,mass,state\n1,2,stick\n", "is no map: "},
           {names, "joined.csv: has no point"},
           {names + "1,2,0.5,stuck\n", "line 2 is no point of a map"},
           {names + "1,x,0.5,stick\n", "line 2 is no point of a map"},
           {names + "1,1,2,stick\n2,1,2,stick\n1,2,2,stick\n", "the point 2, 2 must be there once"},
           {names + "1,1,2,stick\n2,1,2,stick\n4,1,2,stick\n5,1,2,stick\n", "beam.length must have"}}) {
    std::ofstream("joined.csv") << text;
    expect_refused("map --from joined.csv --figure map.svg", sentence);
  }
  expect_refused("map --from none --figure map.svg", "none: cannot be opened for reading");
  expect_refused("map --from joined.csv", "--figure");
  expect_refused("map --from map.svg --figure map.svg", "map.svg");
}

TEST_F(MapShards, AreOneToAMillion) {
  for (const std::string part : {"0/3", "4/3", "1", "1/", "1/1000001"})
    expect_refused(closed_form + "--shard " + part + " " + output("shard"),
                   "--shard is '" + part + "', but must be K/M with integers 1 <= K <= M <= 1000000\n");
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"stderr", "stdout"}));
  EXPECT_TRUE(holds(run(closed_form + shard(999'999, 1'000'000) + output("shard")).output,
                    "\n0 cells written to shard: "));
  const auto answer = json(closed_form + shard(2, 4) + output("shard"));
  EXPECT_EQ(answer["shard"], 2);
  EXPECT_EQ(answer["shards"], 4);
  EXPECT_EQ(answer["cells"], 4);
}

}  // namespace
}  // namespace stickslip::testing
