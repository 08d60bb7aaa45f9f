// SPDX-License-Identifier: MIT
// planck, Box2D in JavaScript: a box on an edge, 8 velocity and 3 position iterations.
import planck from "planck";
import { halfHeight, halfLength, run } from "./engine.mjs";

run(class {
  constructor(problem, step) {
    this.step = step;
    this.world = new planck.World({ x: problem.along, y: -problem.down });
    this.world.createBody().createFixture({ shape: new planck.Edge({ x: -200, y: 0 }, { x: 200, y: 0 }), friction: problem.friction });
    this.block = this.world.createDynamicBody({ position: { x: problem.position, y: halfHeight + 0.01 }, linearVelocity: { x: problem.velocity, y: 0 } });
    this.block.createFixture({ shape: new planck.Box(halfLength, halfHeight), friction: problem.friction,
      density: problem.mass / (4 * halfLength * halfHeight) });
  }
  push(force) { this.block.applyForceToCenter({ x: force, y: 0 }, true); }
  advance() { this.world.step(this.step, 8, 3); }
  position() { return this.block.getPosition().x; }
  velocity() { return this.block.getLinearVelocity().x; }
}, 1 / 60);
