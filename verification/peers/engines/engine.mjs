// SPDX-License-Identifier: MIT
// What engine.hpp does, for engines in JavaScript: run(Engine, step) is "driver PROBLEM FOLDER [STEP]".
import { readFileSync, writeFileSync } from "node:fs";

export const halfLength = 0.5, halfHeight = 0.1;

const table = (file) => {
  const [names, ...lines] = readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(","));
  return lines.map((line) => Object.fromEntries(line.map((text, i) => [names[i], Number.isNaN(Number(text)) ? text : Number(text)])));
};

/** The engine gets the force of the state before the step; seen(time, position, velocity) is called after it. */
function simulate(Engine, problem, step, seen) {
  const engine = new Engine(problem, step);
  const isPushed = problem.stiffness !== 0 || problem.amplitude !== 0;
  for (let i = 0; i < Math.ceil(problem.end / step - 1e-9); ++i) {
    if (isPushed) {
      engine.push(problem.amplitude * Math.sin(problem.angular_frequency * i * step) - problem.stiffness * engine.position());
    }
    engine.advance();
    seen((i + 1) * step, engine.position(), engine.velocity());
  }
}

export function run(Engine, usualStep) {
  const [name, folder, step = usualStep] = process.argv.slice(2).map((word, i) => (i < 2 ? word : Number(word)));
  const found = table("/peers/engines/problems.csv").filter((one) => one.problem === name);
  const rows = [name === "friction-powers" ? "amplitude,power" : "problem,index,change,time,position"];
  for (const problem of found) {
    const slope = Math.hypot(1, problem.slope);
    Object.assign(problem, { along: (problem.gravity * problem.slope) / slope, down: problem.gravity / slope });
    if (name === "friction-powers") {
      let work = 0;
      simulate(Engine, problem, step, (time, x, velocity) => {
        work += time > 4 + step / 2 ? problem.mass * problem.gravity * Math.abs(velocity) * step : 0;
      });
      rows.push(`${-problem.amplitude},${work / (problem.end - 4)}`);
      continue;
    }
    const events = table("/data/reference/single-mass/published-problems.csv").filter((one) => one.problem === name);
    let before = [0, problem.position];
    simulate(Engine, problem, step, (time, x) => {
      while (events.length > 0 && events[0].time <= time + 1e-9) {
        const event = events.shift(), share = (event.time - before[0]) / (time - before[0]);
        rows.push(`${name},${event.index},${event.change},${event.time},${before[1] + share * (x - before[1])}`);
      }
      before = [time, x];
    });
  }
  if (found.length === 0) throw new Error(`problems.csv has no ${name}`);
  writeFileSync(`${folder}/result.csv`, rows.join("\n") + "\n");
}
