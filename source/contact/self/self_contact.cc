#include <birdstrike/contact/self_contact.h>
#include <birdstrike/core/simd/larger.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double stiffness_share  = 0.4; // k dt^2 / m_s at first touch
    constexpr double largest_share    = 0.6;
    constexpr double least_weight_sum = 2.; // two sheets: each node is a point and shares facets

    /// Calls body(node, weight) for the point and the facet's nodes, opposite signs.
    template <class Body>
    void for_nodes(const SelfTouch &touch, const Body &body)
    {
      body(touch.point, 1.);
      for (unsigned int k = 0; k < 4; ++k)
        if (touch.weights[k] > 0.)
          body(touch.nodes[k], -touch.weights[k]);
    }

    double closing_speed(const FacetsView &facets, const SelfTouch &touch)
    {
      Point3 velocity(0., 0., 0.);
      for_nodes(touch, [&](const std::uint32_t node, const double weight) {
        velocity += weight * Point3(facets.velocity + facets.velocity_stride * node);
      });
      return -velocity.dot(touch.normal);
    }
  } // namespace

  SelfContact::SelfContact(const double damping_ratio) : damping_ratio(damping_ratio)
  {
  }

  SelfContactReport SelfContact::report() const
  {
    SelfContactReport whole = last;
    whole.stored_energy     = plane.whole(last.stored_energy);
    whole.dissipated_energy = plane.whole(last.dissipated_energy);
    whole.n_touching        = plane.whole(last.n_touching);
    return whole;
  }

  void SelfContact::update(const FacetsView &facets, const double step)
  {
    plane = facets.plane;
    topology.update(facets);
    touched.clear();
    for (const SelfTouch &touch : before)
      for (const unsigned int k : {0U, 2U})
        touched.push_back({{touch.point, touch.nodes[k]}});
    const bool is_changed = search.update(facets, topology, step, touched);
    last.looks            = search.n_looks();
    ++last.calls;
    nodal_forces.clear();
    last.n_touching = 0;
    if (search.candidates().empty() && before.empty())
      {
        last.stored_energy = 0.;
        narrow.skip();
        return;
      }

    narrow.update(facets, topology, search, step, is_changed);
    reserve(facets);
    last.pairs_tested += narrow.n_tested();
    book_second_halves(facets, step);
    last.stored_energy = 0.;

    share_masses(facets);
    for (SelfTouch &touch : narrow.touches())
      add_force(facets, touch, step);
    for (const NodalForce &force : nodal_forces)
      place[force.node] = 0;
    for (const SelfTouch &touch : narrow.touches())
      for_nodes(touch, [&](const std::uint32_t node, double) { weight_sums[node] = 0.; });
    before          = narrow.touches();
    last.n_touching = before.size();
    last.touches += before.size();
  }

  /// The forces of the last call have acted for another half step, with the present velocities. A touch that has ended
  /// held its energy until then: what its nodes did not get is lost.
  void SelfContact::book_second_halves(const FacetsView &facets, const double step)
  {
    for (const SelfTouch &touch : narrow.touches())
      if (const std::uint32_t from = narrow.side_of(touch).touch; from > 0)
        before[from - 1].goes_on = true;
    for (const SelfTouch &touch : before)
      {
        const double way = 0.5 * step * closing_speed(facets, touch);
        last.dissipated_energy += std::max(0., touch.goes_on ? touch.damping * way : touch.stored + touch.force * way);
      }
  }

  /// Lists grow with a look, never within a step.
  void SelfContact::reserve(const FacetsView &facets)
  {
    const std::size_t most = narrow.touches().capacity();
    if (before.capacity() >= most)
      return;
    before.reserve(most);
    touched.reserve(2 * most);
    nodal_forces.reserve(std::min(5 * most, facets.n_nodes));
  }

  void SelfContact::share_masses(const FacetsView &facets)
  {
    if (weight_sums.size() != facets.n_nodes)
      {
        weight_sums.assign(facets.n_nodes, 0.);
        place.assign(facets.n_nodes, 0);
      }
    for (const SelfTouch &touch : narrow.touches())
      for_nodes(touch, [&](const std::uint32_t node, const double weight) { weight_sums[node] += std::abs(weight); });
  }

  double SelfContact::inverse_mass(const FacetsView &facets, const SelfTouch &touch, const double least_sum) const
  {
    double sum = 0.;
    for_nodes(touch, [&](const std::uint32_t node, const double weight) {
      sum += std::abs(weight) * std::max(least_sum, weight_sums[node]) * facets.inverse_mass[node];
    });
    return sum;
  }

  void SelfContact::add_force(const FacetsView &facets, SelfTouch &touch, const double step)
  {
    SelfSide    &side   = narrow.side_of(touch);
    const double shared = inverse_mass(facets, touch, 0.);
    side.touch          = static_cast<std::uint32_t>(&touch - narrow.touches().data()) + 1;
    if (shared == 0.) // all are held
      return;
    const double d = touch.penetration, largest = largest_share / (shared * step * step),
                 speed = closing_speed(facets, touch);
    if (side.stiffness == 0.)
      {
        side.stiffness = stiffness_share / (inverse_mass(facets, touch, least_weight_sum) * step * step);
        // of the step in which it sets in it takes more than it stores
        last.dissipated_energy += 0.5 * touch.share * side.stiffness * d * std::max(0., speed * step - d);
      }
    if (side.stiffness > largest)
      {
        last.dissipated_energy += 0.5 * touch.share * (side.stiffness - largest) * d * d;
        side.stiffness = largest;
      }
    touch.stored = 0.5 * touch.share * side.stiffness * d * d;
    last.stored_energy += touch.stored;
    last.max_penetration = larger(last.max_penetration, d);

    const double elastic     = touch.share * side.stiffness * d;
    const double coefficient = touch.share * 2. * damping_ratio * std::sqrt(side.stiffness / shared);
    if (speed > 0.)
      touch.damping = std::min(coefficient * speed, std::max(0., speed / (shared * step) - elastic));
    else // it ends within the step if that is longer than d: then it gives no more than it has
      touch.damping =
        std::max(-elastic, std::min(coefficient * speed, elastic * (d / std::max(d, -speed * step) - 1.)));
    touch.force = elastic + touch.damping;
    last.dissipated_energy += std::max(0., 0.5 * step * touch.damping * speed);
    for_nodes(touch, [&](const std::uint32_t node, const double weight) {
      add_to_node(node, weight * touch.force * touch.normal);
    });
  }

  void SelfContact::add_to_node(const std::uint32_t node, const Point3 &force)
  {
    if (place[node] == 0)
      {
        nodal_forces.push_back({node, {}});
        place[node] = static_cast<std::uint32_t>(nodal_forces.size());
      }
    for (unsigned int d = 0; d < 3; ++d)
      nodal_forces[place[node] - 1].force[d] += force[d];
  }
} // namespace birdstrike
