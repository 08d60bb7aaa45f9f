// SPDX-License-Identifier: MIT
#include "case_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "motion_shape.hpp"
#include "record_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::data {

namespace {

constexpr std::array<std::string_view, 5> statements{"sines", "sweep", "shock", "file", "spectrum"};

// Keys that are for a record, a spectrum or both.
struct DetailKey {
  std::string_view name;
  bool of_record{}, of_spectrum{};
};
constexpr std::array details{DetailKey{"column", true, true},
                             DetailKey{"quantity", true, false},
                             DetailKey{"unit", true, true},
                             DetailKey{"rate", true, false},
                             DetailKey{"high_pass", true, false},
                             DetailKey{"initial_displacement", true, false},
                             DetailKey{"initial_velocity", true, false},
                             DetailKey{"seed", false, true}};

// Reads the keys of one table.
class MotionReader {
 public:
  MotionReader(std::string_view table, const std::filesystem::path& case_file, const Entries& entries,
               double duration, bool reads_files)
      : table_(table),
        case_file_(case_file),
        entries_(entries),
        duration_(duration),
        reads_files_(reads_files) {}

  [[nodiscard]] std::optional<GeneralMotion> read() const {
    require_one();
    if (const Entry* sines = find("sines")) return made(sines_in(*sines));
    if (const Entry* sweep = find("sweep")) return made(sweep_in(*sweep));
    if (const Entry* shock = find("shock")) return made(shock_in(*shock));
    if (const Entry* file = find("file")) return made(record_in(*file));
    if (const Entry* spectrum = find("spectrum")) return made(spectrum_in(*spectrum));
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::string key(std::string_view name) const { return key_in(table_, name); }

  [[nodiscard]] const Entry* find(std::string_view name) const {
    const auto found = entries_.find(key(name));
    return found == entries_.end() || found->second.is_mean ? nullptr : &found->second;
  }

  [[nodiscard]] GeneralMotion made(GeneralMotion::Statement statement) const {
    return GeneralMotion(std::move(statement), duration_, table_);
  }

  [[noreturn]] void refuse(std::string_view name, const std::string& allowed) const {
    throw FieldError(key(name), find(name)->description, allowed);
  }

  void require_one() const {
    std::string_view first;
    for (const std::string_view name : {"frequency_hz", "sines", "sweep", "shock", "file", "spectrum"}) {
      if (find(name) == nullptr) continue;
      if (!first.empty()) refuse(name, "left out where " + key(first) + " is given");
      first = name;
    }
    for (const auto& [name, of_record, of_spectrum] : details)
      if (find(name) != nullptr && !(of_record && first == "file") && !(of_spectrum && first == "spectrum"))
        refuse(name, "left out without " + (of_record ? key("file") : key("spectrum")));
    const bool takes_amplitude =
        first == "sweep" || first == "shock" || (table_ == "excitation" && first.empty());
    for (const std::string_view path : amplitude_keys)
      if (const auto name = key_named(path).name();
          find(name) != nullptr && !takes_amplitude && first != "frequency_hz")
        refuse(name, first.empty() ? "left out without " + key("sweep") + " or " + key("shock")
                                   : "left out where " + key(first) + " is given");
  }

  // That of a sweep or a shock.
  [[nodiscard]] std::pair<double, AmplitudeOf> amplitude(std::string_view of) const {
    std::optional<std::pair<double, AmplitudeOf>> found;
    for (std::size_t kind = 0; kind < amplitude_keys.size(); ++kind) {
      const Key& one = key_named(amplitude_keys.at(kind));
      const Entry* entry = find(one.name());
      if (entry == nullptr) continue;
      if (found) refuse(one.name(), "the only amplitude of [" + table_ + "]");
      found = {number_of(key(one.name()), one.magnitudes, *entry), static_cast<AmplitudeOf>(kind)};
    }
    if (!found)
      throw FieldError(key("amplitude"), "missing",
                       "given where " + key(of) + " is, or one of velocity or acceleration");
    return *found;
  }

  [[nodiscard]] std::vector<Sine> sines_in(const Entry& entry) const {
    const std::string allowed =
        "a list of [frequency, amplitude, phase], as [[20, \"0.1 mm\"], [35, \"0.5 g\", 90]]";
    const auto* list = std::get_if<toml::array>(&entry.value);
    if (list == nullptr) refuse("sines", allowed);
    std::vector<Sine> sines;
    for (const toml::node& node : *list) {
      const auto* one = node.as_array();
      if (one == nullptr || one->size() < 2 || one->size() > 3) refuse("sines", allowed);
      const auto part = [&](std::size_t i) { return entry_of(*one->get(i), entry.place); };
      Sine sine{.frequency_hz =
                    number_of(key("sines"), key_named("excitation.frequency_hz").magnitudes, part(0))};
      const Entry amplitude = part(1);
      const auto* text = std::get_if<std::string>(&amplitude.value);
      const Key& stated = key_stated(amplitude_keys.front(), text == nullptr ? "" : *text);
      sine.amplitude = number_of(key("sines"), stated.magnitudes, amplitude);
      sine.amplitude_of = static_cast<AmplitudeOf>(
          std::distance(amplitude_keys.begin(), std::ranges::find(amplitude_keys, stated.path)));
      if (one->size() == 3) {
        const Entry phase = part(2);
        const double degree =
            std::holds_alternative<std::string>(phase.value) ? 1.0 : std::numbers::pi / 180.0;
        sine.phase = degree * number_of(key("sines"), {.unit = "rad"}, phase);
      }
      sines.push_back(sine);
    }
    return sines;
  }

  // The members of a table, which must be these.
  [[nodiscard]] std::vector<Entry> members(std::string_view name, const Entry& entry,
                                           const std::vector<std::string>& names,
                                           const std::string& allowed) const {
    const auto* table = std::get_if<toml::table>(&entry.value);
    std::vector<Entry> found;
    for (const std::string& member : names) {
      const auto* node = table == nullptr ? nullptr : table->get(member);
      if (node == nullptr || table->size() != names.size())
        throw FieldError(key(name), table == nullptr ? entry.description : "a table of other keys", allowed);
      found.push_back(entry_of(*node, entry.place));
    }
    return found;
  }

  [[nodiscard]] Sweep sweep_in(const Entry& entry) const {
    const std::string allowed =
        "{ from = \"5 Hz\", to = \"200 Hz\", rate = \"1 oct/min\" }, or a rate in Hz/s, Hz/min or oct/s";
    const auto found = members("sweep", entry, {"from", "to", "rate"}, allowed);
    const auto& hertz = key_named("excitation.frequency_hz").magnitudes;
    Sweep sweep{.from_hz = number_of(key("sweep"), hertz, found[0]),
                .to_hz = number_of(key("sweep"), hertz, found[1])};
    const auto* text = std::get_if<std::string>(&found[2].value);
    const auto octaves = quantity_in(text == nullptr ? "" : *text, "oct/s", false),
               hertz_a_second = quantity_in(text == nullptr ? "" : *text, "Hz/s", false);
    if (!octaves && !hertz_a_second)
      throw FieldError(key("sweep"), "of rate " + found[2].description, allowed);
    sweep.is_logarithmic = octaves.has_value();
    sweep.rate = octaves ? *octaves : *hertz_a_second;
    std::tie(sweep.amplitude, sweep.amplitude_of) = amplitude("sweep");
    return sweep;
  }

  [[nodiscard]] Shock shock_in(const Entry& entry) const {
    const auto found =
        members("shock", entry, {"shape", "duration"}, "{ shape = \"half-sine\", duration = \"11 ms\" }");
    const std::vector<std::string> shapes{"half-sine", "sawtooth", "trapezoid", "rectangle"};
    const auto shape = std::ranges::find(shapes, name_of(key("shock"), found[0], shapes));
    Shock shock{.shape = static_cast<ShockShape>(std::distance(shapes.begin(), shape)),
                .duration = number_of(key("shock"), {1e-9, 1e9, "s"}, found[1])};
    std::tie(shock.amplitude, shock.amplitude_of) = amplitude("shock");
    return shock;
  }

  [[nodiscard]] std::string text_of(std::string_view name, const Entry& entry) const {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (text == nullptr || text->empty()) throw FieldError(key(name), entry.description, "a text");
    return *text;
  }

  [[nodiscard]] std::optional<double> number(std::string_view name) const {
    const Entry* entry = find(name);
    if (entry == nullptr) return std::nullopt;
    return number_of(key(name), key_named(key(name)).magnitudes, *entry);
  }

  [[nodiscard]] MotionRecord record_in(const Entry& entry) const {
    const std::string name = text_of("file", entry);
    if (!is_inside(name)) refuse("file", "a file in the folder of the case or below, without \"..\"");
    for (const char* needed : {"column", "quantity"})
      if (find(needed) == nullptr)
        throw FieldError(key(needed), "missing", "given where " + key("file") + " is");
    const std::vector<std::string> quantities{"displacement", "velocity", "acceleration", "force"};
    const auto quantity =
        std::ranges::find(quantities, name_of(key("quantity"), *find("quantity"), quantities));
    RecordKeys keys{.table = table_,
                    .column = text_of("column", *find("column")),
                    .quantity = static_cast<AmplitudeOf>(std::distance(quantities.begin(), quantity)),
                    .unit = std::nullopt,
                    .rate_hz = number("rate")};
    if (keys.rate_hz && !(*keys.rate_hz > 0.0)) throw FieldError(key("rate"), *keys.rate_hz, "above 0 (Hz)");
    if (const Entry* unit = find("unit")) keys.unit = text_of("unit", *unit);
    MotionRecord record;
    if (!reads_files_) {
      record.quantity = keys.quantity == AmplitudeOf::force ? AmplitudeOf::force : AmplitudeOf::displacement;
      record.step = duration_;
      record.samples.resize(8);
      return record;
    }
    record = read_record(case_file_.parent_path() / name, keys);
    record.file = name;
    record.high_pass_hz = number("high_pass");
    record.initial_displacement = number("initial_displacement");
    record.initial_velocity = number("initial_velocity");
    return record;
  }

  // The points of a list, [[5, 0.01], [20, 0.02]], or of a file.
  [[nodiscard]] PowerSpectrum spectrum_in(const Entry& entry) const {
    if (find("unit") == nullptr)
      throw FieldError(key("unit"), "missing", "given where " + key("spectrum") + " is, as \"g^2/Hz\"");
    PowerSpectrum spectrum = read_spectrum_unit(table_, text_of("unit", *find("unit")));
    if (const Entry* seed = find("seed")) {
      const int stated = integer_of(key("seed"), *seed);
      if (stated < 0) refuse("seed", "an integer of 0 or more");
      spectrum.seed = static_cast<std::uint64_t>(stated);
    }
    if (const auto* list = std::get_if<toml::array>(&entry.value)) {
      if (find("column") != nullptr) refuse("column", "left out where " + key("spectrum") + " is a list");
      for (const toml::node& node : *list) {
        const auto point = numbers_of(key("spectrum"), {}, entry_of(node, entry.place));
        if (point.size() != 2) refuse("spectrum", spectrum_allowed);
        spectrum.points.push_back({point[0], point[1] * spectrum.to_si});
      }
      return spectrum;
    }
    if (!std::holds_alternative<std::string>(entry.value)) refuse("spectrum", spectrum_allowed);
    const std::string name = text_of("spectrum", entry);
    if (!is_inside(name)) refuse("spectrum", "a file in the folder of the case or below, without \"..\"");
    spectrum.file = name;
    std::optional<std::string> column;
    if (const Entry* of = find("column")) column = text_of("column", *of);
    if (reads_files_)
      read_spectrum(case_file_.parent_path() / name, table_, column, spectrum);
    else
      spectrum.points = {{1.0, 1e-30}, {2.0, 1e-30}};
    return spectrum;
  }

  static constexpr const char* spectrum_allowed =
      "a file, or points of frequency and density, as [[5, 0.01], [20, 0.02], [200, 0.0005]]";

  std::string table_;
  const std::filesystem::path& case_file_;
  const Entries& entries_;
  double duration_;
  bool reads_files_;
};

}  // namespace

bool states_general_motion(std::string_view table, const Entries& entries) {
  return std::ranges::any_of(statements,
                             [&](std::string_view name) { return entries.contains(key_in(table, name)); });
}

std::optional<GeneralMotion> general_motion_of(std::string_view table, const std::filesystem::path& case_file,
                                               const Entries& entries, double duration, bool reads_files) {
  return MotionReader(table, case_file, entries, duration, reads_files).read();
}

}  // namespace stickslip::data
