#include "structure/rigid_plate.h"
#include "structure/census.h"
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/orientation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  RigidPlate::RigidPlate(const BladeParameters &parameters)
    : plane(parameters.is_halved)
    , is_free(parameters.rigid.motion == RigidMotion::free_along_normal)
    , plate_mass(parameters.rigid.mass / plane.whole(1.))
  {
    const auto  &n    = parameters.rigid.normal;
    const double norm = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    normal            = {{n[0] / norm, n[1] / norm, n[2] / norm}};
    if (parameters.rigid.surface == RigidSurface::mesh)
      take_mesh(ShellMesh(parameters));
    else
      take_mesh(make_rectangle(parameters.rigid));
    half_thickness.assign(surface.cells.size(), parameters.rigid.half_thickness);
    if (parameters.bird)
      is_turned = looks_at_strike(Point3(normal[0], normal[1], normal[2]), Point3(parameters.bird->velocity.data()));
  }

  SurfaceMesh RigidPlate::make_rectangle(const BladeParameters::Rigid &parameters) const
  {
    const Point3 n(normal[0], normal[1], normal[2]);
    // The first in-plane direction is the global axis that is least aligned with the normal, made tangent: x for n = z.
    Point3 axis = Point3::UnitX();
    if (std::abs(n[0]) > std::abs(n[1]))
      axis = Point3::UnitY();
    const Point3 along  = 0.5 * parameters.length * (axis - axis.dot(n) * n).normalized();
    const Point3 across = 0.5 * parameters.width * n.cross(along).normalized();
    const Point3 centre(parameters.centre[0], parameters.centre[1], parameters.centre[2]);
    SurfaceMesh  mesh;
    for (const Point3 &p : {Point3(centre - along - across), Point3(centre + along - across),
                            Point3(centre + along + across), Point3(centre - along + across)})
      mesh.nodes.push_back({{p[0], plane.exists() && p[1] < 1e-6 * parameters.length ? 0. : p[1], p[2]}});
    mesh.cells        = {{{0, 1, 2, 3}}};
    mesh.neighbors    = {{{-1, -1, -1, -1}}};
    mesh.material_ids = {0};
    for (unsigned int side = 0; side < 4; ++side)
      mesh.boundary.push_back({0, side, mesh.side_nodes(0, side), 0});
    if (plane.exists())
      mesh.cut_at_symmetry_plane();
    return mesh;
  }

  void RigidPlate::take_mesh(SurfaceMesh mesh)
  {
    surface = std::move(mesh);
    for (const auto &node : surface.nodes)
      reference.insert(reference.end(), node.begin(), node.end());
    position = reference;
    velocity.assign(reference.size(), 0.);
    force.assign(reference.size(), 0.);
    inverse_mass.assign(surface.nodes.size(), is_free ? static_cast<double>(surface.nodes.size()) / plate_mass : 0.);
  }

  BladeKind RigidPlate::kind() const
  {
    return BladeKind::rigid;
  }

  bool RigidPlate::is_deformable() const
  {
    return false;
  }

  StepLimit RigidPlate::step_limit() const
  {
    return {std::numeric_limits<double>::infinity(), "rigid surface", {}};
  }

  void RigidPlate::kick_internal(double, HalfKick)
  {
  }

  void RigidPlate::kick_contact(const double half_step, const HalfKick half)
  {
    const Point3 total  = total_force();
    const double along  = total[0] * normal[0] + total[1] * normal[1] + total[2] * normal[2];
    const double before = normal_speed;
    if (is_free && half == HalfKick::first && half_step != last_half)
      energy.staggering += 0.5 * along * along * (half_step * half_step - last_half * last_half) / plate_mass;
    last_half = half_step;
    if (is_free)
      normal_speed += half_step * along / plate_mass;
    energy.contact_work += half_step * along * (half == HalfKick::first ? normal_speed : before);
    for (unsigned int d = 0; d < 3; ++d)
      {
        momentum.contact_impulse[d] += half_step * total[d];
        momentum.support_impulse[d] += half_step * (total[d] - (is_free ? along * normal[d] : 0.));
      }
    Point3 moment = centre().cross(
      Point3(is_free ? -along * normal[0] : 0., is_free ? -along * normal[1] : 0., is_free ? -along * normal[2] : 0.));
    for (std::size_t i = 0; i < position.size(); i += 3)
      moment += Point3(&position[i]).cross(Point3(&force[i]));
    for (unsigned int d = 0; d < 3; ++d)
      momentum.support_moment[d] += half_step * moment[d];
    move();
    second_impulse = half == HalfKick::first ? 0. : half_step * along;
  }

  void RigidPlate::drift(const double step)
  {
    if (!is_free)
      return;
    displacement += step * normal_speed;
    move();
  }

  void RigidPlate::move()
  {
    for (std::size_t i = 0; i < position.size(); ++i)
      {
        position[i] = reference[i] + displacement * normal[i % 3];
        velocity[i] = normal_speed * normal[i % 3];
      }
  }

  void RigidPlate::archive(Archive &archive)
  {
    const auto group = archive.group("plate");
    archive("displacement", displacement);
    archive("speed", normal_speed);
    archive("last second impulse", second_impulse);
    archive("last half step", last_half);
    archive.entities("nodes", surface.nodes.size(), [this](Archive::Row &row, const std::size_t n) {
      row("contact force", force[3 * n], force[3 * n + 1], force[3 * n + 2]);
    });
    birdstrike::archive(archive, "energy", energy);
    birdstrike::archive(archive, "momentum", momentum);
    if (archive.is_reading())
      move();
  }

  void RigidPlate::compute_internal_forces()
  {
  }

  NodeForces RigidPlate::clear_contact_forces()
  {
    std::fill(force.begin(), force.end(), 0.);
    return {force.data(), 3};
  }

  FacetsView RigidPlate::facets() const
  {
    FacetsView view;
    view.n_nodes         = surface.nodes.size();
    view.position        = position.data();
    view.velocity        = velocity.data();
    view.inverse_mass    = inverse_mass.data();
    view.velocity_stride = 3;
    view.n_facets        = surface.cells.size();
    view.nodes           = surface.cells.data();
    view.neighbor        = surface.neighbors.data();
    view.half_thickness  = half_thickness.data();
    view.plane           = plane;
    return view;
  }

  Point3 RigidPlate::total_force() const
  {
    Point3 total = Point3::Zero();
    for (std::size_t i = 0; i < force.size(); ++i)
      total[i % 3] += force[i];
    return total;
  }

  std::array<double, 3> RigidPlate::contact_force() const
  {
    const Point3 total = total_force();
    return plane.whole(std::array<double, 3>{{total[0], total[1], total[2]}});
  }

  EnergyReport RigidPlate::energies() const
  {
    EnergyReport report = energy;
    if (is_free)
      {
        report.kinetic = 0.5 * plate_mass * normal_speed * normal_speed;
        report.staggering -= 0.5 * second_impulse * second_impulse / plate_mass;
      }
    return plane.whole(report);
  }

  MomentumReport RigidPlate::momenta() const
  {
    MomentumReport report  = momentum;
    const Point3   carried = (is_free ? plate_mass * normal_speed : 0.) * Point3(normal[0], normal[1], normal[2]);
    const Point3   angular = centre().cross(carried);
    report.moment_scale    = centre().norm() * carried.norm();
    report.impulse_scale   = carried.norm();
    for (unsigned int d = 0; d < 3; ++d)
      {
        report.momentum[d]         = carried[d];
        report.angular_momentum[d] = angular[d];
      }
    return plane.whole(report);
  }

  Point3 RigidPlate::centre() const
  {
    Point3 mean = Point3::Zero();
    for (std::size_t i = 0; i < position.size(); ++i)
      mean[i % 3] += position[i] * 3. / position.size();
    return mean;
  }

  std::size_t RigidPlate::n_elements() const
  {
    return plane.whole(surface.cells.size());
  }

  std::size_t RigidPlate::n_nodes() const
  {
    return plane.whole(surface.nodes.size(), surface.symmetry_nodes.size());
  }

  double RigidPlate::mass() const
  {
    return is_free ? plane.whole(plate_mass) : std::numeric_limits<double>::infinity();
  }

  double RigidPlate::speed() const
  {
    return normal_speed;
  }

  BladeCensus RigidPlate::census() const
  {
    BladeCensus census = compute_census(surface);
    census.n_elements  = n_elements();
    census.n_nodes     = n_nodes();
    census.area        = plane.whole(census.area);
    census.mass        = mass();
    census.bytes       = 8. * 13. * surface.nodes.size() + 40. * surface.cells.size();
    return census;
  }

  FieldSnapshot RigidPlate::snapshot() const
  {
    FieldSnapshot snapshot;
    snapshot.dim    = 2;
    snapshot.points = reference;
    for (const auto &c : surface.cells)
      snapshot.cells.insert(snapshot.cells.end(), {c[0], c[1], c[3], c[2]});
    Field moved{"displacement", "m", false, 3, {}};
    for (std::size_t i = 0; i < position.size(); ++i)
      moved.values.push_back(displacement * normal[i % 3]);
    snapshot.fields = {moved, {"velocity", "m/s", false, 3, velocity}};
    return snapshot;
  }

  std::vector<ProbeValues> RigidPlate::probes() const
  {
    return {};
  }

  RootSectionReport RigidPlate::root_section() const
  {
    return {};
  }

  TipDeflection RigidPlate::tip_deflection() const
  {
    const double along = is_turned ? -displacement : displacement;
    return {along, along, along};
  }

  std::vector<PeakPlasticStrain> RigidPlate::peak_plastic_strains() const
  {
    return {};
  }
} // namespace birdstrike
