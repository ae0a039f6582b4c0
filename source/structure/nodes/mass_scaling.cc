#include "structure/nodes/mass_scaling.h"

#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstdio>

namespace birdstrike
{
  namespace
  {
    /// Of the step that infinite inertia through the thickness allows: 0.99 would add three times as much.
    constexpr double reach_share = 0.95;

    using Inertia = Matrix3<double>;

    Inertia inertia_of(const double mass, const Point3 &r)
    {
      return mass * (r.squaredNorm() * Inertia::Identity() - r * r.transpose());
    }

    std::string text(const double value)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.4g", value);
      return buffer;
    }

    /// Factors for steps, and what they add.
    class Scaler
    {
    public:
      Scaler(const VolumeMesh &mesh, const NodeColumns &columns, const SolidElements &elements, const bool is_halved,
             const std::span<const double> nodal_mass)
        : mesh(mesh), columns(columns), elements(elements), is_halved(is_halved)
      {
        const std::size_t n_owned = mesh.space.n_owned();
        double            mass    = 0.;
        Point3            centre  = Point3::Zero();
        for (std::size_t n = 0; n < n_owned; ++n)
          {
            mass += nodal_mass[n];
            centre += nodal_mass[n] * mesh.node(n);
          }
        centre /= mass;
        if (is_halved)
          centre[1] = 0.;
        own = Inertia::Zero();
        for (std::size_t n = 0; n < n_owned; ++n)
          own += inertia_of(nodal_mass[n], mesh.node(n) - centre);
        mirror(own);
      }

      MassScaling scale_to(const double step) const
      {
        MassScaling result;
        result.coupling.assign(columns.nodes.size(), 0.);
        const std::vector<double> factors = elements.compute_mass_factors(columns.axis, step);
        for (std::size_t e = 0; e < factors.size(); ++e)
          {
            result.scale.push_back({columns.axis[e], factors[e]});
            for (unsigned int edge = 0; edge < 4; ++edge)
              result.coupling[columns.edge_place(mesh, e, edge)] += 0.5 * (factors[e] - 1.) * elements.edge_mass(e);
            result.report.n_scaled += mesh.is_owned(e) && factors[e] > 1.;
            result.report.largest_factor = std::max(result.report.largest_factor, factors[e]);
          }
        result.report.step                 = step;
        result.report.added_rotary_inertia = added_share(result.coupling);
        return result;
      }

    private:
      double added_share(const std::vector<double> &coupling) const
      {
        Inertia added = Inertia::Zero();
        for (std::size_t p = 0; p < coupling.size(); ++p)
          if (coupling[p] > 0. && mesh.space.is_owned(columns.nodes[p]))
            added += inertia_of(coupling[p], mesh.node(columns.nodes[p + 1]) - mesh.node(columns.nodes[p]));
        mirror(added);
        return Eigen::GeneralizedSelfAdjointEigenSolver<Inertia>(added, own, Eigen::EigenvaluesOnly).eigenvalues()[2];
      }

      /// With the other half of a symmetric blade, products with y vanish (and all else doubles, which cancels).
      void mirror(Inertia &inertia) const
      {
        if (is_halved)
          inertia(0, 1) = inertia(1, 0) = inertia(1, 2) = inertia(2, 1) = 0.;
      }

      const VolumeMesh    &mesh;
      const NodeColumns   &columns;
      const SolidElements &elements;
      bool                 is_halved;
      Inertia              own;
    };

    /// The longest step of [step, longest] that adds no more than allowed.
    MassScaling scale_within(const Scaler &scaler, double step, double longest, const double allowed)
    {
      MassScaling best = scaler.scale_to(longest);
      if (best.report.added_rotary_inertia <= allowed)
        return best;
      best = scaler.scale_to(step);
      for (unsigned int k = 0; k < 10; ++k)
        {
          const double middle = 0.5 * (step + longest);
          MassScaling  trial  = scaler.scale_to(middle);
          if (trial.report.added_rotary_inertia <= allowed)
            {
              step = middle;
              best = std::move(trial);
            }
          else
            longest = middle;
        }
      return best;
    }
  } // namespace

  void declare_mass_scaling(dealii::ParameterHandler &prm, BladeParameters::MassScaling &p)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Mass scaling");
    declare_choice(prm, "Method", p.method, mass_scaling_methods(),
                   "Mass scaling of solids. selective: solids in thin layers take the time step of their in-plane "
                   "dimensions. In return the lines of nodes through the thickness get more inertia against rotation "
                   "and stretching. Mass and momentum stay exact. [-]");
    prm.add_parameter(
      "Largest added inertia", p.largest_added,
      "Largest moment of inertia that selective scaling may add to the blade about its slenderest axis, as a share of "
      "it. The frequency of the first torsion mode falls by about half of this share. [-]",
      Double(0., 10.));
    prm.add_parameter("Target step", p.target_step,
                      "Stable step that selective scaling must reach, before Time/Step scale. 0: 0.95 of the step that "
                      "the in-plane dimensions allow, or less if Largest added inertia demands it. [s]",
                      Double(0.));
    prm.leave_subsection();
  }

  MassScaling choose_mass_scaling(const BladeParameters &parameters, const VolumeMesh &mesh, const NodeColumns &columns,
                                  const SolidElements &elements, const std::span<const double> nodal_mass)
  {
    const double allowed = parameters.mass_scaling.largest_added, target = parameters.mass_scaling.target_step;
    const double before = elements.largest_stable_step(), reach = elements.compute_reachable_step(columns.axis);
    const double longest = std::max(before, reach_share * reach);
    if (target > reach)
      throw InputError("Blade/Mass scaling/Target step: " + text(target) +
                       " s, but the dimensions in the plane allow " + text(reach) + " s at most.\nAllowed: up to " +
                       text(longest) + " s with reason, or 0 for the longest that is accurate enough.");
    const Scaler scaler(mesh, columns, elements, parameters.is_halved, nodal_mass);
    MassScaling  scaling =
      target > 0. ? scaler.scale_to(std::max(target, before)) : scale_within(scaler, before, longest, allowed);
    if (const double added = scaling.report.added_rotary_inertia; added > allowed)
      throw InputError("Blade/Mass scaling/Target step: " + text(target) + " s adds " + text(added) +
                       " of the blade's rotary inertia; Largest added inertia is " + text(allowed) +
                       ".\nAllowed: up to " +
                       text(scale_within(scaler, before, std::min(longest, target), allowed).report.step) +
                       " s, or raise that entry.");
    scaling.report.step_before = before;
    return scaling;
  }
} // namespace birdstrike
