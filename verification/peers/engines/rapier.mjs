// SPDX-License-Identifier: MIT
// Rapier in three dimensions: a box on a fixed box, friction as the mean of both coefficients.
import rapier from "@dimforge/rapier3d-compat";
import { halfHeight, halfLength, run } from "./engine.mjs";

await rapier.init();

run(class {
  constructor(problem, step) {
    this.world = new rapier.World({ x: problem.along, y: 0, z: -problem.down });
    this.world.timestep = step;
    this.world.createCollider(rapier.ColliderDesc.cuboid(200, 2, 1).setTranslation(0, 0, -1).setFriction(problem.friction));
    this.block = this.world.createRigidBody(rapier.RigidBodyDesc.dynamic()
      .setTranslation(problem.position, 0, halfHeight).setLinvel(problem.velocity, 0, 0));
    this.world.createCollider(rapier.ColliderDesc.cuboid(halfLength, halfLength, halfHeight)
      .setMass(problem.mass).setFriction(problem.friction), this.block);
  }
  push(force) {
    this.block.resetForces(true);
    this.block.addForce({ x: force, y: 0, z: 0 }, true);
  }
  advance() { this.world.step(); }
  position() { return this.block.translation().x; }
  velocity() { return this.block.linvel().x; }
}, 1 / 60);
