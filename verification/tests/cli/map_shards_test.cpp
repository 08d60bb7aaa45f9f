// SPDX-License-Identifier: MIT
/// Maps made in parts, by several threads, shards and runs: always the same bytes.

#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

class MapShards : public KilledRun {
 protected:
  static inline const std::string closed_form =
      "map paper-figure14 --duration 0.5 --x length=0.8:3:5 --y force=200:800:3 ";
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

  void make_shards(const std::string& map, int parts) const {
    for (int part = 1; part <= parts; ++part)
      (void)made(map + shard(part, parts), "shard-" + std::to_string(part));
  }

  [[nodiscard]] static std::string shard(int part, int parts) {
    return "--shard " + std::to_string(part) + "/" + std::to_string(parts) + " ";
  }

  // The last one first.
  [[nodiscard]] static std::string merge(int parts) {
    std::string arguments = "map --merge ";
    for (int part = parts; part >= 1; --part) arguments += "shard-" + std::to_string(part) + " ";
    return arguments;
  }

  // Those behind the description and the names of the columns.
  [[nodiscard]] static std::ptrdiff_t rows_of(const std::string& name) {
    return std::ranges::count(contents(name), '\n') - 2;
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

TEST_F(MapShards, MergeToTheBytesOfTheWholeMap) {
  for (const std::string& map : {closed_form, finite_elements, closed_form + "--set friction.decay=inf ",
                                 motion, closed_form + "--states-only "}) {
    const std::string whole = made(map, "whole.csv");
    for (const int parts : {1, 3, 7}) {  // the second map has three evaluations
      make_shards(map, parts);
      EXPECT_EQ(made(merge(parts), "merged.csv"), whole) << parts;
    }
  }
}

TEST_F(MapShards, AreCompleteAfterAKillWhereverItCame) {
  kill(closed_form + "--threads 1 " + output("out/map.csv"), {"map.csv"});
  kill(closed_form + shard(2, 3) + "--threads 1 " + output("out/shard"), {"shard"}, 2);
}

// Killed before its tenth change each time, a run keeps some evaluations more.
TEST_F(MapShards, GoOnFromWhatKilledRunsHaveKept) {
  const std::string whole = made(closed_form, "whole.csv"), command = closed_form + output("map.csv");
  for (const std::ptrdiff_t rows : {3, 6}) {
    EXPECT_EQ(killed_before(10, command + "--threads 1"), 128 + SIGKILL);
    EXPECT_GE(rows_of("map.csv.partial"), rows);
  }
  const auto kept = rows_of("map.csv.partial");
  EXPECT_EQ(
      run(command).errors,
      fmt::format("stickslip map: going on from map.csv.partial, which holds {} of 15 evaluations\n", kept));
  EXPECT_EQ(contents("map.csv"), whole);
  EXPECT_FALSE(fs::exists("map.csv.partial"));
}

TEST_F(MapShards, SayAfterCtrlCHowMuchIsKept) {
  std::ofstream("map.csv") << "old";
  const auto ended = on_terminal(
      "map damped --method fe --duration 0.5 --threads 1 --x frequency=10:50:9 --y length=1:2:10 " +
          output("map.csv") + "--figure map.png",
      "[#");
  if (!ended) GTEST_SKIP() << "the system gives no pseudo-terminal";
  EXPECT_EQ(ended->status, 128 + SIGINT);
  EXPECT_TRUE(
      ended->output.ends_with(fmt::format("\r\033[Kstickslip: interrupted; {} of 90 evaluations are kept in "
                                          "map.csv.partial, from which the same command goes on\r\n",
                                          rows_of("map.csv.partial"))))
      << ended->output;
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"map.csv", "map.csv.partial"}));
  EXPECT_EQ(contents("map.csv"), "old");
}

TEST_F(MapShards, AreNotMadeAgainWhereTheyAreComplete) {
  const std::string part = closed_form + shard(2, 4) + output("shard");
  const auto expect_answer = [&](bool is_complete_already) {
    const auto answer = json(part);
    EXPECT_EQ(answer["shard"], 2);
    EXPECT_EQ(answer["shards"], 4);
    EXPECT_EQ(answer["evaluations"], 4);
    EXPECT_EQ(answer["complete_already"], is_complete_already);
  };
  expect_answer(false);
  const auto written = fs::last_write_time("shard");
  fs::copy("shard", "shard.partial");  // of a run that was killed when the shard was in place
  expect_answer(true);
  EXPECT_FALSE(fs::exists("shard.partial"));
  EXPECT_TRUE(holds(run(part).output, "\nShard 2 of 4, 4 of 15 evaluations, is complete already in shard\n"));
  EXPECT_EQ(fs::last_write_time("shard"), written);
}

// As a shard, which is then made again, or as what is kept of one, which looks the same: its whole rows count.
TEST_F(MapShards, AreMadeAgainIfDamaged) {
  const std::string part = closed_form + shard(1, 2), whole = made(part, "shard");
  const std::size_t header = whole.find('\n', whole.find('\n') + 1) + 1;
  std::vector<std::string> texts{whole + "x", whole.substr(0, header) + "x" + whole.substr(header),
                                 std::string(whole).replace(whole.rfind(','), 1, ";")};
  for (const std::size_t length : {std::size_t{0}, header / 2, header, header + 10, whole.size() - 1})
    texts.push_back(whole.substr(0, length));
  for (const std::string& text : texts) {
    std::ofstream("shard") << text;
    EXPECT_EQ(json(part + output("shard")).at("complete_already"), false);
    EXPECT_EQ(contents("shard"), whole);
    fs::remove("shard");
    std::ofstream("shard.partial") << text;
    EXPECT_EQ(made(part, "shard"), whole) << text.size();
  }
  EXPECT_NE(made(closed_form + shard(2, 2), "shard"), whole);
  EXPECT_EQ(made(part, "shard"), whole);
}

TEST_F(MapShards, DoNotGoOnFromOtherWork) {
  const std::string half = made(closed_form + shard(1, 2), "shard"),
                    of_motion = made(motion + shard(1, 2), "motion"), other = "something else\n";
  const std::string of_the_case = "map paper-figure14 --y force=200:800:3 " + shard(1, 2);
  for (const auto& [kept, arguments, reason] : std::vector<std::array<std::string, 3>>{
           {half, closed_form + shard(2, 2),
            "its part is 1, but must be 2; remove it or name another --output"},
           {half, closed_form + shard(1, 3), "its parts is 2, but must be 3"},
           {half, closed_form + shard(1, 2) + "--set beam.density=900 ",
            "its beam.density is 1000.0, but must be 900.0"},
           {half, of_the_case + "--x length=0.8:3:5 ", "its excitation.duration is 0.5, but must be 10.0"},
           {half, of_the_case + "--duration 0.5 --x length=0.8:3:6 ",
            "its x is \"length=0.8:3:5\", but must be \"length=0.8:3:6\""},
           {half, closed_form + shard(1, 2) + "--states-only ", "its states_only is false, but must be true"},
           {of_motion, motion + shard(1, 2) + "--tolerance 0.1 ", "its tolerance is 0.05, but must be 0.1"},
           {other, closed_form + shard(1, 2), "it is no beginning of a map"}}) {
    std::ofstream("shard.partial") << kept;
    expect_refused(arguments + output("shard"), reason);
    EXPECT_EQ(contents("shard.partial"), kept);
  }
  // What goes to standard output is kept nowhere.
  std::ofstream("-.partial") << other;
  EXPECT_EQ(run(closed_form).status, 0);
}

TEST_F(MapShards, OfAnotherOrADamagedMapDoNotMerge) {
  make_shards(closed_form, 3);
  (void)made(closed_form + shard(7, 7), "shard-7");
  for (const auto& [files, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"shard-1 shard-3", "shard 2 of 3 is missing beside shard-1"},
           {"shard-2", "shard 1, 3 of 3 are missing"},
           {"shard-3 shard-2 shard-1 shard-2", "shard-2 is shard 2 of 3, but so is shard-2"},
           {"shard-7", "shard 1, 2, 3, 4, 5 and 1 more of 7 are missing beside shard-7"},
           {"none", "--merge: none: cannot be opened for reading"},
           {".", "--merge: .: is a folder"}})
    expect_refused("map --merge " + files, sentence);

  const std::string good = contents("shard-2");
  const std::size_t last = good.rfind('\n', good.size() - 2) + 1;
  const auto with = [&](const std::string& entry, const std::string& other) {
    return std::string(good).replace(good.find(entry), entry.size(), other);
  };
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {made(closed_form + "--hz 20 " + shard(2, 3), "other"),
            "is a shard of another map: its excitation.frequency_hz is 20.0, but must be 25.0"},
           {good.substr(0, good.size() - 1), "is damaged in line 7"},
           {good + good.substr(last), "is damaged in line 8"},
           {good.substr(0, last), "is not finished: it holds 4 of 5 evaluations"},
           {"length_m\n", "is no shard of a map"},
           {with(R"("part":2)", R"("part":0)"), "is shard 0 of 3, but must be one of 1 to 3\n"},
           {with(R"("part":2)", R"("part":4)"), "is shard 4 of 3, but must be one of 1 to 3\n"},
           {with(R"("part":2)", R"("part":"two")"), "is no shard of a map\n"},
           {with(R"("program":"stickslip )", R"("program":"another )"), "was made by another "}}) {
    std::ofstream("shard-2") << text;
    expect_refused(merge(3), "shard-2 " + why);
  }
  std::ofstream("shard-2") << "";
  expect_refused(merge(3), "--merge: shard-2: is empty");
  fs::resize_file("shard-2", 500'000'001);
  expect_refused(merge(3), "--merge: shard-2: is larger than the 500000000 bytes");
}

TEST_F(MapShards, AreOneToAMillion) {
  for (const std::string part : {"0/3", "4/3", "1", "1/", "1/1000001"})
    expect_refused(closed_form + "--shard " + part + " " + output("shard"),
                   "--shard is '" + part + "', but must be K/M with integers 1 <= K <= M <= 1000000\n");
  expect_refused(closed_form + shard(1, 2), "--shard needs --output FILE");
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"stderr", "stdout"}));
  EXPECT_TRUE(holds(run(closed_form + shard(1'000'000, 1'000'000) + output("shard")).output,
                    "\nShard 1000000 of 1000000, 0 of 15 evaluations, written to shard\n"));
}

}  // namespace
}  // namespace stickslip::testing
