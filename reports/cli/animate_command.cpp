// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "render/animation.hpp"
#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

constexpr double periods = 10.0;  // unless --duration or --set gives a duration

struct AnimateOptions {
  CaseOptions problem;
  std::optional<std::string> method;
  int frames = 200;
  std::string output = "frames";
};

// Films are GIF or, by ffmpeg, MP4.
std::string no_other_film(const std::string& name) {
  if (!name.ends_with(".webm") && !name.ends_with(".avi")) return "";
  return fmt::format(
      "is {}, but must be a folder, a .gif or a .mp4 file; ffmpeg makes other films of the frames in a "
      "folder",
      data::printable(name));
}

// A case whose duration ends with the film, which begins at a time, s.
struct Filmed {
  data::Case problem;
  double from{};
};

// Of a general motion the first slip, or the largest |f|, of the contact held for ever is in the middle of the film.
Filmed filmed(const AnimateOptions& options) {
  const data::Case problem = load_case(options.problem);
  (void)problem.beam();  // which this needs
  for (const data::Override& given : overrides_of(options.problem))
    if (data::state_the_same(given.key, "excitation.duration")) return {problem};
  double length = periods / data::highest_frequency_hz(problem), from = 0.0;
  if (problem.has(data::Feature::general_motion)) {
    const double duration = problem.numerics.duration();
    length = std::min(length, duration);
    if (!problem.has(data::Feature::shear)) {  // which that force does not take
      const auto held = analytic::motion_reaction(problem, problem.numerics.modes());
      from = std::clamp(held.first_excess.value_or(held.time) - 0.5 * length, 0.0, duration - length);
    }
  }
  return {restated(problem, {{"excitation.duration", from + length}}), from};
}

std::string caption_of(const data::Case& problem) {
  if (problem.has(data::Feature::general_motion)) return conditions_of(problem);
  const data::KeyAxis& stated = data::stated_amplitude(problem.excitation()).axis;
  return fmt::format("base at {:g} Hz, {:g} {}", problem.excitation().frequency_hz(),
                     stated.scale * problem.excitation().stated(), stated.unit());
}

Answer animate(const AnimateOptions& options, Outputs& outputs) {
  const auto [problem, from] = filmed(options);
  outputs.set_case(problem);
  const double duration = problem.numerics.duration() - from;
  if (options.frames - 1 > duration / problem.numerics.time_step() * (1.0 + 1e-12))
    throw data::FieldError(
        "--frames", options.frames,
        fmt::format("at most one per time step of {} s, of which {} s have {}",
                    data::shortest_text(problem.numerics.time_step()), data::shortest_text(duration),
                    static_cast<long>(duration / problem.numerics.time_step() * (1.0 + 1e-12)) + 1));
  const studies::MethodChoice choice = studies::method_for(
      problem,
      {.method = options.method, .of_many_places = true, .of_elements = mesh_key_of(options.problem)});
  const studies::Method& method = *choice.method;
  report::write_animation(problem, {.method = &method,
                                    .frames = options.frames,
                                    .from = from,
                                    .output = options.output,
                                    .caption = caption_of(problem),
                                    .title = outputs.heading("Motion of the beam"),
                                    .quiet = outputs.is_quiet()});
  Answer answer;
  add_method(answer, choice);
  answer.add_line(fmt::format("{} frames written to {}", options.frames, options.output));
  add_excitation(answer, problem);
  answer.add_members(
      {{"from_s", from}, {"duration_s", duration}, {"frames", options.frames}, {"output", options.output}});
  answer.warnings = sentences_of(studies::history_warnings(problem, method));
  return answer;
}

void add_options(CLI::App& command, AnimateOptions& options) {
  add_case_options(command, options.problem);
  add_excitation_options(command, options.problem);
  command
      .add_option("--method", options.method,
                  "Finite elements with contact, or event by event in the modes of the continuous beam "
                  "(default: the first line of the answer says which and why)")
      ->check(one_of({studies::event_driven().name, studies::finite_elements().name}));
  add_duration_option(command, options.problem,
                      "else ten periods of the highest frequency of the excitation; of a general motion, "
                      "around its first slip");
  add_integer_option(command, "--frames", options.frames, 2, report::most_frames,
                     "Number of frames, evenly over the duration");
  command
      .add_option("--output", options.output,
                  "Folder for frame-0001.png ... and motion.csv, or a film, a .gif file or, where ffmpeg is "
                  "installed, a .mp4 file")
      ->check(file_name())
      ->check(CLI::Validator(no_other_film, ""))
      ->capture_default_str();
}

}  // namespace

void add_animate_command(CLI::App& app) {
  add<AnimateOptions>(
      app, {.name = "animate",
            .help = "Motion of the whole beam, as PNG files or a film",
            .examples =
                {"stickslip animate paper --hz 25 --amplitude 1e-3 --duration 0.1 --frames 5 --output film"},
            .add_options = add_options,
            .run = animate});
}

}  // namespace stickslip::cli
