// SPDX-License-Identifier: MIT
/// Maps made in parts, by several threads, shards and runs: always the same bytes.

#include <signal.h>
#include <cerrno>
#include <cstring>

#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

class MapShards : public SignalledRun {
 protected:
  static inline const std::string closed_form =
      "map paper-figure14 --duration 0.5 --x length=0.8:3:5 --y force=200:800:3 ";
  static inline const std::string finite_elements =
      "map paper-figure14 --duration 0.1 --method fe --x frequency=10:50:3 --y friction=0.3:0.6:4 ";
  static inline const std::string motion =
      "map paper-figure14 --set numerics.time_step=1e-3 --duration 0.5 --quantity work,period --transient "
      "0.2 --x amplitude=1e-3:3e-3:3 --y damping=0:0.02:2 ";
  // A third of a second on one thread: what is damped steps in nodal coordinates.
  static inline const std::string longer =
      "map paper-figure14 --set damping.kelvin_voigt=1e-5 --duration 0.3 --method fe --threads 1 "
      "--x frequency=10:50:9 --y length=1:2:10 ";

  [[nodiscard]] std::string output(const std::string& name) const { return "--output " + name + " "; }

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

  /// The last one first.
  [[nodiscard]] std::string merge(int parts) const {
    std::string arguments = "map --merge ";
    for (int part = parts; part >= 1; --part) arguments += "shard-" + std::to_string(part) + " ";
    return arguments;
  }

  /// Those behind the description and the names of the columns.
  [[nodiscard]] std::ptrdiff_t rows_of(const std::string& name) const {
    return std::ranges::count(contents(name), '\n') - 2;
  }

  /// Sends the signal once the unfinished map has so many rows.
  [[nodiscard]] Ending end_with(int signal, const std::string& arguments, const std::string& unfinished,
                                std::ptrdiff_t rows) const {
    return signalled(arguments, signal, [&] { return rows_of(unfinished) >= rows; });
  }
};

STICKSLIP_VERIFIES(MapShards, "U10");
TEST_F(MapShards, AreTheSameMapOnAnyNumberOfThreads) {
  for (const std::string& map : {closed_form, finite_elements, motion}) {
    const std::string one = made(map + "--threads 1 ", "map.csv");
    for (const std::string threads : {"2", "3", "7"})
      EXPECT_EQ(made(map + "--threads " + threads + " ", "map.csv"), one) << threads;
  }
}

TEST_F(MapShards, MergeToTheBytesOfTheWholeMap) {
  for (const std::string& map : {closed_form, finite_elements, closed_form + "--set friction.decay=inf ",
                                 motion, closed_form + "--states-only "}) {
    const std::string whole = made(map, "whole.csv");
    for (const int parts : {1, 2, 3, 7}) {  // the second map has three evaluations
      make_shards(map, parts);
      EXPECT_EQ(made(merge(parts), "merged.csv"), whole) << parts;
    }
  }
}

TEST_F(MapShards, GoOnAfterAKillWhereverItCame) {
  const std::string whole = made(longer, "whole.csv");
  for (const std::ptrdiff_t rows : {0, 19, 49})
    EXPECT_EQ(end_with(SIGKILL, longer + output("map.csv"), "map.csv.partial", rows).status, 128 + SIGKILL);
  const auto kept = rows_of("map.csv.partial");
  EXPECT_GE(kept, 49);
  const Outcome outcome = run(longer + output("map.csv"));  // a slow one says how far it is
  EXPECT_TRUE(outcome.errors.starts_with("stickslip map: going on from map.csv.partial, which holds " +
                                         std::to_string(kept) + " of 90 evaluations\n"))
      << outcome.errors;
  EXPECT_EQ(contents("map.csv"), whole);
  EXPECT_FALSE(fs::exists("map.csv.partial"));
}

TEST_F(MapShards, GoOnAfterAKillOfAShard) {
  const std::string part = longer + shard(2, 2);
  const std::string whole = made(part, "whole");
  EXPECT_EQ(end_with(SIGKILL, part + output("shard"), "shard.partial", 10).status, 128 + SIGKILL);
  EXPECT_FALSE(fs::exists("shard"));
  EXPECT_EQ(made(part, "shard"), whole);
}

TEST_F(MapShards, EndWithinASecondOfCtrlCAndSayWhatIsKept) {
  std::ofstream("map.csv") << "old";
  const Ending end =
      end_with(SIGINT, longer + output("map.csv") + "--figure map.png --quiet", "map.csv.partial", 5);
  EXPECT_EQ(end.status, 128 + SIGINT);
  EXPECT_LT(end.seconds, 1.0);
  EXPECT_EQ(contents("map.csv"), "old");
  const auto kept = rows_of("map.csv.partial");
  EXPECT_EQ(end.errors,
            "stickslip: interrupted; " + std::to_string(kept) +
                " of 90 evaluations are kept in map.csv.partial, from which the same command goes on\n");
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"map.csv", "map.csv.partial", "stderr", "stdout"}));
}

TEST_F(MapShards, AreNotMadeAgainWhereTheyAreComplete) {
  const std::string part = longer + shard(2, 4);
  const auto expect_answer = [&](bool is_complete_already) {
    const auto answer = json(part + output("shard"));
    EXPECT_EQ(answer["shard"], 2);
    EXPECT_EQ(answer["shards"], 4);
    EXPECT_EQ(answer["evaluations"], 22);
    EXPECT_EQ(answer["complete_already"], is_complete_already);
  };
  expect_answer(false);
  const std::string whole = contents("shard");
  const auto written = fs::last_write_time("shard");
  const std::string said = "\nShard 2 of 4, 22 of 90 evaluations, is complete already in shard\n";
  EXPECT_TRUE(holds(run(part + output("shard")).output, said));
  expect_answer(true);
  // A run that was killed after the shard was in place.
  std::ofstream("shard.partial") << whole;
  EXPECT_TRUE(holds(run(part + output("shard")).output, said));
  EXPECT_FALSE(fs::exists("shard.partial"));
  EXPECT_EQ(fs::last_write_time("shard"), written);
}

TEST_F(MapShards, AreMadeAgainWhereTheyAreDamagedOrOfOtherWork) {
  const std::string part = closed_form + shard(1, 2);
  const std::string whole = made(part, "shard");
  std::string damaged = whole;
  damaged[damaged.rfind(',')] = ';';
  for (const std::string& text : {std::string(), whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1),
                                  whole.substr(0, whole.size() - 1), damaged, whole + "x"}) {
    std::ofstream("shard") << text;
    EXPECT_EQ(json(part + output("shard")).at("complete_already"), false);
    EXPECT_EQ(contents("shard"), whole);
  }
  EXPECT_NE(made(closed_form + shard(2, 2), "shard"), whole);
  EXPECT_EQ(made(part, "shard"), whole);
}

TEST_F(MapShards, DropATornOrDamagedEndOfWhatIsKept) {
  const std::string part = closed_form + shard(1, 2);
  const std::string whole = made(part, "shard");  // what is kept of it looks like its output
  const std::size_t header = whole.find('\n', whole.find('\n') + 1) + 1;
  for (const std::size_t length :
       {std::size_t{0}, header / 2, header - 1, header, header + 10, whole.size() - 1}) {
    std::ofstream("shard.partial") << whole.substr(0, length);
    EXPECT_EQ(made(part, "shard"), whole) << length;
  }
  std::ofstream("shard.partial") << whole.substr(0, header) << "x" << whole.substr(header);
  EXPECT_EQ(made(part, "shard"), whole);
}

TEST_F(MapShards, DoNotGoOnFromOtherWork) {
  const std::string half = made(closed_form + shard(1, 2), "shard");
  std::ofstream("shard.partial") << half;
  const std::string part = shard(1, 2) + output("shard");
  const std::string of_the_case = "map paper-figure14 --y force=200:800:3 " + part;
  expect_refused(closed_form + shard(2, 2) + output("shard"),
                 "its part is 1, but must be 2; remove it or name another --output");
  expect_refused(closed_form + shard(1, 3) + output("shard"), "its parts is 2, but must be 3");
  expect_refused(closed_form + part + "--set beam.density=900",
                 "its beam.density is 1000.0, but must be 900.0");
  expect_refused(of_the_case + "--x length=0.8:3:5", "its excitation.duration is 0.5, but must be 10.0");
  expect_refused(of_the_case + "--duration 0.5 --x length=0.8:3:6",
                 "its x is \"length=0.8:3:5\", but must be \"length=0.8:3:6\"");
  expect_refused(closed_form + part + "--states-only", "its states_only is false, but must be true");
  EXPECT_EQ(contents("shard.partial"), half);
  std::ofstream("shard.partial") << made(motion + shard(1, 2), "motion");
  expect_refused(motion + part + "--tolerance 0.1", "its tolerance is 0.05, but must be 0.1; remove it");
  std::ofstream("shard.partial") << "something else\n";
  expect_refused(closed_form + part, "it is no beginning of a map");
  EXPECT_EQ(contents("shard.partial"), "something else\n");
  // What goes to standard output is kept nowhere.
  std::ofstream("-.partial") << "something else\n";
  EXPECT_EQ(run(closed_form).status, 0);
}

TEST_F(MapShards, OfAnotherOrADamagedMapDoNotMerge) {
  make_shards(closed_form, 3);
  const auto name = [&](int part) { return "shard-" + std::to_string(part) + " "; };
  expect_refused("map --merge " + name(1) + name(3), "shard 2 of 3 is missing beside shard-1");
  expect_refused("map --merge " + name(2), "shard 1, 3 of 3 are missing");
  expect_refused(merge(3) + name(2), "shard-2 is shard 2 of 3, but so is shard-2");
  const std::string good = contents("shard-2");
  (void)made(closed_form + "--hz 20 " + shard(2, 3), "shard-2");
  expect_refused(merge(3),
                 "shard-2 is a shard of another map: its excitation.frequency_hz is 20.0, but must be 25.0");
  std::ofstream("shard-2") << good.substr(0, good.size() - 1);
  expect_refused(merge(3), "shard-2 is damaged in line 7");
  const std::size_t last = good.rfind('\n', good.size() - 2) + 1;
  std::ofstream("shard-2") << good << good.substr(last);
  expect_refused(merge(3), "shard-2 is damaged in line 8");
  std::ofstream("shard-2") << good.substr(0, last);
  expect_refused(merge(3), "shard-2 is not finished: it holds 4 of 5 evaluations");
  std::ofstream("shard-2") << "length_m\n";
  expect_refused(merge(3), "shard-2 is no shard of a map");
  const auto expect_refused_with = [&](const std::string& entry, const std::string& other,
                                       const std::string& sentence) {
    std::string text = good;
    std::ofstream("shard-2") << text.replace(text.find(entry), entry.size(), other);
    expect_refused(merge(3), "shard-2 " + sentence);
  };
  for (const std::string part : {"0", "4"})
    expect_refused_with(R"("part":2)", R"("part":)" + part,
                        "is shard " + part + " of 3, but must be one of 1 to 3\n");
  expect_refused_with(R"("part":2)", R"("part":"two")", "is no shard of a map\n");
  expect_refused_with(R"("program":"stickslip )", R"("program":"another )", "was made by another ");
  (void)made(closed_form + shard(7, 7), "shard-7");
  expect_refused("map --merge " + name(7), "shard 1, 2, 3, 4, 5 and 1 more of 7 are missing beside shard-7");
  std::ofstream("empty") << "";
  std::ofstream("oversized") << "";
  fs::resize_file("oversized", 500'000'001);
  for (const auto& [file, why] : {std::pair{"none", "cannot be opened for reading"},
                                  {".", "is a folder"},
                                  {"empty", "is empty"},
                                  {"oversized", "is larger than the 500000000 bytes"}})
    expect_refused(std::string("map --merge ") + file, fmt::format("--merge: {}: {}", file, why));
}

TEST_F(MapShards, RefuseWhatDoesNotGoTogether) {
  for (const std::string part : {"0/3", "4/3", "1", "a/3", "1/", "1/1000001"})
    expect_refused(closed_form + "--shard " + part + " " + output("shard"),
                   "--shard is '" + part + "', but must be K/M with integers 1 <= K <= M <= 1000000\n");
  expect_refused(closed_form + shard(1, 2), "--shard needs --output FILE");
  expect_refused(closed_form + shard(1, 2) + output("shard") + "--figure map.png", "--shard");
  expect_refused("map paper --merge shard", "--merge");
  expect_refused("map --merge shard --states-only", "--merge");
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"stderr", "stdout"}));
  EXPECT_TRUE(holds(run(closed_form + shard(1'000'000, 1'000'000) + output("shard")).output,
                    "\nShard 1000000 of 1000000, 0 of 15 evaluations, written to shard\n"));
}

TEST_F(MapShards, ShowABarOnATerminalUnlessQuiet) {
  const std::string bar = "\r\033[Kstickslip map  [";
  const auto said = on_terminal(longer + output("map.csv"));
  if (!said) GTEST_SKIP() << "the system gives no pseudo-terminal: " << std::strerror(errno);
  EXPECT_NE(said->find(bar), std::string::npos) << *said;
  EXPECT_NE(said->find("/s  0:0"), std::string::npos) << *said;
  EXPECT_NE(said->find("\r\033[Kpaper-figure14: "), std::string::npos) << *said;
  for (const std::string& quiet : {"--quiet " + closed_form, closed_form + "--quiet "})
    EXPECT_EQ(on_terminal(quiet + output("map.csv")).value().find('\033'), std::string::npos);
}

}  // namespace
}  // namespace stickslip::testing
