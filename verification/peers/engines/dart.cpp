// SPDX-License-Identifier: MIT
// DART: a box on a box that does not move, contacts as a linear complementarity problem with boxed friction.
#include "engine.hpp"

#include <dart/dart.hpp>

class Dart {
 public:
  Dart(const Problem& problem, double step) {
    world_->setGravity(Eigen::Vector3d(problem.along(), 0.0, -problem.down()));
    world_->setTimeStep(step);
    auto ground = dart::dynamics::Skeleton::create();
    auto* still = ground->createJointAndBodyNodePair<dart::dynamics::WeldJoint>().second;
    add(still, Eigen::Vector3d(400.0, 4.0, 2.0), problem.friction);
    ground->getJoint(0)->setTransformFromParentBodyNode(
        Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -1.0)));
    world_->addSkeleton(ground);
    auto* body = block_->createJointAndBodyNodePair<dart::dynamics::FreeJoint>().second;
    const Eigen::Vector3d size(2 * half_length, 2 * half_length, 2 * half_height);
    add(body, size, problem.friction);
    body->setInertia(dart::dynamics::Inertia(problem.mass, Eigen::Vector3d::Zero(),
                                             dart::dynamics::BoxShape::computeInertia(size, problem.mass)));
    block_->setPosition(3, problem.position);  // 0 to 2 are rotations
    block_->setPosition(5, half_height);
    block_->setVelocity(3, problem.velocity);
    world_->addSkeleton(block_);
  }
  void push(double force) { block_->setForce(3, force); }
  void advance() { world_->step(); }
  double position() const { return block_->getPosition(3); }
  double velocity() const { return block_->getVelocity(3); }

 private:
  static void add(dart::dynamics::BodyNode* body, const Eigen::Vector3d& size, double friction) {
    auto* node = body->createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(
        std::make_shared<dart::dynamics::BoxShape>(size));
    node->getDynamicsAspect()->setFrictionCoeff(friction);
  }
  dart::simulation::WorldPtr world_ = dart::simulation::World::create();
  dart::dynamics::SkeletonPtr block_ = dart::dynamics::Skeleton::create();
};

int main(int argc, char** argv) { return run<Dart>(argc, argv, 0.001); }
