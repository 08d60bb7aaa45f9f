// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// A line of problems.csv: a block on a plane of slope tan(a), with a spring to the ground and the force G sin(Omega t).
/// In friction-powers the plane is shaken. The frame is that of the plane, and the force that of inertia.
struct Problem {
  std::string name;
  double mass, gravity, slope, friction, stiffness, position, velocity, amplitude, angular_frequency, end;

  double along() const { return gravity * slope / std::hypot(1.0, slope); }
  double down() const { return gravity / std::hypot(1.0, slope); }
  bool is_pushed() const { return stiffness != 0.0 || amplitude != 0.0; }
  double force(double time, double x) const {
    return amplitude * std::sin(angular_frequency * time) - stiffness * x;
  }
};

/// The block: 1 m long, 1 m wide and 0.2 m high, so that it cannot tip.
constexpr double half_length = 0.5, half_height = 0.1;

inline std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    result.push_back(field);
  }
  return result;
}

inline std::vector<std::vector<std::string>> lines_of(const std::string& file, const std::string& problem) {
  std::vector<std::vector<std::string>> result;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(problem + ",", 0) == 0) {
      result.push_back(fields(line));
    }
  }
  return result;
}

/// Calls seen(time, position, velocity) after each step. The engine gets the force of the state before the step.
template <class Engine, class Seen>
void simulate(const Problem& problem, double step, const Seen& seen) {
  Engine engine(problem, step);
  const long number = std::lround(std::ceil(problem.end / step - 1e-9));
  for (long i = 0; i < number; ++i) {
    if (problem.is_pushed()) {
      engine.push(problem.force(i * step, engine.position()));
    }
    engine.advance();
    seen((i + 1) * step, engine.position(), engine.velocity());
  }
}

/// driver PROBLEM FOLDER [STEP]: writes FOLDER/result.csv. An engine tells states and no events: its table has the events of
/// data/reference with its own positions at their times, between two steps on a straight line.
template <class Engine>
int run(int argc, char** argv, double usual_step) {
  if (argc < 3) {
    std::cerr << "usage: driver PROBLEM FOLDER [STEP]\n";
    return 2;
  }
  const std::string name = argv[1];
  const double step = argc > 3 ? std::atof(argv[3]) : usual_step;
  std::ofstream out(std::string(argv[2]) + "/result.csv");
  out.precision(12);
  out << (name == "friction-powers" ? "amplitude,power\n" : "problem,index,change,time,position\n");
  const auto found = lines_of("/peers/engines/problems.csv", name);
  for (const std::vector<std::string>& f : found) {
    std::array<double, 10> v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i] = std::stod(f.at(i + 1));
    }
    const Problem problem{name, v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9]};
    if (name == "friction-powers") {
      double work = 0.0;
      simulate<Engine>(problem, step, [&](double time, double /*x*/, double velocity) {
        work += time > 4.0 + step / 2 ? problem.mass * problem.gravity * std::abs(velocity) * step : 0.0;
      });
      out << -problem.amplitude << ',' << work / (problem.end - 4.0) << '\n';
      continue;
    }
    const auto events = lines_of("/data/reference/single-mass/published-problems.csv", name);
    std::size_t next = 0;
    std::pair<double, double> before{0.0, problem.position};
    simulate<Engine>(problem, step, [&](double time, double x, double /*v*/) {
      for (; next < events.size() && std::stod(events[next][3]) <= time + 1e-9; ++next) {
        const double share = (std::stod(events[next][3]) - before.first) / (time - before.first);
        out << name << ',' << events[next][1] << ',' << events[next][2] << ',' << events[next][3] << ','
            << before.second + share * (x - before.second) << '\n';
      }
      before = {time, x};
    });
  }
  if (found.empty()) {
    std::cerr << "problems.csv has no " << name << '\n';
  }
  return found.empty() ? 2 : 0;
}
