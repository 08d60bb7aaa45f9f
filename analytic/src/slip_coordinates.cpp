#include "slip_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stickslip::analytic {
namespace {

/// q = (T, u_c): a transition changes nothing.
class HeldCoordinates final : public SlipCoordinates {
 public:
  explicit HeldCoordinates(const ContactDynamics& dynamics) : dynamics_(dynamics) {}

  [[nodiscard]] std::size_t size() const override { return dynamics_.modes() + 1; }
  [[nodiscard]] double fastest() const override { return dynamics_.fastest(); }
  [[nodiscard]] double mass_of(std::size_t coordinate) const override {
    return coordinate < dynamics_.modes() ? dynamics_.model().contact_mass : 1.0;
  }

  void accelerate(std::span<const double> q, std::span<const double> q_t, double s, double f,
                  std::span<double> q_tt) const override {
    const std::size_t m = dynamics_.modes();
    q_tt[m] = dynamics_.accelerate({q.first(m), q_t.first(m), q[m], q_t[m]}, s, f, q_tt.first(m));
  }

  [[nodiscard]] double contact(std::span<const double> q) const override { return q.back(); }

  void set(const ContactKinematics& state, double, double, std::span<double> q,
           std::span<double> q_t) const override {
    std::ranges::copy(state.amplitudes, q.begin());
    std::ranges::copy(state.rates, q_t.begin());
    q.back() = state.displacement;
    q_t.back() = state.velocity;
  }

  [[nodiscard]] ContactKinematics held(std::span<const double> q,
                                       std::span<const double> q_t) const override {
    return {{q.begin(), q.end() - 1}, {q_t.begin(), q_t.end() - 1}, q.back(), q_t.back()};
  }

 private:
  const ContactDynamics& dynamics_;
};

/// Amplitudes of FreeContactModes. What the projection of a held state leaves out is made up for at the
/// contact with the least energy: its velocity by the impulse response g, its displacement and its
/// acceleration by the shapes K^-1 g and g.
class FreeCoordinates final : public SlipCoordinates {
 public:
  explicit FreeCoordinates(const ContactDynamics& dynamics)
      : dynamics_(dynamics), modes_(*dynamics.model().free_modes) {
    for (std::size_t k = 0; k < size(); ++k)
      flexibility_.push_back(modes_.contact_input[k] / std::pow(modes_.angular_frequency[k], 2));
  }

  [[nodiscard]] std::size_t size() const override { return modes_.angular_frequency.size(); }
  [[nodiscard]] double fastest() const override { return std::ranges::max(modes_.angular_frequency); }
  [[nodiscard]] double mass_of(std::size_t) const override { return 1.0; }

  void accelerate(std::span<const double> q, std::span<const double> q_t, double s, double f,
                  std::span<double> q_tt) const override {
    for (std::size_t k = 0; k < size(); ++k) {
      const double omega = modes_.angular_frequency[k];
      q_tt[k] = modes_.load[k] * s + modes_.contact_input[k] * f - omega * omega * q[k];
      if (modes_.damping.empty()) continue;
      const std::span row(&modes_.damping(k, 0), size());
      q_tt[k] -= std::inner_product(row.begin(), row.end(), q_t.begin(), 0.0);
    }
  }

  [[nodiscard]] double contact(std::span<const double> q) const override {
    return std::reduce(q.begin(), q.end());
  }

  void set(const ContactKinematics& state, double t, double force, std::span<double> q,
           std::span<double> q_t) const override {
    project(state.amplitudes, state.displacement, q);
    project(state.rates, state.velocity, q_t);
    const std::vector<double>& impulse = modes_.contact_input;
    shift(q_t, state.velocity - contact(q_t), impulse);
    shift(q, state.displacement - contact(q), flexibility_);
    std::vector<double> q_tt(size());
    accelerate(q, q_t, dynamics_.load(t), force, q_tt);
    const double held_force = dynamics_.holding_force(view(state), t);
    const double excess =
        contact(q_tt) - dynamics_.wall_acceleration(t) - (force - held_force) * contact(impulse);
    // g - c K^-1 g leaves the contact where it is and accelerates it by -sum omega_k^2 (g - c K^-1 g)_k.
    const double ratio = contact(impulse) / contact(flexibility_);
    double slope = -ratio * contact(impulse);
    for (std::size_t k = 0; k < size(); ++k) slope += std::pow(modes_.angular_frequency[k], 2) * impulse[k];
    for (std::size_t k = 0; k < size(); ++k) q[k] += excess / slope * (impulse[k] - ratio * flexibility_[k]);
  }

  [[nodiscard]] ContactKinematics held(std::span<const double> q,
                                       std::span<const double> q_t) const override {
    return {amplitudes(q), amplitudes(q_t), contact(q), contact(q_t)};
  }

 private:
  void project(const std::vector<double>& amplitudes, double displacement, std::span<double> q) const {
    for (std::size_t k = 0; k < size(); ++k) {
      const std::span row(&modes_.from_held(k, 0), amplitudes.size() + 1);
      q[k] = std::inner_product(amplitudes.begin(), amplitudes.end(), row.begin(), row.back() * displacement);
    }
  }

  void shift(std::span<double> q, double missing, const std::vector<double>& shape) const {
    const double factor = missing / contact(shape);
    for (std::size_t k = 0; k < size(); ++k) q[k] += factor * shape[k];
  }

  [[nodiscard]] std::vector<double> amplitudes(std::span<const double> q) const {
    std::vector<double> result(dynamics_.modes());
    for (std::size_t n = 0; n < result.size(); ++n) {
      const std::span row(&modes_.to_held(n, 0), size());
      result[n] = std::inner_product(q.begin(), q.end(), row.begin(), 0.0);
    }
    return result;
  }

  const ContactDynamics& dynamics_;
  const FreeContactModes& modes_;
  std::vector<double> flexibility_;  // K^-1 g
};

}  // namespace

std::unique_ptr<SlipCoordinates> make_slip_coordinates(const ContactDynamics& dynamics) {
  if (dynamics.model().free_modes) return std::make_unique<FreeCoordinates>(dynamics);
  return std::make_unique<HeldCoordinates>(dynamics);
}

}  // namespace stickslip::analytic
