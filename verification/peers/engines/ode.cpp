// SPDX-License-Identifier: MIT
// Open Dynamics Engine: a box on a plane, contact joints of each step, the friction pyramid scaled with the normal force.
#include "engine.hpp"

#include <ode/ode.h>

class Ode {
 public:
  Ode(const Problem& problem, double step) : step_(step), friction_(problem.friction) {
    dWorldSetGravity(world_, problem.along(), 0.0, -problem.down());
    dCreatePlane(space_, 0.0, 0.0, 1.0, 0.0);
    dMass mass;
    dMassSetBoxTotal(&mass, problem.mass, 2 * half_length, 2 * half_length, 2 * half_height);
    dBodySetMass(block_, &mass);
    dGeomSetBody(dCreateBox(space_, 2 * half_length, 2 * half_length, 2 * half_height), block_);
    dBodySetPosition(block_, problem.position, 0.0, half_height);
    dBodySetLinearVel(block_, problem.velocity, 0.0, 0.0);
  }
  void push(double force) { dBodyAddForce(block_, force, 0.0, 0.0); }
  void advance() {
    dSpaceCollide(space_, this, &Ode::touch);
    dWorldStep(world_, step_);
    dJointGroupEmpty(contacts_);
  }
  double position() const { return dBodyGetPosition(block_)[0]; }
  double velocity() const { return dBodyGetLinearVel(block_)[0]; }

 private:
  static void touch(void* self, dGeomID one, dGeomID other) {
    const Ode& ode = *static_cast<Ode*>(self);
    dContactGeom points[8];
    const int number = dCollide(one, other, 8, points, sizeof(dContactGeom));
    for (int i = 0; i < number; ++i) {
      dContact contact{};
      contact.geom = points[i];
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = ode.friction_;
      dJointAttach(dJointCreateContact(ode.world_, ode.contacts_, &contact), dGeomGetBody(one),
                   dGeomGetBody(other));
    }
  }
  double step_, friction_;
  int started_ = dInitODE2(0);
  dWorldID world_ = dWorldCreate();
  dSpaceID space_ = dSimpleSpaceCreate(nullptr);
  dBodyID block_ = dBodyCreate(world_);
  dJointGroupID contacts_ = dJointGroupCreate(0);
};

int main(int argc, char** argv) { return run<Ode>(argc, argv, 0.01); }
