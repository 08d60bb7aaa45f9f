// SPDX-License-Identifier: MIT
// Bullet: a box on a static plane, sequential impulses, friction as the product of both coefficients.
#include "engine.hpp"

#include <btBulletDynamicsCommon.h>

class Bullet {
 public:
  Bullet(const Problem& problem, double step) : step_(step) {
    world_.setGravity(btVector3(problem.along(), 0.0, -problem.down()));
    ground_.setFriction(1.0);
    world_.addRigidBody(&ground_);
    btVector3 inertia;
    shape_.calculateLocalInertia(problem.mass, inertia);
    block_ = new btRigidBody(problem.mass, nullptr, &shape_, inertia);
    block_->setWorldTransform(
        btTransform(btQuaternion::getIdentity(), btVector3(problem.position, 0.0, half_height)));
    block_->setLinearVelocity(btVector3(problem.velocity, 0.0, 0.0));
    block_->setFriction(problem.friction);
    world_.addRigidBody(block_);
  }
  void push(double force) {
    block_->activate();
    block_->applyCentralForce(btVector3(force, 0.0, 0.0));
  }
  void advance() { world_.stepSimulation(step_, 0); }
  double position() const { return block_->getWorldTransform().getOrigin().x(); }
  double velocity() const { return block_->getLinearVelocity().x(); }

 private:
  double step_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btStaticPlaneShape plane_{btVector3(0.0, 0.0, 1.0), 0.0};
  btBoxShape shape_{btVector3(half_length, half_length, half_height)};
  btRigidBody ground_{0.0, nullptr, &plane_};
  btRigidBody* block_ = nullptr;
};

int main(int argc, char** argv) { return run<Bullet>(argc, argv, 1.0 / 240.0); }
