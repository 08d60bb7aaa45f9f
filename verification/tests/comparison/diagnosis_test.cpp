// SPDX-License-Identifier: MIT
/// What a result that differs from a published data set looks like: files of known mistakes.

#include "comparison/diagnosis/relations.hpp"
#include "comparison/diagnosis/wrong_model_recipes.hpp"
#include "comparison/samples.hpp"
#include "own_copy.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Diagnosis;
using comparison::Finding;
using comparison::Hypothesis;
using comparison::Quantity;
using Values = std::vector<double>;

// A user's file with a column of a data set, for the beam of the paper if there are several.
class File : public OwnCopy {
 public:
  File(const std::string& set, const std::string& value)
      : OwnCopy(published_package(), set, columns_with(published_package().resource(set), value)),
        value_(value) {
    if (reference().resource.field("beam") != nullptr)
      keep([&](std::size_t row) { return reference().column("beam").text[row] == "paper"; });
  }

  Values& values() { return (*this)[value_]; }

 private:
  static std::vector<std::string> columns_with(const data::Resource& resource, const std::string& value) {
    std::vector<std::string> columns = resource.primary_key;
    columns.insert(columns.end(), {value, "change", "time"});
    return columns;
  }

  std::string value_;
};

// --- tolerances

struct Diagnosed {
  const char* set;
  const char* value;
  Quantity quantity;
  data::Case problem;
};

// The effect of these goes to zero with the mesh or the step, so that no tolerance is below it.
bool is_of_discretisation(const comparison::WrongModelRecipe& recipe) {
  return recipe.depends_on_mesh || recipe.force_row ||
         (recipe.scheme && recipe.wrong_model.name != "damping-added");
}

void expect_tolerance_below_a_third(const Diagnosed& diagnosed) {
  const auto& [set, field, quantity, problem] = diagnosed;
  const auto& compared = *std::ranges::find(published_package().resource(set).comparison->values, field,
                                            &data::ComparedValue::field);
  File file(set, field);
  // A quarter of the rows, or about six where each takes long, drawn by a seed.
  const bool is_slow = quantity == Quantity::force_maximum || quantity == Quantity::critical_amplitude;
  const bool is_event = quantity == Quantity::contact_event;
  const auto& rule = *published_package().resource(set).diagnosis;
  const int size = static_cast<int>(file.values().size()),
            one_of = is_slow ? size / 6 : std::min(4, size / 4);
  RandomNumbers draw(59);
  // A run goes as far as the last of them.
  const bool is_run = !is_event && comparison::properties_of(quantity).state == comparison::State::stick_slip;
  file.keep([&](std::size_t row) {
    return (!is_event || row < 40) && (!is_run || file[rule.abscissa][row] <= 0.2) &&
           draw.whole(1, one_of) == 1;
  });
  ASSERT_GE(file.values().size(), 3u) << set << ", " << field;
  const Values abscissa = file[rule.abscissa], data = file.values();
  const auto models =
      comparison::relative_to_data(comparison::model_results(problem, quantity, abscissa), data);
  const auto [least, greatest] = std::ranges::minmax(data);
  const double scale = compared.norm == data::Norm::range ? greatest - least : std::max(-least, greatest);
  int wrong_models = 0;
  for (const auto& member : models.wrong_models) {
    const auto& recipe = comparison::recipe_of(member.name);
    if (std::ranges::count(recipe.wrong_model.changes, quantity) == 0 || is_of_discretisation(recipe))
      continue;
    ++wrong_models;
    double change = 0.0;
    for (std::size_t i = 0; i < data.size(); ++i)
      change = std::max(
          change, std::abs(member.values[i] - data[i]) / comparison::unit_of(compared.norm, data[i], scale));
    EXPECT_GE(change, 3.0 * compared.tolerance) << set << ", " << field << ": " << member.name;
  }
  EXPECT_GE(wrong_models, 3) << set << ", " << field;
}

// Steps that damp what the mesh cannot resolve, as in the diagnosis.
data::Case undamped_case() {
  return with_values(with(data::load_case("paper"), shaking(25.0, 1e-3)),
                     {{"numerics.spectral_radius", 0.5}, {"numerics.time_step", 2.5e-5}});
}

STICKSLIP_VERIFIES(ToleranceOf, "X20");
TEST(ToleranceOf, DataSetIsAThirdOfAListedMistake) {
  const data::Case paper = data::load_case("paper"), held = data::load_case("paper-figure9"),
                   // On 40 elements with 1e-5 s the same mistakes move the events by 2.6e-4 s or more.
      damped = with_the_settings_of_the_paper("damped");
  for (const Diagnosed& diagnosed :
       {Diagnosed{"stick-frequencies", "frequency", Quantity::stick_frequency, paper},
        {"slip-frequencies", "frequency", Quantity::slip_frequency, paper},
        {"participation", "participation", Quantity::participation, paper},
        {"static-shapes", "shape", Quantity::quasi_static_shape, paper},
        {"stick-history", "midspan_displacement", Quantity::stick_displacement, held},
        {"stick-history", "friction_force", Quantity::stick_force, held},
        {"stick-history-ten-modes", "midspan_displacement", Quantity::stick_displacement, held},
        {"stick-history-ten-modes", "friction_force", Quantity::stick_force, held},
        {"friction-maxima", "friction_force", Quantity::force_maximum, paper},
        {"critical-amplitudes", "amplitude", Quantity::critical_amplitude, paper},
        {"stick-slip-events", "time", Quantity::contact_event, damped},
        {"stick-slip-history", "tip_displacement", Quantity::tip_displacement, damped},
        {"stick-slip-history", "friction_force", Quantity::friction_force, damped},
        {"undamped-history-25", "tip_displacement", Quantity::tip_displacement, undamped_case()}})
    expect_tolerance_below_a_third(diagnosed);
}

// --- known mistakes

constexpr double quarter_turn = std::numbers::pi / 2.0;

using Spoil = std::function<void(File&)>;

Spoil each(const std::function<double(double)>& change) {
  return [=](File& file) { std::ranges::transform(file.values(), file.values().begin(), change); };
}
Spoil times_plus(double factor, double plus) {
  return each([=](double value) { return factor * value + plus; });
}
Spoil times(double factor) { return times_plus(factor, 0.0); }
Spoil plus(double constant) { return times_plus(1.0, constant); }
// The values of another data set but for the first row, and a deviation of them that alternates.
Spoil those_of(const char* set, const char* field, double deviation = 0.0) {
  return [=](File& file) {
    const Values right = file.values();
    file.values() = File(set, field).values();
    for (std::size_t n = 0; n < right.size() && deviation > 0.0; ++n)
      file.values()[n] += (n % 2 == 0 ? deviation : -deviation) * right[n];
    file.erase(0);
  };
}
Spoil wrong_at(std::initializer_list<std::size_t> rows, double error = 1e-4) {
  return [rows = std::vector(rows), error](File& file) {
    for (const std::size_t row : rows) file.values()[row] += error;
  };
}
// Without a mode; a frequency above all others at the end.
Spoil without_mode(std::ptrdiff_t mode) {
  return [=](File& file) {
    file.values().erase(file.values().begin() + mode - 1);
    file.values().push_back(1.2 * file.values().back());
  };
}
// `told` is all that is said if it ends with a line, else a part of it. Of every other explanation the file is farther away by
// this factor at least.
struct Mistake {
  const char *set, *value;
  Spoil spoil;
  std::string told;
  double margin{1e5};
};
using Mistakes = std::vector<Mistake>;

Mistakes wrong_factors() {
  Mistakes all;
  for (const auto& [factor, told] : {std::pair{-1.0, "the opposite sign"},
                                     {0.5, "half"},
                                     {std::numbers::sqrt2, "EI is double"},
                                     {std::sqrt(0.5), "EI is half"},
                                     {4.0 * quarter_turn, "rad/s for Hz"},
                                     {0.25 / quarter_turn, "divided by 2 pi"},
                                     {1e3, "mm for m"},
                                     {1e-3, "kN for N"},
                                     {1e2, "cm for m"},
                                     {1e-2, "times 1/100: another unit"},
                                     {1e6, "um for m"},
                                     {-0.5, "times -1/2"},
                                     {-1e3, "times -1000: another unit"},
                                     {-1e-3, "times -1/1000: another unit"},
                                     {1.037, "times 1.037"}})
    all.push_back({"stick-frequencies", "frequency", times(factor), told});
  const Mistakes others{
      {"stick-history", "friction_force", times(-1.0), "like 'force-sign'"},
      {"critical-amplitudes", "amplitude", times(2.0), "like 'peak-to-peak-amplitude'"},
      {"classification", "force_ratio", times(0.5), "like 'peak-to-peak-amplitude'"},
      {"friction-maxima", "friction_force", times(0.5), "like 'peak-to-peak-amplitude'"},
      {"mode-shapes", "shape", times(-3.0), "MAC = 1"},
      {"friction-powers", "power", times(0.981), "all values are those of the data set times 0.981\n"}};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

Mistakes wrong_angles_and_constants() {
  const char *phase = "force_phase", *steady = "damped-steady-state", *events = "stick-slip-events";
  return {{steady, phase, times(-1.0), "times -1: the opposite sign"},
          {steady, phase, plus(2.0 * quarter_turn), "plus half a turn"},
          {steady, phase, plus(-quarter_turn), "minus a quarter turn: those of a cosine", 9.0},
          {steady, phase, plus(quarter_turn), "plus a quarter turn", 9.0},
          {steady, phase, times_plus(-1.0, 2.0 * quarter_turn), "with the opposite sign, plus half a turn"},
          {steady, phase, times_plus(-1.0, -quarter_turn), "with the opposite sign, minus a quarter turn"},
          {steady, phase, times_plus(-1.0, quarter_turn), "with the opposite sign, plus a quarter turn"},
          {steady, phase, times_plus(-1.0, 5.0 * quarter_turn), "opposite sign, plus a quarter turn"},
          {steady, phase, times(180.0 / std::numbers::pi), "in degrees"},
          {steady, phase, times(0.25 / quarter_turn), "times 1/(2 pi)"},
          {steady, phase, plus(0.3), "plus 0.3 rad"},
          {"undamped-history-25", "tip_displacement", plus(2e-4),
           "all values are those of the data set plus 0.0002 m\n"},
          {"static-shapes", "shape", plus(-1.0), "all values are those of the data set minus 1\n"},
          {events, "time", plus(-5e-4), "all events are 0.0005 s early\n"},
          // So late that no event has its match: they are taken by their number, as many as both have.
          {events, "time",
           [](File& file) {
             file.repeat(file.values().size() - 1);
             file["index"].back() += 1.0;
             plus(0.3)(file);
           },
           "all events are 0.3 s late\n"}};
}

Mistakes wrong_data() {
  const char *stick = "stick-frequencies", *hz = "frequency", *mid = "midspan_displacement",
             *tip = "tip_displacement", *force = "friction_force";
  return {{stick, hz, without_mode(3), "mode 3 of the data set is missing in the file\n"},
          {"slip-frequencies", hz, without_mode(1), "mode 1 of the data set is missing in the file\n"},
          // beyond the tolerance it is said how near they are
          {stick, hz, those_of("slip-frequencies", hz), "the values are those of slip-frequencies\n"},
          {"slip-frequencies", hz, those_of(stick, hz), "the values are those of stick-frequencies\n"},
          {"stick-history-ten-modes", force, those_of("stick-history", force),
           "the values are those of stick-history\n"},
          {"undamped-history-25", tip, those_of("undamped-history-35", tip),
           "the values are those of undamped-history-35\n"},
          {stick, hz, those_of("slip-frequencies", hz, 1e-4),
           "the values are those of slip-frequencies, to 0.01 %\n", 100.0},
          {"stick-history", force, times(0.0), "all values are 0\n"},
          {"damped-stick-history", mid, wrong_at({100}), "only 1 of 200 values differs, at time = 0.505 s\n"},
          {"damped-stick-history", mid, wrong_at({199, 7, 30}),
           "only 3 of 200 values differ, the first at time = 0.04 s\n"},
          {"friction-maxima", force, wrong_at({60}, 2.0),
           "only 1 of 120 values differs, at frequency = 61 Hz\n"}};
}

// --- wrong models beside the data set

using IsKept = std::function<bool(const File&, std::size_t)>;

bool always(const File&, std::size_t) { return true; }
IsKept until(double time) {
  return [=](const File& file, std::size_t row) { return file.table.column("time")->values[row] <= time; };
}

// The effect of a mistake on the rows that are kept, at these later times.
Mistake wrong_model(const char* set, const char* value, const char* mistake, Quantity quantity,
                    const data::Case& problem, const IsKept& is_kept, double margin = 1e5,
                    double later = 0.0) {
  const auto spoil = [=](File& file) {
    const auto& resource = file.reference().resource;
    const std::string abscissa =
        resource.diagnosis ? resource.diagnosis->abscissa : resource.primary_key.front();
    file.keep([&](std::size_t row) { return is_kept(file, row); });
    for (double& x : file[abscissa]) x += later;
    const Values at = file[abscissa], right = comparison::reference_result(problem, quantity, at),
                 wrong = comparison::wrong_result(problem, mistake, quantity, at).value();
    const bool is_relative = comparison::properties_of(quantity).norm == data::Norm::relative;
    for (std::size_t i = 0; i < at.size(); ++i)
      file.values()[i] =
          is_relative ? file.values()[i] * wrong[i] / right[i] : file.values()[i] + wrong[i] - right[i];
  };
  return {set, value, spoil, fmt::format("'{}'", mistake), margin};
}

// Rows that are cases, without the load of the base.
void without_load(File& file) {
  file.keep([](std::size_t row) { return row % 60 == 0; });
  for (std::size_t i = 0; i < file.values().size(); ++i) {
    const data::Case row =
        with_values(data::load_case("paper-figure14"),
                    {{"beam.length", file["length"][i]}, {"beam.axial_force", file["axial_force"][i]}});
    const Values hz{row.excitation().frequency_hz()};
    constexpr auto quantity = Quantity::critical_amplitude;
    file.values()[i] *= comparison::reference_result(row, quantity, hz)[0] /
                        comparison::wrong_result(row, "base-load-left-out", quantity, hz).value()[0];
  }
}

Mistakes all_wrong_models() {
  using enum Quantity;
  const data::Case paper = data::load_case("paper"), held = data::load_case("paper-figure9"),
                   steady = with_value(with(paper, shaking(25.0, 0.5e-3), kelvin_voigt(6.4e-5)),
                                       "numerics.elements", 24),
                   damped = with_value(with_the_settings_of_the_paper("damped"), "numerics.elements", 24),
                   undamped = with_value(undamped_case(), "numerics.elements", 24);
  const char *hz = "frequency", *force = "friction_force", *fields = "stick-fields", *v = "velocity",
             *vibration = "damped-steady-state", *middle = "midspan_amplitude", *events = "stick-slip-events",
             *time = "time", *history = "stick-slip-history", *tip = "tip_displacement",
             *u25 = "undamped-history-25";
  const IsKept in_the_middle = [](const File& file, std::size_t row) {
    return file.table.column("x")->values[row] == 1.0;
  };
  const IsKept twelve = [](const File&, std::size_t row) { return row < 12; };
  const Spoil with_all_modes = [paper, hz](File& file) {
    file.keep([](std::size_t row) { return row % 30 == 9; });
    file.values() = comparison::reference_result(paper, force_maximum, file[hz]);
  };
  const Spoil ratios_with_all_modes = [paper, hz](File& file) {
    file.keep([](std::size_t row) { return row % 20 == 9; });
    const Values critical = comparison::reference_result(paper, critical_amplitude, file[hz]);
    for (std::size_t i = 0; i < critical.size(); ++i) file.values()[i] = file["amplitude"][i] / critical[i];
  };
  return {
      wrong_model("stick-frequencies", hz, "lumped-mass", stick_frequency, paper, always),
      wrong_model("static-shapes", "shape", "tension", quasi_static_shape, paper, always),
      wrong_model("stick-history", force, "cosine-for-sine", stick_force, held, always),
      wrong_model(fields, v, "zero-initial-velocity", stick_velocity, held, in_the_middle),
      wrong_model(fields, v, "relative-displacement", stick_velocity, held, in_the_middle),
      wrong_model(vibration, middle, "structural-damping", steady_amplitude, steady, always, 300.0),
      wrong_model(vibration, middle, "relative-displacement", steady_amplitude, steady, always, 900.0),
      wrong_model(events, time, "mass-proportional-damping", contact_event, damped, twelve, 2.0),
      wrong_model(events, time, "kinetic-coefficient-as-limit", contact_event, damped, twelve, 300.0),
      wrong_model(events, time, "damping-left-out", contact_event, damped, twelve, 200.0),
      wrong_model(history, tip, "spectral-radius-zero", tip_displacement, damped, until(0.2), 1e3),
      wrong_model(history, tip, "start-from-rest", tip_displacement, damped, until(0.2), 1e3),
      // between the times of the data set
      wrong_model(history, tip, "regularised-friction", tip_displacement, damped, until(0.2), 10.0, 0.3e-4),
      wrong_model(u25, tip, "follower-term-sign", tip_displacement, undamped, until(0.12), 50.0),
      wrong_model(u25, tip, "four-elements", tip_displacement, undamped, until(0.12), 20.0),
      {u25, tip, times(0.0),
       "like 4 known mistakes that cannot be told apart here, the nearest 'second-moment-as-printed' (I is "
       "the printed value, 1/100 of the "
       "correct one (E1)) to 0.13 %, while the reference is 1e+02 % away; the data set stick-frequencies "
       "tells some of them apart\n",
       50.0},
      {"length-force", "force_ratio", without_load, "like 'base-load-left-out'"},
      {"classification", "force_ratio", ratios_with_all_modes, "like all modes: the data set has 10", 1e4},
      {"friction-maxima", force, with_all_modes,
       "like all modes: the data set has 10, and friction-maxima-all-modes has all", 1e4}};
}

// How much farther away the nearest is that is not named.
double margin_of(const Diagnosis& diagnosis) {
  double named = std::numeric_limits<double>::infinity(), other = named;
  for (const Hypothesis& one : diagnosis.ranked) {
    const bool is_named = std::ranges::count(diagnosis.named, one.name) > 0;
    double& least = is_named ? named : other;
    least = std::min(least, comparison::rank_of(one));
  }
  return other / named;
}

STICKSLIP_VERIFIES(DiagnosisOfFile, "X20");
TEST(DiagnosisOfFile, NamesEachKnownMistake) {
  for (const Mistakes& mistakes :
       {wrong_factors(), wrong_angles_and_constants(), wrong_data(), all_wrong_models()})
    for (const auto& [set, value, spoil, told, margin] : mistakes) {
      File file(set, value);
      spoil(file);
      bool is_run = false;
      const auto diagnoses = file.diagnosed({}, [&is_run](double) { is_run = true; });
      ASSERT_EQ(diagnoses.size(), 1u) << set << ": " << told;
      const Diagnosis& one = diagnoses[0];
      EXPECT_EQ(one.finding, Finding::mistaken) << one.sentence;
      EXPECT_TRUE(holds(one.sentence + "\n", told)) << set << ": " << told;
      EXPECT_TRUE(!told.ends_with('\n') || one.sentence + "\n" == told) << one.sentence;
      EXPECT_GE(margin_of(one), margin) << set << ": " << told;
      // No model is run where a relation says it all.
      const bool says_it_all = one.required_ratio == 0.0 && one.distance < 1e-9;
      EXPECT_FALSE(is_run && says_it_all) << told;
      EXPECT_TRUE(!says_it_all || one.named[0] == "all-modes" ||
                  std::ranges::count(one.ranked, "all-modes", &Hypothesis::name) == 0)
          << told;
    }
}

// --- what is no known mistake

TEST(DiagnosisOfFile, NamesNoUnknownMistake) {
  const auto told = [](OwnCopy file, const std::string& column, double even, double odd,
                       const comparison::Settings& settings = {}) -> std::string {
    for (std::size_t row = 0; row < file.table.rows(); ++row) file[column][row] += row % 2 == 0 ? even : odd;
    const auto diagnoses = file.diagnosed(settings);
    const bool is_named =
        diagnoses.size() != 1 || diagnoses[0].quantity != column || diagnoses[0].finding == Finding::mistaken;
    return is_named ? "more" : diagnoses[0].sentence;
  };
  EXPECT_TRUE(holds(told(own_copy("cubic-history"), "y", 1.0, -1.0), "no diagnosis: no factor"));
  EXPECT_TRUE(holds(told(own_copy("damped-history"), "friction_force", 30.0, -30.0), "wrong by"));
  EXPECT_TRUE(holds(told(own_copy("damped-history", {"t", "tip_displacement"}), "tip_displacement", 1e-7,
                         -1e-7, with_tolerance("", 1e-6)),
                    "is too small to be assigned to a mistake, up to 0.2 s"));
  EXPECT_TRUE(holds(told(published_copy("stick-slip-events"), "time", 2e-4, 5e-4), "wrong by"));
}

// The relations that are tried for the first group.
std::vector<Hypothesis> relations_of(const File& file, const std::string& value) {
  const comparison::Comparison compared = file.compared();
  const auto quantity = quantity_of(compared, value);
  const auto groups = comparison::groups_of(compared, quantity, file.reference().resource);
  return comparison::relations_of(
      {compared, published_package(), file.reference(), file.table, quantity, groups.at(0)});
}

TEST(DiagnosisOfFile, IsThatOfEveryColumn) {
  RandomNumbers draw(1);
  int columns = 0;
  for (const data::Resource& resource : published_package().resources) {
    if (!resource.comparison) continue;
    for (const auto& compared : resource.comparison->values) {
      if (compared.norm == data::Norm::word) continue;
      File file(resource.name, compared.field), twice = file;
      each([&](double value) { return value * (1.0 + 1e-14 * draw.uniform(-1.0, 1.0)); })(file);
      EXPECT_TRUE(file.diagnosed().empty()) << resource.name;
      times(2.0)(twice);
      const auto diagnoses = twice.diagnosed();
      // Twice a small energy may be within the tolerance, which belongs to the largest one.
      if (diagnoses.empty() || diagnoses[0].quantity != compared.field) continue;
      ++columns;
      EXPECT_TRUE(holds(diagnoses[0].sentence, resource.name == "mode-shapes" ? "MAC = 1" : "times 2: "))
          << resource.name << ", " << compared.field;
      if (resource.comparison->kind != data::ComparisonKind::table) continue;
      each([&](double value) { return value * (1.0 + 0.1 * draw.uniform(-1.0, 1.0)); })(file);
      EXPECT_EQ(comparison::nearest_of(relations_of(file, compared.field)), nullptr) << resource.name;
    }
  }
  EXPECT_GE(columns, 30);
}

TEST(DiagnosisOfFile, IsAnotherColumn) {
  auto mine = published_copy("stick-history");
  std::swap(mine["midspan_displacement"], mine["friction_force"]);
  const auto diagnoses = mine.diagnosed();
  ASSERT_EQ(diagnoses.size(), 2u);
  EXPECT_EQ(diagnoses[0].sentence, "the values are those of friction_force");
  EXPECT_EQ(diagnoses[1].sentence, "the values are those of midspan_displacement");
}

TEST(DiagnosisOfFile, IsOfSingleValuesToATwentieth) {
  const auto is_single = [](std::size_t rows, std::size_t wrong) {
    File file("friction-maxima", "friction_force");
    file.keep_first(rows);
    for (std::size_t i = 0; i < wrong; ++i) file.values()[i] *= 1.1 + 0.1 * static_cast<double>(i % 3);
    const auto relations = relations_of(file, "friction_force");
    const Hypothesis* nearest = comparison::nearest_of(relations);
    return nearest != nullptr && nearest->name == "single-values";
  };
  EXPECT_TRUE(is_single(120, 6) && is_single(4, 1));
  EXPECT_FALSE(is_single(120, 7) || is_single(3, 1));
}

// --- the rule

// Values 1 to 6, a hypothesis that is `whole` from them, and a result that is `near` from that, each relative.
Hypothesis judged(comparison::Kind kind, double whole, double near, int free = 0, std::size_t known = 6,
                  double allowed = 1e-9) {
  comparison::Comparison::Series series;
  Hypothesis one{.name = "made up", .kind = kind, .free = free};
  const double scale = kind == comparison::Kind::factor ? 1.0 + whole : 1.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double right = static_cast<double>(i + 1);
    series.reference.push_back(right);
    one.values.push_back(i < known ? right * (1.0 + whole) : std::nan(""));
    series.theirs.push_back(right * (1.0 + whole + (i % 2 == 0 ? near : -near) * scale));
    series.allowed.push_back(allowed * right);
  }
  return comparison::judged(data::Norm::relative, series, one, 30.0);
}

STICKSLIP_VERIFIES(Acceptance, "X20");
TEST(Acceptance, AsksForTheRatioOfItsKind) {
  using enum comparison::Kind;
  // Six numbers and 30 hypotheses ask for (30/(0.01 ln 10))^(1/6) = 3.30. No distance counts as more than 1.
  for (const auto& [kind, whole, most] : {std::tuple{factor, 1.0, 0.01},
                                          {factor, 1e3, 0.01},
                                          {relation, 0.1, 0.01},
                                          {relation, 1e3, 0.1},
                                          {zeros, -1.0, 1e-4},
                                          {all_modes, 0.1, 0.0317},
                                          {wrong_model, 0.1, 0.0317},
                                          {wrong_model, 1.0, 0.2}}) {
    EXPECT_TRUE(judged(kind, whole, 0.98 * most).is_accepted) << most;
    EXPECT_FALSE(judged(kind, whole, 1.03 * most).is_accepted) << most;
  }
}

TEST(Acceptance, AsksMoreOfFewNumbers) {
  const auto ratio = [](double dimension, int free) {
    return comparison::required_ratio(comparison::Kind::relation, 30.0, dimension, free);
  };
  EXPECT_TRUE(within(ratio(1, 0), 30.0 / (0.01 * std::numbers::ln10), round_off(4, 1, 1303)));
  EXPECT_TRUE(within(ratio(3, 1), std::sqrt(30.0 / 0.01), round_off(4, 1, 55)));
  EXPECT_EQ(ratio(1000, 1), 10.0);
  EXPECT_TRUE(within(ratio(1000, 4), std::sqrt(30.0 / 0.01), round_off(4, 1, 55)));
  EXPECT_TRUE(std::isinf(ratio(2, 2)));
}

TEST(Acceptance, NeedsHalfTheValuesAndADifference) {
  constexpr auto relation = comparison::Kind::relation;
  EXPECT_TRUE(judged(relation, 0.1, 0.0, 0, 3).is_accepted);
  EXPECT_FALSE(judged(relation, 0.1, 0.0, 0, 2).is_accepted);
  EXPECT_TRUE(judged(relation, 0.1, 0.0, 0, 6, 0.09).is_accepted);
  EXPECT_FALSE(judged(relation, 0.1, 0.0, 0, 6, 0.11).is_accepted);
}

TEST(Acceptance, PrefersWhatWasNotFitted) {
  const auto fitted_numbers = [](double usual, double fitted) {
    constexpr auto relation = comparison::Kind::relation;
    const std::vector<Hypothesis> both{judged(relation, 0.5, usual), judged(relation, 0.5, fitted, 1)};
    return comparison::nearest_of(both)->free;
  };
  EXPECT_EQ(fitted_numbers(1e-3, 1.1e-4), 0);
  EXPECT_EQ(fitted_numbers(1e-3, 0.9e-4), 1);
  EXPECT_EQ(fitted_numbers(1e-13, 0.0), 0);
  EXPECT_EQ(comparison::nearest_of({judged(comparison::Kind::relation, 0.5, 0.4)}), nullptr);
}

}  // namespace
}  // namespace stickslip::testing
