// SPDX-License-Identifier: MIT
// Chipmunk: two dimensions, a box on a segment, 10 iterations (its default).
#include "engine.hpp"

#include <chipmunk/chipmunk.h>

class Chipmunk {
 public:
  Chipmunk(const Problem& problem, double step) : step_(step) {
    cpSpaceSetGravity(space_, cpv(problem.along(), -problem.down()));
    cpShape* ground = cpSegmentShapeNew(cpSpaceGetStaticBody(space_), cpv(-200.0, 0.0), cpv(200.0, 0.0), 0.0);
    cpShapeSetFriction(ground, 1.0);  // that of a contact is the product of both
    cpSpaceAddShape(space_, ground);
    block_ = cpBodyNew(problem.mass, cpMomentForBox(problem.mass, 2 * half_length, 2 * half_height));
    cpSpaceAddBody(space_, block_);
    cpShape* box = cpBoxShapeNew(block_, 2 * half_length, 2 * half_height, 0.0);
    cpShapeSetFriction(box, problem.friction);
    cpSpaceAddShape(space_, box);
    cpBodySetPosition(block_, cpv(problem.position, half_height));
    cpBodySetVelocity(block_, cpv(problem.velocity, 0.0));
  }
  void push(double force) { cpBodySetForce(block_, cpv(force, 0.0)); }
  void advance() { cpSpaceStep(space_, step_); }
  double position() const { return cpBodyGetPosition(block_).x; }
  double velocity() const { return cpBodyGetVelocity(block_).x; }

 private:
  double step_;
  cpSpace* space_ = cpSpaceNew();
  cpBody* block_;
};

int main(int argc, char** argv) { return run<Chipmunk>(argc, argv, 1.0 / 60.0); }
