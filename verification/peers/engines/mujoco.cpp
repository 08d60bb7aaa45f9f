// SPDX-License-Identifier: MIT
// MuJoCo: a box on a plane, soft contacts, all options at their defaults.
#include "engine.hpp"

#include <mujoco/mujoco.h>

class MuJoCo {
 public:
  MuJoCo(const Problem& problem, double step) {
    std::ostringstream model;
    model.precision(17);
    model << "<mujoco><option timestep='" << step << "' gravity='" << problem.along() << " 0 "
          << -problem.down() << "'/>"
          << "<default><geom friction='" << problem.friction << " 0.005 0.0001'/></default><worldbody>"
          << "<geom type='plane' size='0 0 1'/><body pos='0 0 " << half_height
          << "'><freejoint/><geom type='box' mass='" << problem.mass << "' size='" << half_length << ' '
          << half_length << ' ' << half_height << "'/></body></worldbody></mujoco>";
    std::ofstream("/tmp/block.xml") << model.str();
    char said[1000] = "";
    model_ = mj_loadXML("/tmp/block.xml", nullptr, said, sizeof said);
    if (model_ == nullptr) {
      std::cerr << said << '\n';
      std::exit(1);
    }
    data_ = mj_makeData(model_);
    data_->qpos[0] = problem.position;
    data_->qvel[0] = problem.velocity;
  }
  void push(double force) { data_->qfrc_applied[0] = force; }
  void advance() { mj_step(model_, data_); }
  double position() const { return data_->qpos[0]; }
  double velocity() const { return data_->qvel[0]; }

 private:
  mjModel* model_;
  mjData* data_;
};

int main(int argc, char** argv) { return run<MuJoCo>(argc, argv, 0.002); }
