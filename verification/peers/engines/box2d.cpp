// SPDX-License-Identifier: MIT
// Box2D: two dimensions, a box on an edge, 8 velocity and 3 position iterations as in its manual.
#include "engine.hpp"

#include <box2d/box2d.h>

class Box2D {
 public:
  Box2D(const Problem& problem, double step) : step_(step), world_(b2Vec2(problem.along(), -problem.down())) {
    b2EdgeShape edge;
    edge.SetTwoSided(b2Vec2(-200.0F, 0.0F), b2Vec2(200.0F, 0.0F));
    b2BodyDef still;
    b2FixtureDef ground;
    ground.shape = &edge;
    ground.friction = problem.friction;  // that of a contact is the geometric mean of both
    world_.CreateBody(&still)->CreateFixture(&ground);
    b2PolygonShape box;
    box.SetAsBox(half_length, half_height);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.friction = problem.friction;
    fixture.density = problem.mass / (4 * half_length * half_height);
    b2BodyDef moving;
    moving.type = b2_dynamicBody;
    moving.position.Set(problem.position, half_height + 2 * b2_polygonRadius);
    moving.linearVelocity.Set(problem.velocity, 0.0F);
    block_ = world_.CreateBody(&moving);
    block_->CreateFixture(&fixture);
  }
  void push(double force) { block_->ApplyForceToCenter(b2Vec2(force, 0.0F), true); }
  void advance() { world_.Step(step_, 8, 3); }
  double position() const { return block_->GetPosition().x; }
  double velocity() const { return block_->GetLinearVelocity().x; }

 private:
  float step_;
  b2World world_;
  b2Body* block_;
};

int main(int argc, char** argv) { return run<Box2D>(argc, argv, 1.0 / 60.0); }
