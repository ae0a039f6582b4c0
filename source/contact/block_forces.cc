#include "contact/block_forces.h"
#include "contact/couple.h"
#include <birdstrike/core/simd/larger.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    /// The sum of the shares of one point's touches, which follow one another.
    double total_share(const std::vector<TouchRecord> &touches, const std::size_t t)
    {
      double sum = touches[t].share;
      for (std::size_t k = t; k > 0 && touches[k - 1].point == touches[t].point; --k)
        sum += touches[k - 1].share;
      for (std::size_t k = t + 1; k < touches.size() && touches[k].point == touches[t].point; ++k)
        sum += touches[k].share;
      return sum;
    }
  } // namespace

  void BlockForces::add(const ContactLaw &law, const PointMemory &memory, const Target &target)
  {
    const std::size_t n = (target.touches.size() + n_lanes - 1) / n_lanes * n_lanes;
    for (auto *array :
         {&forces[0], &forces[1], &forces[2], &dissipative[0], &dissipative[1], &dissipative[2], &stored, &tangent})
      array->resize(std::max(array->size(), n));
    for (std::size_t b = 0; b < n; b += n_lanes)
      compute_batch(law, memory, target, b);
    join_halves(target.touches);
    share_out(target, law.friction > 0.);
  }

  void BlockForces::join_halves(const std::vector<TouchRecord> &touches)
  {
    for (std::size_t t = 0; t < touches.size(); ++t)
      if (touches[t].is_half)
        {
          const Point3 &normal  = touches[t].normal;
          const auto    damping = [&](const std::size_t k) {
            return (normal[0] * dissipative[0][k] + normal[1] * dissipative[1][k] + normal[2] * dissipative[2][k]) /
                   normal.squaredNorm();
          };
          const double one = damping(t), other = damping(t + 1), least = std::min(one, other);
          for (unsigned int d = 0; d < 3; ++d)
            for (auto *array : {&forces[d], &dissipative[d]})
              {
                (*array)[t] += (least - one) * normal[d];
                (*array)[t + 1] += (least - other) * normal[d];
              }
        }
  }

  void BlockForces::compute_batch(const ContactLaw &law, const PointMemory &memory, const Target &target,
                                  const std::size_t begin)
  {
    // a list of gathers and one call of the law; the last batch is filled up with copies of the last touch, whose
    // results are never read
    const PointsView                        &points  = target.points;
    const auto                              &touches = target.touches;
    std::array<const TouchRecord *, n_lanes> touched;
    std::array<const PointRecord *, n_lanes> record;
    std::array<std::uint32_t, n_lanes>       point;
    alignas(64) std::array<double, n_lanes>  owners; // of the point's mass
    for (std::size_t j = 0; j < n_lanes; ++j)
      {
        const std::size_t t = std::min(begin + j, touches.size() - 1);
        touched[j]          = &touches[t];
        point[j]            = touched[j]->point;
        record[j]           = &memory.data()[points.id[point[j]]];
        owners[j]           = total_share(touches, t);
      }
    const auto of_touch  = [&](const auto &value) { return Lanes([&](const auto j) { return value(*touched[j]); }); };
    const auto of_record = [&](const auto &value) { return Lanes([&](const auto j) { return value(*record[j]); }); };

    Touch<Lanes> touch;
    touch.penetration = of_touch([](const TouchRecord &t) { return t.penetration; });
    touch.size        = of_record([](const PointRecord &r) { return r.size; });
    touch.modulus     = of_record([](const PointRecord &r) { return r.modulus; });
    touch.hardening   = of_record([&](const PointRecord &r) { return law.hardening(r.softening()); });
    touch.density =
      max(gather(points.density, point.data()), of_record([](const PointRecord &r) { return r.density; }));
    touch.sound_speed =
      max(gather(points.sound_speed, point.data()), of_record([](const PointRecord &r) { return r.sound_speed; }));
    std::array<Lanes, 4> loads, mobility;
    for (unsigned int k = 0; k < 4; ++k)
      {
        loads[k]    = of_touch([&](const TouchRecord &t) { return t.loads[k]; });
        mobility[k] = of_touch([&](const TouchRecord &t) { return target.mobility[t.nodes[k]]; });
      }
    touch.reduced_mass =
      compute_reduced_mass(Lanes(load<Lanes>(owners.data()) / gather(points.mass, point.data())), loads, mobility);
    for (unsigned int d = 0; d < 3; ++d)
      {
        touch.normal[d]   = of_touch([&](const TouchRecord &t) { return t.normal[d]; });
        touch.velocity[d] = of_touch([&](const TouchRecord &t) { return t.velocity[d]; });
      }
    const auto  force = compute_contact_force(law, touch);
    const Lanes share = of_touch([](const TouchRecord &t) { return t.share; });
    store(share * force.stored_energy, &stored[begin]);
    store(share * force.tangent, &tangent[begin]);
    for (unsigned int d = 0; d < 3; ++d)
      {
        store(share * force.force[d], &forces[d][begin]);
        store(share * force.dissipative[d], &dissipative[d][begin]);
      }
  }

  void BlockForces::share_out(const Target &target, const bool has_friction)
  {
    const PointsView &points = target.points;
    BlockReport      &report = target.report;
    report.n_touching        = target.touches.size();
    double stiffness         = 0.; // of the touches of one point, N/m
    for (std::size_t t = 0; t < report.n_touching; ++t)
      {
        TouchRecord        &touch = target.touches[t];
        const std::uint32_t i     = touch.point;
        const NodeSums::Sum force{forces[0][t], forces[1][t], forces[2][t]};
        for (unsigned int d = 0; d < 3; ++d)
          {
            target.point_forces.component[d][i] += force[d];
            report.force[d] -= force[d];
          }
        const auto  &loads = touch.loads;
        const double total = has_friction || touch.is_oblique ? loads[0] + loads[1] + loads[2] + loads[3] : 1.;
        for (unsigned int k = 0; k < 4; ++k)
          {
            NodeSums::Sum &sum = target.node_sums[touch.nodes[k]];
            for (unsigned int d = 0; d < 3; ++d)
              sum[d] -= touch.weights[k] * force[d];
            sum[3] += loads[k] * total * tangent[t]; // at least what a node's row of the stiffness sums up to
          }
        report.stored_energy += stored[t];
        touch.dissipative = Point3(dissipative[0][t], dissipative[1][t], dissipative[2][t]);
        if (exceeds(touch.penetration, report.penetration))
          {
            report.penetration   = touch.penetration;
            report.deepest_point = i;
            report.deepest_facet = touch.facet;
          }

        stiffness = tangent[t] + (t > 0 && target.touches[t - 1].point == i ? stiffness : 0.);
        if (const double squared = stiffness / points.mass[i]; exceeds(squared, report.largest_point.value))
          report.largest_point = {squared, i};
        if (has_friction || touch.is_oblique)
          add_couple(target, touch, has_friction, Point3(force[0], force[1], force[2]));
        report.dissipation_power -= touch.dissipative.dot(touch.velocity);
        if (!target.patches.empty())
          add_to_patches(target, touch, Point3(force[0], force[1], force[2]));
      }
  }

  void BlockForces::add_couple(const Target &target, TouchRecord &touch, const bool has_friction, const Point3 &force)
  {
    const Couple couple(target.facets, has_friction, touch);
    const Point3 turn = couple.turn(force);
    const Point3 tilt = couple.tilt(force);
    touch.turn        = couple.turn(touch.dissipative);
    touch.tilt        = couple.tilt(touch.dissipative);
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Point3 more = turn.cross(couple.arm(k)) + touch.turn_weights[k] * tilt;
        for (unsigned int d = 0; d < 3; ++d)
          target.node_sums[touch.nodes[k]][d] -= more[d];
      }
  }

  void BlockForces::add_to_patches(const Target &target, const TouchRecord &touch, const Point3 &force)
  {
    const auto  &x       = target.points.position;
    const Point3 closest = Point3(x[0][touch.point], x[1][touch.point], x[2][touch.point]) - touch.offset;
    for (std::size_t k = 0; k < target.patches.size(); ++k)
      if (const PressurePatch &patch = target.patches[k]; patch.holds(closest))
        target.report.patch_pressures[k] += force.dot(touch.normal.normalized()) / patch.area;
  }
} // namespace birdstrike
