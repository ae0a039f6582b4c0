#pragma once

#include "structure/elements/elements.h"
#include "structure/elements/solid/corner_volume.h"
#include "structure/elements/solid/erosion.h"
#include "structure/elements/solid/layers.h"
#include "structure/elements/solid/nodes.h"
#include "structure/elements/solid/step_bound.h"

namespace birdstrike
{
  struct SolidBatch : ElementBatch<8>
  {
    Lanes rest_det;         ///< m^3, 64 times the undeformed volume
    Lanes viscous_pressure; ///< Pa
    Lanes undistorted;      ///< up to which no corner lacks volume, see corner_volume.h
    Lanes corner_energy;    ///< J, stored there
  };

  /// Force (N) on a corner or a node; the fourth number is zero.
  struct alignas(32) SolidForce
  {
    double value[4];
  };

  /// A face of a cell: across an axis of its reference cube, where the coordinate is -1 or 1.
  struct SolidFace
  {
    unsigned int axis;
    double       side;
  };

  /// What the points nearest to a face carry.
  struct SolidStrength
  {
    double stress = 0., plastic_strain = 0.; ///< von Mises', Pa (Cauchy), and the equivalent one, -
  };

  /// Bricks of one section: their state and kernels.
  class SolidGroup : public ElementGroup<SolidBatch, SolidRecord, SolidForce, SolidErosion>
  {
  public:
    using Section                               = SolidSection;
    using Extra                                 = std::uint8_t; ///< axis of the mesh's cell that is the thickness, or 2
    using Nodes                                 = SolidNodes;
    using Stabilisation                         = one_point_solid::Stabilisation<Lanes>;
    using LayerPoint                            = solid_shell::LayerPoint<Lanes>;
    static constexpr unsigned int n_unknowns    = 3;
    static constexpr double       largest_share = std::numeric_limits<double>::infinity();
    static constexpr const char  *names = "Solid elements", *reason = "solid element, largest eigenvalue";

    SolidGroup(const SolidSection &section, Place place, const std::vector<std::uint8_t> &thickness_axis,
               const ElementBlocks &blocks);

    static double step_of(const double bound) ///< s
    {
      return 2. / bound;
    }

    void update_chunk(std::size_t chunk, double dt);
    void update_bounds_at_rest();
    void archive(Archive &archive); ///< stresses, and what failure needs of them
    void take_up_positions();       ///< those of the nodes as they have been read
    auto changing()                 ///< see Elements::save
    {
      return std::tuple_cat(ElementGroup::changing(), std::tie(points, layers, stabilisation));
    }

    void suspend_flow(bool is_suspended); ///< see Elements::suspend_flow

    bool                has_points(std::size_t batch) const;
    std::size_t         count_yielded(std::size_t batch) const; ///< at an outer layer; all of what has points anyway
    double              largest_plastic_strain(std::size_t element) const;
    StoredEnergy::State stored(std::size_t point) const; ///< of one of `points`, or an element of one point
    std::size_t         bytes() const;

    std::size_t        n_points() const;                                            ///< of an element
    unsigned int       axis_in_batch(std::size_t element, unsigned int axis) const; ///< of an axis of the mesh's cell
    SolidModes<double> modes(std::size_t element) const;                            ///< of its geometry
    Lanes              compute_frequency_at_rest(std::size_t batch, const MassFactors<Lanes> &factors) const;
    std::array<double, 6> point_stress(std::size_t element, std::size_t point) const;         ///< Kirchhoff's
    double                compute_volume_ratio(std::size_t element, std::size_t point) const; ///< J there
    /// At natural coordinates of the mesh's cell, of one point and of solid-shells.
    std::array<double, 6> stabilised_stress(std::size_t element, const std::array<double, 3> &xi) const;
    std::array<double, 6> stress_at(std::size_t element, const std::array<double, 3> &xi) const; ///< of all, Cauchy's
    one_point_solid::Stabilisation<double> take_stabilisation(std::size_t element) const;
    /// Of each point its von Mises stress as its flow counts it, which in flow has rate, heat and its own plastic
    /// strain in it, or the static flow stress where that is more. The points: of B-bar the four next to the face,
    /// mean; the only one of one-point bricks, with what varies; of solid-shells the outermost layer, across another
    /// axis the mean of all.
    SolidStrength compute_strength(std::size_t element, const SolidFace &face) const;
    Point3        compute_normal(std::size_t element, const SolidFace &face) const; ///< at its middle, either way

    SolidSection                           section;
    AlignedVector<MassFactors<Lanes>>      mass_factors; ///< [n_batches] with scaled masses, else none
    AlignedVector<SolidPoint<Lanes>>       points;       ///< [n_batches][n_points]
    std::vector<AlignedVector<LayerPoint>> layers;       ///< [n_batches] of solid-shells, empty while elastic

  private:
    using Corners = Vector3<Lanes>[8];
    /// What the end of a step takes from its strains.
    struct Step
    {
      Lanes midpoint_volume; ///< m^3
      Lanes stiff_det;       ///< m^3, 64 times the volume that the moduli belong to
      Lanes dilatation;      ///< trace of the mean strain increment
      Lanes drag, pressure;  ///< of the bulk viscosity, m^2/s and Pa
      Lanes plastic;         ///< J, plastic work
    };

    void archive_layers(Archive &archive);
    void archive_ledger(Archive &archive);
    void promote(std::size_t batch); ///< gives it layers
    void check_shape(std::size_t element);
    void build_points();
    void update_viscosity(const SolidGeometry<Lanes> &midpoint, const Matrix3<Lanes> &gradient, double dt, Step &step);
    template <bool has_layers, bool can_fail>
    void  update_one_point(std::size_t batch, double dt, ElementChunk &chunk);
    Lanes update_section(std::size_t batch, const Matrix3<Lanes> &gradient, const Stabilisation &strain, double dt,
                         const SolidModes<Lanes> &end);
    solid_shell::LayerWork<Lanes> update_layers(std::size_t batch, double dt, const LanesMask &can_yield,
                                                const SolidModes<Lanes> &end);
    template <bool can_fail>
    void update_b_bar(std::size_t batch, double dt, ElementChunk &chunk);
    void hold_shape(std::size_t batch, const SolidGeometry<Lanes> &end, const SolidModes<Lanes> &u, const Step &step,
                    double dt, SolidModes<Lanes> &force);
    /// Sets the energy of the batch and raises its bound.
    SolidModes<Lanes> hold_corners(std::size_t batch, const SolidModes<Lanes> &end, const SolidModes<Lanes> &u,
                                   double dt);
    SolidModes<Lanes> modes_of_batch(std::size_t batch) const;
    corner_volume::Shares<Lanes>   shares_at_rest(std::size_t batch) const; ///< 0 of what has failed
    corner_volume::Pressure<Lanes> corner_pressure(std::size_t batch, const SolidGeometry<Lanes> &geometry) const;
    void                           build_corners();
    double smallest_corner(std::size_t element) const; ///< m^3, the volume by the worst corner that had one at rest
    void   finish(std::size_t batch, const SolidGeometry<Lanes> &end, const SolidModes<Lanes> &force, const Step &step,
                  ElementChunk &chunk);
    /// The bound with scaled masses: a function of its own, for what does not happen shall cost no register.
    Lanes  compute_scaled_frequency(const SolidModes<Lanes> &modes, const Lanes &rest_det, const Lanes &inverse_mass,
                                    const Lanes &drag, const MassFactors<Lanes> &factors, Lanes *shape = nullptr) const;
    double compute_frequency_at_rest(std::size_t element, double inverse_mass) const;
    void   build_erosion();
    /// Position at the end and increment of the corners (m): what is turned inside out becomes a cube at rest.
    void  begin_failing(std::size_t batch, Corners (&corner)[2]);
    void  add_damage(std::size_t batch, const Lanes &plastic_strain, double dt);
    Lanes compute_damage(const SolidPoint<Lanes> &point, const Lanes &strain, const Lanes &von_mises, double dt) const;
    Lanes update_failing_point(std::size_t batch, int point, const Matrix3<Lanes> &gradient, const Lanes &volume,
                               double dt);
    void  release(std::size_t batch, const SolidGeometry<Lanes> &end, const SolidModes<Lanes> &u,
                  SolidModes<Lanes> &force, Step &step);
    [[noreturn]] void report_failure(std::size_t batch) const;

    SolidLaw                                    law;
    std::vector<std::uint8_t>                   thickness_axis; ///< [n_elements] of solid-shells, in the mesh's cells
    AlignedVector<Lanes>                        rest_det;       ///< of B-bar: as `points`, times 512, m^3
    AlignedVector<Stabilisation>                stabilisation;  ///< [n_batches], not of B-bar
    AlignedVector<corner_volume::Shares<Lanes>> corner_shares;  ///< [n_batches], at rest
    ThicknessPoints                             rule;           ///< of solid-shells
  };
} // namespace birdstrike
