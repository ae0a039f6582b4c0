#pragma once

#include "structure/elements/elements.h"
#include "structure/elements/shell/laminate/sections.h"
#include "structure/elements/shell/nodes.h"
#include "structure/elements/shell/section.h"

#include <optional>

namespace birdstrike
{
  struct ShellBatch : ElementBatch<4>
  {
    Lanes radius2; ///< m^2, max(t^2/12, A/8) at rest: the rotary inertia over the mass
  };

  /// Shells of one section: their state and kernels.
  class ShellGroup : public ElementGroup<ShellBatch, ShellRecord, Row, Erosion>
  {
  public:
    using Section                               = ShellSection;
    using Extra                                 = double; ///< thickness, m
    using Nodes                                 = ShellNodes;
    static constexpr unsigned int n_unknowns    = 6;
    static constexpr double       largest_share = 1.; ///< of its own part of the mass that an element counts with
    static constexpr const char  *names = "Shell elements", *reason = "shell element, largest eigenvalue";

    ShellGroup(const ShellSection &section, Place place, const std::vector<double> &thickness,
               const ElementBlocks &blocks);

    static double step_of(const double bound) ///< s
    {
      return 2. / std::sqrt(bound);
    }

    void update_chunk(std::size_t chunk, double dt);
    void update_bounds_at_rest();
    void archive(Archive &archive); ///< stresses
    auto changing()                 ///< see Elements::save
    {
      return std::tuple_cat(ElementGroup::changing(), std::tie(points, stress, sections, has_new_failed, laminate));
    }

    void suspend_flow(bool is_suspended); ///< see Elements::suspend_flow

    bool                   has_points(std::size_t batch) const;                 ///< any of its sections
    std::size_t            count_yielded(std::size_t batch) const;              ///< at an outer point; all of plies
    Lanes                  contraction(std::size_t batch, std::size_t k) const; ///< of a section: SectionLaw
    double                 largest_plastic_strain(std::size_t element) const;
    StoredEnergy::State    stored(std::size_t section) const;            ///< by number: [n_batches][n_in_plane]
    double                 largest_thickness(std::size_t element) const; ///< m, of its sections
    ShellGeometry<double>  geometry(std::size_t element) const;
    std::size_t            bytes() const;
    const ThicknessPoints &rule() const
    {
      return law.rule;
    }

    /// Section k of a batch, and its points through the thickness.
    const SectionStress<Lanes> &section_of(std::size_t batch, std::size_t k) const;
    /// sxx, syy, sxy (Pa, Kirchhoff's) in the element's frame, of a laminate at section k and the height 2 z/t.
    Point3 ply_stress(std::size_t element, std::size_t k, double height) const;
    /// Shares of an element's thickness in which the modes of PlyDamage have begun.
    std::array<double, PlyDamage<double>::n_modes> failed_shares(std::size_t element) const;
    /// Of its fibres, and of the matrix of other plies.
    std::array<double, 2>                   failed_ply_shares(std::size_t element) const;
    const AlignedVector<ShellPoint<Lanes>> &points_of(std::size_t batch, std::size_t k) const;

    ShellSection                                  section;
    std::size_t                                   n_in_plane; ///< sections of an element: one, or four fully integrated
    std::vector<AlignedVector<ShellPoint<Lanes>>> points;     ///< [n_in_plane n_batches], empty while elastic
    std::optional<LaminateSections>               laminate;   ///< none of metals

  private:
    void   check_shape(std::size_t element, double thickness);
    void   archive_points(Archive &archive);
    void   promote(std::size_t section);             ///< number in `points`
    double smallest_area(std::size_t element) const; ///< m^2; at the points of a fully integrated one four times theirs
    bool   looks_along_normals(std::size_t element) const;
    double eigenvalue_bound(std::size_t element) const;
    void   get_corners(std::size_t element, Vector3<double> (&position)[4], Vector3<double> (&normal)[4]) const;

    template <bool physical>
    void             update_batch(std::size_t batch, double dt, ElementChunk &chunk);
    ShellWork<Lanes> update_points(std::size_t batch, const ShellVector<Lanes> &strain, const Lanes &area, double dt);
    ShellWork<Lanes> update_failing_points(std::size_t batch, const ShellVector<Lanes> &strain, const Lanes &area,
                                           double dt);
    void             update_fully_integrated(std::size_t batch, double dt, ElementChunk &chunk);
    Lanes            update_section(std::size_t section, const SectionVector<Lanes> &strain, double dt);
    Lanes            update_failing_section(std::size_t section, const SectionVector<Lanes> &strain, double dt);
    void             release_sections(std::size_t batch, const SectionVector<Lanes> *strain, const Lanes *area);
    void             build_erosion();
    template <bool physical>
    void update_laminate(std::size_t batch, double dt, ElementChunk &chunk);
    void update_fully_integrated_laminate(std::size_t batch, double dt, ElementChunk &chunk);
    void update_failing_plies(std::size_t batch, const LaminateState<Lanes> *old, const Lanes *volume, double dt);
    void release_plies(std::size_t batch, const LaminateState<Lanes> *old, const Lanes *volume, const LanesMask &fails,
                       const LanesMask &grows, const Lanes &carries);
    void release_collapsed_laminate(std::size_t batch, const LanesMask &fails, Lanes &energy);
    void build_laminate();
    void archive_laminate(Archive &archive);
    void archive_plies(Archive &archive);
    double laminate_bound(std::size_t element, const ShellGeometry<double> &geometry) const;

    bool   can_collapse() const; ///< whether elements that do are eroded
    bool   has_finite_state(std::size_t element) const;
    void   take_collapsed(std::size_t chunk);
    void   collapse(std::size_t batch, ElementChunk &chunk);
    double drop_forces(std::size_t batch, std::size_t lane);
    void   report_failure(std::size_t batch); ///< throws, unless what is unsound collapses and goes

    ShellSectionLaw                     law;
    double                              initial_yield;
    AlignedVector<ShellStress<Lanes>>   stress;         ///< [n_batches] of one-point elements
    AlignedVector<SectionStress<Lanes>> sections;       ///< [4 n_batches] of fully integrated ones
    std::vector<unsigned char>          has_new_failed; ///< [n_batches], points of fully integrated ones, in this step
  };
} // namespace birdstrike
