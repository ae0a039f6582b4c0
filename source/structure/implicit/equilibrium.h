#pragma once

#include "structure/implicit/stencil.h"
#include "structure/nodes/nodal_mechanics.h"
#include <birdstrike/core/step_limit.h>
#include <birdstrike/structure/rotor.h>

#include <memory>

namespace birdstrike
{
  /// Forces on the free unknowns of a blade of finite elements at rest in the frame that turns with its hub,
  ///
  ///   r(s) = f_elements(s) + lambda (f_loads(x) + m w^2 (x - c)_across),
  ///
  /// for a step s since the last accepted state: the increment of the explicit loop, taken by the same elements and
  /// section laws in one piece and in a time so long that no rate matters. Every call starts from the accepted state.
  /// Loads and speed are those of t = 0, as if they had been so for ever. Rotary inertia of nodes is isotropic, so that
  /// their rotation is free of moments.
  class Equilibrium
  {
  public:
    virtual ~Equilibrium() = default;

    const FreeUnknowns &unknowns() const
    {
      return *free;
    }
    /// Pressures, whose tangent is not symmetric at free edges.
    bool has_following_loads() const
    {
      return follows;
    }
    void set_load_factor(const double factor)
    {
      load_factor = factor;
    }
    /// N and N m, [n]; `step` in m and rad. Throws NumericalFailure for a step that turns an element inside out.
    virtual void compute_forces(std::span<const double> step, std::vector<double> &forces) = 0;
    /// -dr/ds, with the softening by spin, the stiffness of stresses and of following loads, consistent with the
    /// section laws: central differences of r, whose columns of one colour are found together (Curtis, Powell & Reid
    /// 1974). Throws NumericalFailure where an entry is no number.
    SparseRows compute_tangent(std::span<const double> step);
    /// Of the accepted state, without flow: of vibrations about a state that has yielded, where a metal unloads.
    virtual SparseRows compute_elastic_tangent() = 0;
    /// The state after this step is where the next one begins.
    virtual void accept(std::span<const double> step) = 0;
    /// Of loads and spin at the full factor, at the accepted state: norm of the forces on the unknowns.
    virtual double load_norm() = 0;
    /// kg and kg m^2, [n].
    virtual std::vector<double> masses() const = 0;
    /// What the body's rigid motions from the position of the last forces make of the unknowns, [6][n]: translations
    /// (1), rotations (1 rad) about the centre of the nodes.
    virtual std::vector<std::vector<double>> rigid_motions() const = 0;
    /// For one vector of the unknowns, nodal values [n_nodes][3] of displacements.
    std::vector<double> nodal_displacements(std::span<const double> values) const;

  protected:
    virtual EntityPlace place_of(std::uint32_t node) const = 0;

    std::unique_ptr<FreeUnknowns> free;
    NodeLists                     reach;      ///< nodes on which a node's motion makes forces
    std::vector<std::uint32_t>    colour;     ///< of its nodes
    std::vector<double>           difference; ///< m, [n_nodes]: what displacements are varied by
    double                        load_factor = 1.;
    bool                          follows     = false;

  private:
    void require_numbers(const SparseRows &tangent) const; ///< throws NumericalFailure, with the node
  };

  template <unsigned int n_unknowns>
  class BladeEquilibrium final : public Equilibrium
  {
  public:
    using Motion   = NodalMechanics<n_unknowns>;
    using Elements = typename Motion::Elements;

    /// `held` are the unknowns that do not move in the turning frame, driven ones among them.
    BladeEquilibrium(const typename Motion::Mesh &mesh, Motion &motion, Elements &elements,
                     std::span<const std::uint32_t> held, const Rotor &rotor);
    ~BladeEquilibrium() override; ///< leaves motion and elements in the accepted state, whatever was tried

    void                             compute_forces(std::span<const double> step, std::vector<double> &forces) override;
    void                             accept(std::span<const double> step) override;
    SparseRows                       compute_elastic_tangent() override;
    double                           load_norm() override;
    std::vector<double>              masses() const override;
    std::vector<std::vector<double>> rigid_motions() const override;

  protected:
    EntityPlace place_of(std::uint32_t node) const override;

  private:
    void find_unknowns();
    void move(std::span<const double> step);
    void add_loads(double factor, std::vector<double> &nodal) const;

    Motion             &motion;
    Elements           &elements;
    Rotor               rotor;
    std::vector<bool>   is_held;
    std::vector<double> accepted; ///< [n_nodes][n_unknowns], displacements
    std::vector<double> nodal, increment;

    std::shared_ptr<const typename Elements::Saved> saved;
  };
} // namespace birdstrike
