// SPDX-License-Identifier: MIT
#include "stickslip/data/case_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <numbers>
#include <set>
#include <system_error>
#include <utility>

#include "case_entry.hpp"
#include "case_model.hpp"
#include "case_motion.hpp"
#include "stickslip/data/toml_file.hpp"

namespace stickslip::data {

namespace {

// The mistakes of an input that is read to its end in spite of them.
class Mistakes {
 public:
  // Does the work, and keeps the message of an InputError; a FieldError is told with what `place` says of its field.
  void collect(const std::function<void()>& work,
               const std::function<std::string(const FieldError&)>& place = {}) {
    if (are_many()) {
      ++unread_;
      return;
    }
    try {
      work();
    } catch (const FieldError& error) {
      sentences_.push_back((place ? place(error) + ": " : "") + error.what());
    } catch (const InputError& error) {
      sentences_.emplace_back(error.what());
    }
  }

  [[nodiscard]] bool any() const noexcept { return !sentences_.empty(); }
  [[nodiscard]] bool are_many() const noexcept { return sentences_.size() >= limit::mistakes.most; }

  // Throws InputError for one mistake, InputErrors for more.
  void throw_if_any() const {
    if (sentences_.empty()) return;
    if (sentences_.size() == 1) throw InputError(sentences_.front());
    std::string lines;
    for (const std::string& sentence : sentences_) lines += (lines.empty() ? "" : "\n") + sentence;
    if (unread_ > 0)
      lines += "\nafter so many mistakes " + std::to_string(unread_) + " more entries are not read";
    throw InputErrors(lines);
  }

 private:
  std::vector<std::string> sentences_;
  std::size_t unread_{};
};

std::vector<std::string> key_paths() {
  std::vector<std::string> paths;
  for (const Key& key : case_keys()) paths.emplace_back(key.path);
  return paths;
}

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const std::string& path : key_paths())
    if (std::string table = path.substr(0, path.find('.')); std::ranges::find(names, table) == names.end())
      names.push_back(std::move(table));
  names.emplace_back("uncertainty");
  return names;
}

std::vector<std::string> key_names(const std::string& table) {
  std::vector<std::string> names;
  for (const std::string& path : key_paths())
    if (path.starts_with(table + ".")) names.push_back(path.substr(table.size() + 1));
  return names;
}

[[noreturn]] void throw_unknown_table(const std::string& place, std::string_view name) {
  throw InputError(place + ": unknown table [" + printable(name) + "]" + suggestion(name, table_names()) +
                   ", but a case has the tables " + joined(table_names()));
}

[[noreturn]] void throw_unknown_key(const std::string& place, const std::string& path,
                                    const std::string& value) {
  const std::string table = path.substr(0, path.find('.'));
  const auto names = key_names(table);
  const std::string allowed = names.empty() ? "a case has the tables " + joined(table_names())
                                            : "[" + table + "] has the keys " + joined(names);
  throw InputError(place + ": unknown key " + printable(path) + suggestion(path, key_paths()) +
                   " with the value " + value + ", but " + allowed);
}

void require_known_key(const std::string& path, const Entry& entry) {
  const auto known = key_paths();
  if (std::ranges::find(known, path) == known.end()) throw_unknown_key(entry.place, path, entry.description);
}

// The key that the entry is one of where it stands at `path`.
std::string stated_by(const std::string& path, const Entry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  return text == nullptr ? path : std::string(key_stated(path, *text).path);
}

void collect_table(const std::filesystem::path& file, const std::string& name, const toml::table& table,
                   Entries& entries, Mistakes& mistakes) {
  for (const auto& [key, value] : table)
    mistakes.collect([&, &key = key, &value = value] {
      const std::string path = name + "." + std::string(key.str());
      const Entry entry = entry_of(value, place_of(file, value));
      require_known_key(path, entry);
      const std::string stated = stated_by(path, entry);
      if (!entries.emplace(stated, entry).second)
        throw InputError(entry.place + ": " + path + " is " + entry.description +
                         ", but must be missing where " + stated + " is given");
    });
}

Uncertainty uncertainty_in(const std::filesystem::path& file, const toml::table& document) {
  const auto* node = document.get("uncertainty");
  return node == nullptr ? Uncertainty() : uncertainty_of(file, *node);
}

// The means of the uncertain keys.
Entries means_in(const std::filesystem::path& file, const toml::table& document) {
  Entries means;
  for (const auto& [key, distribution, place] : uncertainty_in(file, document).keys)
    means.emplace(key,
                  Entry{distribution.mean_value(), shortest_text(distribution.mean_value()), place, true});
  return means;
}

Entries entries_of(const std::filesystem::path& file, const toml::table& document, Mistakes& mistakes) {
  Entries entries;
  const auto tables = table_names();
  const auto take = [&](const std::string& name, const toml::node& value) {
    const std::string place = place_of(file, value);
    const bool is_known = std::ranges::find(tables, name) != tables.end();
    if (const auto* table = value.as_table()) {
      if (!is_known) throw_unknown_table(place, name);
      collect_table(file, name, *table, entries, mistakes);
    } else if (is_known) {
      throw InputError(place + ": " + name + " is " + describe(value) + ", but must be a table");
    } else {
      throw_unknown_key(place, name, describe(value));
    }
  };
  for (const auto& [key, value] : document)
    if (key.str() != "uncertainty")
      mistakes.collect([&, &key = key, &value = value] { take(std::string(key.str()), value); });
  return entries;
}

void apply(const Override& replacement, Entries& entries) {
  const std::string place = replacement.place.empty()
                                ? "override " + printable(replacement.key + "=" + replacement.value)
                                : replacement.place;
  Entry entry = entry_of(replacement.value, place);
  require_known_key(replacement.key, entry);
  const std::string stated = stated_by(replacement.key, entry);
  erase_alternatives(stated, entries);
  entries.insert_or_assign(stated, std::move(entry));
}

// How a missing key could have been given otherwise.
std::string alternative_to(const Key& key) {
  if (key.name() == "area" || key.name() == "second_moment_of_area") return " or the table [section]";
  if (key.name() == "density" || key.name() == "youngs_modulus") return " or beam.material";
  if (key.path == "excitation.amplitude")
    return " or excitation.velocity_amplitude or excitation.acceleration_amplitude";
  if (key.path == "excitation.frequency_hz")
    return " or one of excitation.sines, sweep, shock, file and spectrum";
  if (key.path == "beam.length") return " or the table [model] in place of [beam]";
  if (key.path == "model.mass") return " or model.mass_matrix";
  return "";
}

// Reads the numbers of a case, going on after a mistake with a number that is allowed.
class NumbersReader {
 public:
  NumbersReader(std::filesystem::path file, Entries entries, Mistakes& mistakes, bool reads_files)
      : file_(std::move(file)), entries_(std::move(entries)), mistakes_(mistakes), reads_files_(reads_files) {
    misses_keys_ = !mistakes_.any();  // else what is missing may have been meant
    collect([&] {
      try {
        expand_shorthand(entries_);
      } catch (const FieldError&) {
        throw;
      } catch (const InputError&) {
        if (misses_keys_) throw;
      }
    });
    misses_keys_ = misses_keys_ && !mistakes_.any();
    kind_ = kind();
    is_general_ = states_general_motion("excitation", entries_);
  }

  // The settings last, as their defaults follow from the rest.
  [[nodiscard]] Case read() {
    numbers_.numerics.duration = default_duration;
    if (kind_ == StructureKind::mass)
      numbers_.model = {.mass = 1.0, .stiffness = 0.0, .damping = 0.0, .normal_force = 1.0};
    for (const auto& [path, entry] : entries_)
      collect([&, &path = path, &entry = entry] {
        const Key& key = key_named(path);
        if (!key.is_of(kind_))
          throw InputError(entry.place + ": " +
                           FieldError(path, entry.description, key.reason_against(kind_)).what());
      });
    if (kind_ == StructureKind::matrices) read_matrices();
    fill(false);
    read_motions();
    if (const auto found = entries_.find("damping.ratios"); found != entries_.end())
      collect([&] {
        numbers_.damping.ratios =
            numbers_of(found->first, key_named("damping.ratio").magnitudes, found->second);
      });
    while (collect([&] {
      (void)structure_of(numbers_), (void)FrictionLaw(numbers_.friction);
      if (!is_general_)
        require_magnitude(amplitude_keys.front(), key_named(amplitude_keys.front()).magnitudes,
                          HarmonicExcitation(numbers_.excitation).amplitude());
      (void)Damping(numbers_.damping), (void)TangentialContact(numbers_.contact), (void)Wall(numbers_.wall);
    })) {
    }
    if (!mistakes_.any())
      collect([&] {
        numbers_.numerics = default_numerics(structure_of(numbers_),
                                             highest_frequency_hz(motion_of(numbers_), numbers_.wall_motion),
                                             numbers_.numerics.duration, Damping(numbers_.damping));
      });
    fill(true);
    mistakes_.throw_if_any();
    std::optional<Case> problem;
    collect([&] { problem = case_of(file_.stem().string(), numbers_); });
    mistakes_.throw_if_any();
    for (const Key& key : case_keys())
      if (key.table() == "numerics" && key.is_of(kind_) && key.member.get != nullptr &&
          !entries_.contains(std::string(key.path)))
        problem->default_numerics.emplace(key.path);
    return *problem;
  }

 private:
  [[nodiscard]] bool has_key(const std::function<bool(const Key&)>& condition) const {
    return std::ranges::any_of(entries_, [&](const auto& entry) {
      return !entry.second.is_mean && condition(key_named(entry.first));
    });
  }

  // A normal force beside a beam is a mistake for its axial force.
  [[nodiscard]] StructureKind kind() const {
    if (has_key(is_of_matrices)) return StructureKind::matrices;
    const bool is_beam = has_key([](const Key& key) { return key.table() == "beam"; });
    const auto is_of_model = [is_beam](const Key& key) {
      return key.table() == "model" && !(is_beam && key.path == "model.normal_force");
    };
    return has_key(is_of_model) ? StructureKind::mass : StructureKind::beam;
  }

  void read_matrices() {
    numbers_.model.normal_force = 1.0;
    numbers_.matrices = std::make_shared<const StructureMatrices>();
    collect([&] { numbers_.matrices = matrices_of(file_, entries_, reads_files_); });
  }

  // A record lasts as long as it is, unless the duration is stated.
  void read_motions() {
    const auto read = [&](std::string_view table, std::optional<GeneralMotion>& motion) {
      collect([&] {
        motion = general_motion_of(table, file_, entries_, numbers_.numerics.duration, reads_files_);
      });
    };
    read("excitation", numbers_.motion);
    read("wall", numbers_.wall_motion);
    if (is_general_)
      numbers_.excitation = {.frequency_hz = NAN, .amplitude = NAN, .scale = numbers_.excitation.scale};
    const auto record_of = [](const std::optional<GeneralMotion>& motion) {
      return motion ? std::get_if<MotionRecord>(&motion->statement()) : nullptr;
    };
    const auto *base = record_of(numbers_.motion), *wall = record_of(numbers_.wall_motion);
    if (base != nullptr && wall != nullptr && base->begin != wall->begin)
      collect([&] {
        throw FieldError(
            "wall.file", wall->file + " from " + shortest_text(wall->begin) + " s on",
            "on the clock of excitation.file, which is from " + shortest_text(base->begin) + " s on");
      });
    if (entries_.contains("excitation.duration") || (base == nullptr && wall == nullptr)) return;
    const double endless = std::numeric_limits<double>::infinity();
    numbers_.numerics.duration = std::min(base != nullptr ? numbers_.motion->duration() : endless,
                                          wall != nullptr ? numbers_.wall_motion->duration() : endless);
  }

  static double allowed(const Key& key) {
    if (const double usual = key.presence == Presence::optional ? key.member.get(CaseNumbers()) : NAN;
        !std::isnan(usual))
      return usual;
    if (key.presence == Presence::optional) return 0.0;
    return key.axis.may_be_zero ? 0.0 : 1.0;
  }

  // Whether there was a mistake in a number that then has another value.
  bool collect(const std::function<void()>& work) {
    bool is_mended = false;
    mistakes_.collect(work, [&](const FieldError& error) {
      const auto key = std::ranges::find(case_keys(), error.field(), &Key::path);
      is_mended =
          mended_.insert(error.field()).second && key != case_keys().end() && key->member.set != nullptr;
      if (is_mended) key->member.set(numbers_, allowed(*key));
      if (error.field() == "friction.static_coefficient")
        numbers_.friction.kinetic_coefficient = 0.0;  // its bound
      const auto given = std::ranges::find_if(
          entries_, [&](const auto& entry) { return state_the_same(entry.first, error.field()); });
      return given == entries_.end() ? file_.string() : given->second.place;
    });
    return is_mended;
  }

  void fill(bool numerics) {
    const bool states_amplitude = std::ranges::any_of(
        amplitude_keys, [&](std::string_view key) { return entries_.contains(std::string(key)); });
    for (const Key& key : case_keys()) {
      if (key.presence == Presence::shorthand || !key.is_of(kind_) || (key.table() == "numerics") != numerics)
        continue;
      const std::string path(key.path);
      const auto found = entries_.find(path);
      if (mended_.contains(path)) continue;
      if (found != entries_.end())
        collect([&] {
          key.member.set(numbers_, key.member.is_flag      ? flag_of(path, found->second)
                                   : key.member.is_integer ? integer_of(path, found->second)
                                                           : number_of(path, key.magnitudes, found->second));
        });
      else if (is_general_ && (path == "excitation.frequency_hz" || path == amplitude_keys.front()))
        continue;
      else if (key.presence == Presence::required || (path == amplitude_keys.front() && !states_amplitude)) {
        key.member.set(numbers_, allowed(key));
        if (misses_keys_)
          collect([&] {
            throw InputError(file_.string() + ": " + path + " is missing, but a case must hold it" +
                             alternative_to(key) +
                             (key.presence == Presence::alternative && kind_ != StructureKind::beam
                                  ? " or excitation.force"
                                  : ""));
          });
      }
    }
  }

  std::filesystem::path file_;
  Entries entries_;
  Mistakes& mistakes_;
  CaseNumbers numbers_;
  std::set<std::string> mended_;
  bool misses_keys_{}, reads_files_{}, is_general_{};
  StructureKind kind_{};
};

// What the document says, and instead of it the overrides. What is missing has the mean of its distribution, unless a
// shorthand stands for it.
Case case_of(const std::filesystem::path& file, const toml::table& document,
             const std::vector<Override>& overrides, bool reads_files = true) {
  Mistakes mistakes;
  Entries entries = entries_of(file, document, mistakes);
  for (const auto& replacement : overrides) mistakes.collect([&] { apply(replacement, entries); });
  if (mistakes.are_many()) mistakes.throw_if_any();
  mistakes.collect([&] {
    Entries means = means_in(file, document);
    entries.merge(means);
  });
  return NumbersReader(file, std::move(entries), mistakes, reads_files).read();
}

std::filesystem::path cases_directory() { return data_directory() / "cases"; }

std::filesystem::path published_case(const std::string& name) { return cases_directory() / (name + ".toml"); }

// The text of the first comment line, without the '#'.
std::string title_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) continue;
    const auto begin = line.find_first_not_of("# \t");
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
}

constexpr int fewest_modes = 10, most_modes = 200;

// The largest of 1, 2 and 5 times a power of ten that is not above the value, as the double nearest to it.
double rounded_down(double value) {
  int exponent = static_cast<int>(std::floor(std::log10(value)));
  const auto multiple = [&exponent](double factor) {
    const double power = std::pow(10.0, std::abs(exponent));  // exact up to 1e22
    return exponent < 0 ? factor / power : factor * power;
  };
  if (multiple(1.0) > value) --exponent;  // just below a power of ten log10 is rounded up
  for (const double factor : {5.0, 2.0})
    if (multiple(factor) <= value) return multiple(factor);
  return multiple(1.0);
}

}  // namespace

void throw_overflow(std::string_view result) {
  throw InputError(std::string(result) +
                   ": quantities of this case are too large or too small for each other");
}

Override Override::parse(std::string_view text) {
  const auto equals = text.find('=');
  const std::string_view key = trimmed(text.substr(0, equals));
  const std::string_view value =
      equals == std::string_view::npos ? std::string_view{} : trimmed(text.substr(equals + 1));
  if (key.empty() || value.empty())
    throw FieldError("override", printable(text), "table.key=value, as in beam.length=1.8");
  return {std::string(key), std::string(value), ""};
}

std::filesystem::path data_directory() {
  return installed_folder("STICKSLIP_DATA", "data", STICKSLIP_DATA_DIRECTORY);
}

std::filesystem::path find_case(const std::string& name_or_path) {
  const bool is_name = name_or_path.find('/') == std::string::npos;
  if (is_name && is_file(published_case(name_or_path))) return published_case(name_or_path);
  if (is_file(name_or_path)) return name_or_path;
  std::vector<std::string> names;
  for (const auto& [name, title] : list_cases()) names.push_back(name);
  throw InputError("case " + (name_or_path.empty() ? "\"\"" : printable(name_or_path)) + " is unknown" +
                   (is_file(name_or_path + ".toml") ? " (did you mean " + printable(name_or_path) + ".toml?)"
                                                    : suggestion(name_or_path, names)) +
                   ", but must be a file or one of " + joined(names));
}

void require_magnitude(std::string_view key, double value, const std::string& place) {
  try {
    require_magnitude(key, key_named(key).magnitudes, value);
  } catch (const FieldError& error) {
    throw InputError(place + ": " + error.what());
  }
}

Uncertainty read_uncertainty(const std::filesystem::path& file) {
  return uncertainty_in(file, read_toml(file));
}

Case read_case(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  return case_of(file, read_toml(file), overrides);
}

Case parse_case(const std::filesystem::path& file, const std::string& text) {
  return case_of(file, parse_toml(file, text), {}, false);
}

Case load_case(const std::string& name_or_path, const std::vector<Override>& overrides) {
  return read_case(find_case(name_or_path), overrides);
}

std::vector<Material> list_materials() {
  return read_all(data_directory() / "materials.toml", "material",
                  {"name", "density", "youngs_modulus", "source"}, [](const Record& record) {
                    return Material{.name = record.text("name"),
                                    .density = record.number("density"),
                                    .youngs_modulus = record.number("youngs_modulus"),
                                    .source = record.text("source")};
                  });
}

std::map<std::string, std::string> list_cases() {
  std::error_code error;
  std::map<std::string, std::string> cases;
  for (const auto& file : std::filesystem::directory_iterator(cases_directory(), error))
    if (file.path().extension() == ".toml") cases[file.path().stem().string()] = title_of(file.path());
  if (error)
    throw InputError(cases_directory().string() + ": cannot be listed (" + error.message() +
                     "); STICKSLIP_DATA must name the folder that holds cases/");
  return cases;
}

namespace fs = std::filesystem;

fs::path installed_folder(const char* variable, std::string_view folder, std::string_view source) {
  if (const char* chosen = std::getenv(variable); chosen != nullptr && *chosen != '\0') return chosen;
  std::error_code
      error;  // without /proc a program does not know its place, and what is not there is not installed
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = (program.parent_path() / STICKSLIP_SHARED_FILES / folder).lexically_normal();
  return fs::is_directory(installed, error) ? installed : fs::path(source);
}

namespace {

NumericalChoices beam_numerics(const Beam& beam, double highest_hz, double duration, const Damping& damping) {
  constexpr double pi = std::numbers::pi;
  const double bending_stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double mass = beam.density() * beam.area();
  const double unit =
      std::sqrt(bending_stiffness / mass) / (beam.length() * beam.length()) / (2.0 * pi);  // Hz
  const double resolved = 4.0 * highest_hz;
  const double above = std::ceil(std::sqrt(resolved / unit) / pi - 0.25);
  const int k = static_cast<int>(std::clamp(above, double{fewest_modes}, double{most_modes}));
  const double wave_number = (k + 0.25) * pi;
  const double step = 1.0 / (50.0 * (wave_number * wave_number * unit));
  return {.elements = 4 * k,
          .time_step = rounded_down(duration > 0.0 ? std::min(duration, step) : step),
          .spectral_radius = damping.kelvin_voigt() > 0.0 ? 0.0 : 0.9,
          .velocity_threshold = 0.0,
          .modes = k,
          .duration = duration};
}

NumericalChoices model_numerics(const Model& model, double highest_hz, double duration) {
  double highest = highest_hz;
  if (model.is_mass())
    highest = std::max(highest, std::sqrt(model.properties().stiffness / model.properties().mass) /
                                    (2.0 * std::numbers::pi));
  const double step = 1.0 / (2000.0 * highest);
  return {.elements = 1,
          .time_step = rounded_down(duration > 0.0 ? std::min(duration, step) : step),
          .spectral_radius = 0.9,
          .velocity_threshold = 0.0,
          .modes = 20,
          .duration = duration};
}

}  // namespace

NumericalChoices default_numerics(const Structure& structure, double highest_hz, double duration,
                                  const Damping& damping) {
  constexpr double most_steps = 5e8;  // of a billion
  const auto* model = std::get_if<Model>(&structure);
  NumericalChoices choices = model != nullptr
                                 ? model_numerics(*model, highest_hz, duration)
                                 : beam_numerics(std::get<Beam>(structure), highest_hz, duration, damping);
  if (std::isfinite(duration))  // else refused by its name
    choices.time_step = std::max(choices.time_step, duration / most_steps);
  return choices;
}

}  // namespace stickslip::data
