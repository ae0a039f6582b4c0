#include <birdstrike/contact/block_forces.h>
#include <birdstrike/contact/gather.h>

#include <Eigen/LU>

#include <algorithm>
#include <numbers>

namespace birdstrike
{
  void BlockForces::add(const ContactLaw &law, const NarrowPhase &narrow_phase, const PointMemory &memory,
                        const Target &target)
  {
    const std::size_t n = (narrow_phase.touches().size() + n_lanes - 1) / n_lanes * n_lanes;
    for (auto *array : {&forces[0], &forces[1], &forces[2], &stored, &dissipated})
      array->resize(std::max(array->size(), n));
    for (std::size_t b = 0; b < n; b += n_lanes)
      compute_batch(law, narrow_phase, memory, target, b);
    share_out(narrow_phase, target, law.friction > 0.);
  }

  void BlockForces::compute_batch(const ContactLaw &law, const NarrowPhase &narrow_phase, const PointMemory &memory,
                                  const Target &target, const std::size_t begin)
  {
    // a list of gathers and one call of the law; the last batch is filled up with copies of the last touch, whose
    // results are never read
    const PointsView                         &points  = target.scene.points;
    const PairGeometry                       &pairs   = narrow_phase.geometry();
    const auto                               &touches = narrow_phase.touches();
    std::array<const TouchingPair *, n_lanes> touched;
    std::array<const PointRecord *, n_lanes>  record;
    std::array<std::uint32_t, n_lanes>        point, place;
    for (std::size_t j = 0; j < n_lanes; ++j)
      {
        touched[j] = &touches[std::min(begin + j, touches.size() - 1)];
        place[j]   = touched[j]->place;
        point[j]   = target.block.points[touched[j]->near];
        record[j]  = &memory.data()[points.id[point[j]]];
      }
    const auto of_touch  = [&](const auto &value) { return Lanes([&](const auto j) { return value(*touched[j]); }); };
    const auto of_record = [&](const auto &value) { return Lanes([&](const auto j) { return value(*record[j]); }); };

    Touch<Lanes> touch;
    touch.penetration = of_touch([](const TouchingPair &t) { return t.penetration; });
    touch.size        = of_record([](const PointRecord &r) { return r.size; });
    touch.density =
      max(gather(points.density, point.data()), of_record([](const PointRecord &r) { return r.density; }));
    touch.sound_speed =
      max(gather(points.sound_speed, point.data()), of_record([](const PointRecord &r) { return r.sound_speed; }));
    touch.reduced_mass =
      Lanes(1.) / (Lanes(1.) / gather(points.mass, point.data()) + gather(pairs.inverse_mass.data(), place.data()));
    for (unsigned int d = 0; d < 3; ++d)
      {
        touch.normal[d]   = of_touch([&](const TouchingPair &t) { return t.normal[d]; });
        touch.velocity[d] = gather(pairs.velocity[d].data(), place.data());
      }
    const auto  force = compute_contact_force(law, touch);
    const Lanes share = of_touch([](const TouchingPair &t) { return t.share; });
    store(share * force.stored_energy, &stored[begin]);
    store(share * force.dissipation_power, &dissipated[begin]);
    for (unsigned int d = 0; d < 3; ++d)
      store(share * force.force[d], &forces[d][begin]);
  }

  void BlockForces::share_out(const NarrowPhase &narrow_phase, const Target &target, const bool has_friction)
  {
    const PairGeometry &pairs  = narrow_phase.geometry();
    const PointsView   &points = target.scene.points;
    BlockReport        &report = target.report;
    report.n_touching          = narrow_phase.touches().size();
    for (std::size_t t = 0; t < report.n_touching; ++t)
      {
        const TouchingPair   &touch = narrow_phase.touches()[t];
        const std::uint32_t   i     = target.block.points[touch.near];
        const auto           &nodes = target.block.facet_nodes[target.block.pair_facet[pairs.pair[touch.place]]];
        const NodeSums::Force force{forces[0][t], forces[1][t], forces[2][t], 0.};
        for (unsigned int d = 0; d < 3; ++d)
          {
            points.force[d][i] += force[d];
            report.force[d] -= force[d];
          }
        for (unsigned int k = 0; k < 4; ++k)
          for (unsigned int d = 0; d < 4; ++d)
            target.node_sums[nodes[k]][d] -= pairs.weight[k][touch.place] * force[d];
        report.stored_energy += stored[t];
        report.dissipation_power += dissipated[t];
        report.penetration = std::max(report.penetration, touch.penetration);
        if (has_friction)
          add_couple(target, touch, pairs, Point3(force[0], force[1], force[2]));
        if (!target.patches.empty())
          add_to_patches(target, touch,
                         Point3(points.position[0][i], points.position[1][i], points.position[2][i]) -
                           pairs.offset_of(touch.place),
                         Point3(force[0], force[1], force[2]));
      }
  }

  void BlockForces::add_couple(const Target &target, const TouchingPair &touch, const PairGeometry &pairs,
                               const Point3 &force)
  {
    // (p - q) x F is left over; forces f_k = w x y_k about the nodes' mean have no sum, and the moment
    // (sum |y|^2 1 - y y^T) w
    const std::uint32_t   facet  = target.block.pair_facet[pairs.pair[touch.place]];
    const Point3          couple = pairs.offset_of(touch.place).cross(force);
    const auto           &nodes  = target.block.facet_nodes[facet];
    std::array<Point3, 4> arms   = facet_nodes(target.scene.facets, target.block.facets.keys()[facet]);
    const Point3          mean   = 0.25 * (arms[0] + arms[1] + arms[2] + arms[3]);
    Matrix3<double>       moment = Matrix3<double>::Zero();
    for (Point3 &arm : arms)
      {
        arm -= mean;
        moment += arm.squaredNorm() * Matrix3<double>::Identity() - arm * arm.transpose();
      }
    const Point3 turn = moment.inverse() * couple;
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int d = 0; d < 3; ++d)
        target.node_sums[nodes[k]][d] -= turn.cross(arms[k])[d];
  }

  void BlockForces::add_to_patches(const Target &target, const TouchingPair &touch, const Point3 &closest,
                                   const Point3 &force)
  {
    for (std::size_t k = 0; k < target.patches.size(); ++k)
      if (const double radius = target.patches[k].radius; (closest - target.patches[k].centre).norm() <= radius)
        target.report.patch_pressures[k] += force.dot(touch.normal) / (std::numbers::pi * radius * radius);
  }
} // namespace birdstrike
