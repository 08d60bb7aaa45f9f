// SPDX-License-Identifier: MIT
// cannon-es: a box on a plane, its default Gauss-Seidel solver; the air, a damping of 0.01 by default, is switched off.
import * as cannon from "cannon-es";
import { halfHeight, halfLength, run } from "./engine.mjs";

run(class {
  constructor(problem, step) {
    this.step = step;
    this.world = new cannon.World({ gravity: new cannon.Vec3(problem.along, 0, -problem.down) });
    this.world.defaultContactMaterial.friction = problem.friction;
    this.world.defaultContactMaterial.restitution = 0;
    this.world.addBody(new cannon.Body({ mass: 0, shape: new cannon.Plane() }));
    this.block = new cannon.Body({ mass: problem.mass, shape: new cannon.Box(new cannon.Vec3(halfLength, halfLength, halfHeight)),
      position: new cannon.Vec3(problem.position, 0, halfHeight), velocity: new cannon.Vec3(problem.velocity, 0, 0),
      linearDamping: 0, angularDamping: 0 });
    this.world.addBody(this.block);
  }
  push(force) { this.block.force.x += force; }
  advance() { this.world.step(this.step); }
  position() { return this.block.position.x; }
  velocity() { return this.block.velocity.x; }
}, 1 / 60);
