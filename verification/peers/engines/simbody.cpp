// SPDX-License-Identifier: MIT
// Simbody: a brick on a half space with compliant contact, Runge-Kutta-Merson with its default accuracy over each step.
#include "engine.hpp"

#include <Simbody.h>
#include <memory>

class Simbody {
 public:
  Simbody(const Problem& problem, double step) : step_(step) {
    using namespace SimTK;
    Force::Gravity(forces_, matter_, Vec3(problem.along(), 0.0, -problem.down()));
    const ContactMaterial material(1e7, 1.0, problem.friction, problem.friction,
                                   0.0);  // Pa/m, s/m, static, dynamic, viscous
    matter_.Ground().updBody().addContactSurface(
        Transform(Rotation(Pi / 2, YAxis), Vec3(0)),  // it fills x > 0
        ContactSurface(ContactGeometry::HalfSpace(), material));
    const Vec3 half(half_length, half_length, half_height);
    Body::Rigid body(MassProperties(problem.mass, Vec3(0), problem.mass * UnitInertia::brick(half)));
    body.addContactSurface(Transform(), ContactSurface(ContactGeometry::Brick(half), material));
    block_ = MobilizedBody::Free(matter_.Ground(), Transform(), body, Transform());
    system_.realizeTopology();
    State state = system_.getDefaultState();
    block_.setQToFitTranslation(state, Vec3(problem.position, 0.0, half_height));
    block_.setUToFitLinearVelocity(state, Vec3(problem.velocity, 0.0, 0.0));
    integrator_ = std::make_unique<RungeKuttaMersonIntegrator>(system_);
    integrator_->setAllowInterpolation(false);
    integrator_->initialize(state);
  }
  void push(double force) {
    SimTK::State& state = integrator_->updAdvancedState();
    pushes_.setOneBodyForce(state, block_, SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(force, 0.0, 0.0)));
    integrator_->reinitialize(SimTK::Stage::Dynamics, false);
  }
  void advance() {
    const double end = ++steps_ * step_;
    while (integrator_->getTime() <
           end) {  // the first return after a new force tells the start of its interval
      integrator_->stepTo(end);
    }
  }
  double position() const { return block_.getBodyOriginLocation(integrator_->getState())[0]; }
  double velocity() const { return block_.getBodyOriginVelocity(integrator_->getState())[0]; }

 private:
  double step_;
  long steps_ = 0;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::Force::DiscreteForces pushes_{forces_, matter_};
  SimTK::ContactTrackerSubsystem tracker_{system_};
  SimTK::CompliantContactSubsystem contact_{system_, tracker_};
  SimTK::MobilizedBody::Free block_;
  std::unique_ptr<SimTK::RungeKuttaMersonIntegrator> integrator_;
};

int main(int argc, char** argv) { return run<Simbody>(argc, argv, 0.01); }
