// SPDX-License-Identifier: MIT
// matter-js: two dimensions; its y points down, lengths are pixels and times ms. The friction of the air is switched off.
import matter from "matter-js";
import { halfHeight, halfLength, run } from "./engine.mjs";

const pixels = 100, ms = 1000; // in 1 m, in 1 s
const perFrame = pixels * (matter.Body._baseDelta / ms); // its velocities are lengths in 1/60 s

run(class {
  constructor(problem, step) {
    this.step = step;
    this.engine = matter.Engine.create({ gravity: { x: problem.along, y: problem.down, scale: pixels / ms ** 2 } });
    const ground = matter.Bodies.rectangle(0, pixels, 400 * pixels, 2 * pixels, { isStatic: true, friction: problem.friction });
    this.block = matter.Bodies.rectangle(problem.position * pixels, -halfHeight * pixels, 2 * halfLength * pixels,
      2 * halfHeight * pixels, { friction: problem.friction, frictionAir: 0 });
    matter.Body.setMass(this.block, problem.mass);
    matter.Body.setVelocity(this.block, { x: problem.velocity * perFrame, y: 0 });
    matter.Composite.add(this.engine.world, [ground, this.block]);
  }
  push(force) { this.block.force.x += (force * pixels) / ms ** 2; }
  advance() { matter.Engine.update(this.engine, this.step * ms); }
  position() { return this.block.position.x / pixels; }
  velocity() { return matter.Body.getVelocity(this.block).x / perFrame; }
}, 1 / 60);
