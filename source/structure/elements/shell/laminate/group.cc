#include "structure/elements/shell/group.h"
#include "structure/elements/shell/laminate/bound.h"
#include "structure/elements/shell/laminate/failure.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/simd/flatten.h>

#include <algorithm>
#include <cmath>

// What groups of laminated shells hold and do besides their loops.
namespace birdstrike
{
  namespace
  {
    /// cos and sin of the first axis in the frame of an element.
    std::array<double, 2> place_axes(const Laminate &law, const ShellGeometry<double> &g, const EntityPlace &where)
    {
      const double c = law.reference.dot(g.compute_e1()), s = law.reference.dot(g.compute_e2());
      const double length = std::hypot(c, s), least = 0.02;
      if (!(length > least * law.reference.norm()))
        throw InputError(
          "Shell " + where.text() +
          ": the laminate's Reference direction is normal to the element, so that the angles of its plies are "
          "undefined there.\nTurn Laminate/Reference direction, or give these cells a section with one of their own.");
      return {{c / length, s / length}};
    }

    LaminateElement<double> make_element(const Laminate &law, const ShellGeometry<double> &g,
                                         const std::array<double, 2> &axes, const ShellFormulation formulation)
    {
      const double c = axes[0], s = axes[1];
      // a1, a2 and the contravariant base, which is normal to the other one, in the frame of the element
      const std::array<double, 2> along[2]  = {{{g.c2y, -g.c2x}}, {{-g.c1y, g.c1x}}},
                                  across[2] = {{{g.c1x, g.c1y}}, {{g.c2x, g.c2y}}};
      LaminateElement<double> result{};
      for (int d = 0; d < 2; ++d)
        {
          const auto turned = [&](const std::array<double, 2> &v) {
            const double length = std::hypot(v[0], v[1]);
            return std::array<double, 2>{{(c * v[0] + s * v[1]) / length, (c * v[1] - s * v[0]) / length}};
          };
          result.first[d]     = across[d][0] * c + across[d][1] * s;
          result.second[d]    = across[d][1] * c - across[d][0] * s;
          const bool is_plain = formulation == ShellFormulation::belytschko_tsay; // along e1 and e2, shear of w
          const auto own      = turned(is_plain ? std::array<double, 2>{{1. - d, double(d)}} : along[d]);
          const auto beam     = law.beam(own[0], own[1]);
          const auto uniaxial = law.uniaxial(own[0], own[1]);
          const auto normal   = turned(across[d]);
          result.membrane[d]  = formulation == ShellFormulation::fully_integrated ? uniaxial.modulus : beam.membrane;
          result.coupling[d]  = is_plain ? 0. : beam.coupling;
          result.bending[d]   = beam.bending;
          result.shear[d]     = is_plain ? 0.5 * (law.shear[0] + law.shear[1]) : law.shear_along(normal[0], normal[1]);
          result.lateral[d]   = uniaxial.lateral;
          result.skew[d]      = uniaxial.shear;
        }
      return result;
    }

    LaminateElement<double> in_lane(const LaminateElement<Lanes> &elements, const std::size_t k)
    {
      LaminateElement<double> result;
      for_pairs(result, elements, [k](double &value, const Lanes &lanes) { value = lane(lanes, k); });
      return result;
    }
  } // namespace

  void ShellGroup::build_laminate()
  {
    laminate.emplace(section.laminate, batches.size(), n_in_plane);
    for (std::size_t slot = 0; slot < batches.size() * n_lanes; ++slot)
      {
        const std::size_t             e = element_of(slot), b = slot / n_lanes, k = slot % n_lanes;
        const ShellGeometry<double>   g = geometry(e);
        const LaminateElement<double> of =
          make_element(*section.laminate, g, place_axes(*section.laminate, g, where(e)), section.formulation);
        for_pairs(laminate->elements[b], of, [k](Lanes &lanes, const double value) { lanes[k] = value; });
      }
  }

  double ShellGroup::laminate_bound(const std::size_t e, const ShellGeometry<double> &g) const
  {
    const Laminate            &plies = *section.laminate;
    const auto                 of    = in_lane(laminate->elements[e / n_lanes], e % n_lanes);
    const ShellBatch          &batch = batches[e / n_lanes];
    const LaminateAxes<double> axes(g, of);
    const double               t = largest_thickness(e), inverse_mass = lane(batch.inverse_mass, e % n_lanes),
                 radius2 = lane(batch.radius2, e % n_lanes);
    return n_in_plane == 1 ? compute_laminate_bound<false>(g, t, inverse_mass, radius2, plies, of, axes, 1.)
                           : compute_laminate_bound<true>(g, t, inverse_mass, radius2, plies, of, axes, 1.);
  }

  // States have the strains of after the step and the stresses of before.
  BIRDSTRIKE_FLATTEN [[gnu::noinline]] void ShellGroup::update_failing_plies(const std::size_t           b,
                                                                             const LaminateState<Lanes> *old,
                                                                             const Lanes *volume, const double dt)
  {
    const Laminate &law = *laminate->law;
    // a static solve's steps are longer than any such time
    const double growth = dt < law.degradation_time ? dt / law.degradation_time : 1.;
    const Lanes  zero   = 0.;
    Lanes        failed = zero, carries = zero, grown = zero; // failed: of the thickness
    bool         has_damage = false;
    for (std::size_t i = 0; i < n_in_plane; ++i)
      {
        const std::size_t     k      = n_in_plane * b + i;
        LaminateState<Lanes> &state  = laminate->states[k];
        auto                 &damage = laminate->damage[k];
        if (damage.empty() && !begins_to_fail(law, state))
          {
            update_laminate_stress(law, state);
            carries += 1.;
            continue;
          }
        if (damage.empty())
          {
            damage.resize(law.layers.size(), PlyDamage<Lanes>{{zero, zero, zero, zero}});
            erosion->damage[k].resize(law.layers.size(), zero);
          }
        const auto step = birdstrike::update_failing_plies(law, growth, state, damage.data());
        for (std::size_t p = 0; p < damage.size(); ++p)
          erosion->damage[k][p] = damage[p].fibre();
        failed += step.broken;
        carries += step.carries;
        grown += step.growth;
        has_damage = true;
      }
    if (has_damage)
      {
        const double rounding = 1e-9, needed = std::max(law.failed_share - rounding, rounding);
        release_plies(b, old, volume, failed >= Lanes(double(n_in_plane) * needed), grown > zero, carries);
      }
  }

  // `fails`: the element does; `grows`: something has gone in this step.
  [[gnu::noinline]] void ShellGroup::release_plies(const std::size_t b, const LaminateState<Lanes> *old,
                                                   const Lanes *volume, const LanesMask &fails, const LanesMask &grows,
                                                   const Lanes &carries)
  {
    const Lanes zero   = 0.;
    Lanes       energy = zero;
    for (std::size_t i = 0; i < n_in_plane; ++i)
      {
        LaminateState<Lanes> &state = laminate->states[n_in_plane * b + i];
        for (Lanes &s : state.stress)
          s = select(fails, zero, s);
        energy += select(fails || grows, Lanes(volume[i] * released_energy(old[i], state)), zero);
        for (Lanes &e : state.strain)
          e = select(fails, zero, e);
      }
    const Lanes least    = ShellSectionLaw::smallest_tangent;
    laminate->carries[b] = select(fails, zero, max(least, Lanes((1. / double(n_in_plane)) * carries)));
    erosion->book(b, n_elements_of(b), fails, energy);
  }

  void ShellGroup::release_collapsed_laminate(const std::size_t b, const LanesMask &fails, Lanes &energy)
  {
    const Lanes zero = 0.;
    for (std::size_t i = n_in_plane * b; i < n_in_plane * (b + 1); ++i)
      {
        LaminateState<Lanes> &state = laminate->states[i];
        energy += select(fails, laminate_energy(state), zero);
        for (Lanes *values : {state.strain, state.stress})
          for (int c = 0; c < n_laminate_strains; ++c)
            values[c] = select(fails, zero, values[c]);
      }
    laminate->carries[b] = select(fails, zero, laminate->carries[b]);
    if (n_in_plane > 1)
      return;
    for (int c = 0; c < 2; ++c)
      for (Lanes *s : {&stress[b].linear_membrane[c], &stress[b].linear_curvature[c], &stress[b].linear_shear[c]})
        *s = select(fails, zero, *s);
  }

  Point3 ShellGroup::ply_stress(const std::size_t e, const std::size_t k, const double height) const
  {
    const Laminate        &law   = *laminate->law;
    const Laminate::Layer &layer = law.at(height);
    const std::size_t      at = n_in_plane * (e / n_lanes) + k, number = &layer - law.layers.data();
    LaminateState<double>  state;
    PlyDamage<double>      damage{{0., 0., 0., 0.}};
    for (int c = 0; c < n_laminate_strains; ++c)
      state.strain[c] = lane(laminate->states[at].strain[c], e % n_lanes);
    if (!laminate->damage[at].empty())
      for (int m = 0; m < PlyDamage<double>::n_modes; ++m)
        damage.mode[m] = lane(laminate->damage[at][number].mode[m], e % n_lanes);
    double strain[3], own[3], turned[3], result[3];
    compute_ply_strain(layer, height, state.strain, strain);
    PlyStiffness<double>(law.of(layer).ply, 1. - damage.fibre(), 1. - damage.matrix()).compute_stress(strain, own);
    LaminateAxes<double> axes(geometry(e), in_lane(laminate->elements[e / n_lanes], e % n_lanes)), of_layer = axes;
    of_layer.c = layer.cos;
    of_layer.s = layer.sin;
    of_layer.turn_stress(own, 1., turned);
    axes.turn_stress(turned, 1., result);
    return {result[0], result[1], result[2]};
  }

  std::array<double, PlyDamage<double>::n_modes> ShellGroup::failed_shares(const std::size_t e) const
  {
    std::array<double, PlyDamage<double>::n_modes> shares{};
    for (std::size_t i = 0; laminate && i < n_in_plane; ++i)
      {
        const auto &damage = laminate->damage[n_in_plane * (e / n_lanes) + i];
        for (std::size_t p = 0; p < damage.size(); ++p)
          for (int m = 0; m < PlyDamage<double>::n_modes; ++m)
            if (lane(damage[p].mode[m], e % n_lanes) > 0.)
              shares[m] += laminate->law->layers[p].share() / double(n_in_plane);
      }
    return shares;
  }

  std::array<double, 2> ShellGroup::failed_ply_shares(const std::size_t e) const
  {
    std::array<double, 2> shares{};
    for (std::size_t i = 0; laminate && i < n_in_plane; ++i)
      {
        const auto &damage = laminate->damage[n_in_plane * (e / n_lanes) + i];
        for (std::size_t p = 0; p < damage.size(); ++p)
          {
            const Laminate        &law   = *laminate->law;
            const Laminate::Layer &layer = law.layers[p];
            const double share = layer.share() * (law.of(layer).ply.density / law.density) / double(n_in_plane);
            if (lane(damage[p].fibre(), e % n_lanes) > 0.)
              shares[0] += share;
            else if (lane(damage[p].matrix(), e % n_lanes) > 0.)
              shares[1] += share;
          }
      }
    return shares;
  }

  void ShellGroup::archive_laminate(Archive &archive)
  {
    const auto of_plies = archive.group("laminate");
    archive.entities("sections", ids(n_in_plane), [&](Archive::Row &row, const std::size_t number) {
      const std::size_t     e       = number / n_in_plane;
      LaminateState<Lanes> &state   = laminate->states[n_in_plane * (e / n_lanes) + number % n_in_plane];
      const auto            in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      for (const auto &[name, of] : {std::pair("strain", state.strain), std::pair("stress", state.stress)})
        row(name, in_lane(of[0]), in_lane(of[1]), in_lane(of[2]), in_lane(of[3]), in_lane(of[4]), in_lane(of[5]),
            in_lane(of[6]), in_lane(of[7]));
    });
    archive.entities("elements", ids(1), [&](Archive::Row &row, const std::size_t e) {
      row("carries", lane_of(laminate->carries[e / n_lanes], e));
    });
    if (erosion)
      archive_plies(archive);
  }

  /// Number n_layers section + k, of sections that have some that fail.
  void ShellGroup::archive_plies(Archive &archive)
  {
    const std::size_t          n_layers = laminate->law->layers.size();
    std::vector<std::uint64_t> ply_ids;
    for (std::size_t e = 0; e < n_elements(); ++e)
      for (std::size_t s = 0; s < n_in_plane; ++s)
        for (std::size_t k = 0; k < laminate->damage[n_in_plane * (e / n_lanes) + s].size(); ++k)
          ply_ids.push_back(n_layers * (std::uint64_t(n_in_plane) * place.number[e] + s) + k);
    archive.population("plies", ply_ids);
    archive.rows("plies", ply_ids.size(), [&](Archive::Row &row, const std::size_t i) {
      const std::uint64_t section_id = ply_ids[i] / n_layers;
      const std::size_t   e = find(section_id / n_in_plane), k = ply_ids[i] % n_layers;
      const std::size_t   at     = n_in_plane * (e / n_lanes) + section_id % n_in_plane;
      auto               &damage = laminate->damage[at];
      if (damage.empty())
        {
          const Lanes zero = 0.;
          damage.resize(n_layers, PlyDamage<Lanes>{{zero, zero, zero, zero}});
          erosion->damage[at].resize(n_layers, zero);
        }
      auto &mode = damage[k].mode;
      row("modes", lane_of(mode[0], e), lane_of(mode[1], e), lane_of(mode[2], e), lane_of(mode[3], e));
      row("fibres", lane_of(erosion->damage[at][k], e));
    });
  }
} // namespace birdstrike
