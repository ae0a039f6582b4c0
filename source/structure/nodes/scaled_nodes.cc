#include "structure/nodes/scaled_nodes.h"

#include <algorithm>

namespace birdstrike
{
  void ScaledNodes::clear_contact()
  {
    std::fill(effective_contact.begin(), effective_contact.end(), 0.);
    is_contact_known = false;
  }

  void ScaledNodes::update_contact(const double *contact)
  {
    if (!is_contact_known)
      mass.compute_effective_forces(contact, nullptr, effective_contact.data());
    is_contact_known = true;
  }

  double ScaledNodes::dissipated(const Kick &kick, const bool is_first) const
  {
    if (kick.decay == 1.)
      return 0.;
    const double *v = kick.velocity, *f = effective.data();
    const auto    gain = [=](const std::size_t k) {
      return kick.duration * (f[k] + kick.external[k]) * kick.inverse_mass[k];
    };
    // first: v decay + gain, second: (v + gain) decay; damped is what decays, drift what the nodes move with
    const auto damped = [=](const std::size_t k) { return (is_first ? v[k] - gain(k) : v[k]) / kick.decay; };
    const auto drift  = [=](const std::size_t k) { return is_first ? v[k] : v[k] / kick.decay - gain(k); };
    return (1. - kick.decay) * mass.sum_edges([=](const std::size_t i, const std::size_t j) {
      return (damped(j) - damped(i)) * (drift(j) - drift(i));
    });
  }

  std::array<double, 2> ScaledNodes::kinetic(const Kick &kick, const double contact_duration) const
  {
    const double *v = kick.velocity, *f = effective.data(), *f_contact = effective_contact.data();
    const double  back   = 1. - 1. / kick.decay;
    const auto    change = [=](const std::size_t k) {
      const double impulse = kick.duration * (f[k] + kick.external[k]) + contact_duration * f_contact[k];
      return impulse * kick.inverse_mass[k] + back * v[k];
    };
    const auto square = [](const double a) { return 0.5 * a * a; };
    return {mass.sum_edges([=](const std::size_t i, const std::size_t j) { return square(v[j] - v[i]); }),
            mass.sum_edges([=](const std::size_t i, const std::size_t j) { return square(change(j) - change(i)); })};
  }
} // namespace birdstrike
