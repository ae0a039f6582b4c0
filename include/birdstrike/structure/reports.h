#pragma once

#include <birdstrike/core/energy_report.h>
#include <birdstrike/core/warning.h>
#include <birdstrike/mesh/file_notes.h>
#include <birdstrike/mesh/open_seams.h>
#include <birdstrike/structure/choices.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What a blade tells the rest of the program about itself.
namespace birdstrike
{
  /// What selective mass scaling does (source/structure/nodes/mass_scaling.h); without it all is zero. Translation has
  /// its mass.
  struct MassScalingReport
  {
    double      step_before          = 0.; ///< s, stable step without it
    double      step                 = 0.; ///< s, with it
    double      added_rotary_inertia = 0.; ///< share of the blade's own, largest over all axes
    double      largest_factor       = 1.; ///< on an element's inertia against differences through the thickness
    std::size_t n_scaled             = 0;  ///< elements
  };

  /// Elements of a section; 0 is the blade's own.
  struct SectionCensus
  {
    std::size_t number, n_elements;
    double      mass;         ///< kg
    double      plastic_work; ///< J, so far
  };

  /// Elements of a section with one formulation.
  struct FormulationCensus
  {
    std::size_t        section = 0;
    ElementFormulation formulation;
    std::size_t        n_elements = 0;
    unsigned int       n_layers   = 0; ///< of bricks: fewest from skin to skin through one of these; of shells 0
  };

  /// What Failure size factors make of the elements of a section; 0 is the blade's own.
  struct SizeCensus
  {
    std::size_t number;
    double      smallest = std::numeric_limits<double>::infinity(), largest = 0.; ///< m; none: 0
    double      lowest = std::numeric_limits<double>::infinity(), highest = 0.;   ///< factors
    std::size_t n_beyond = 0;                                                     ///< elements outside of the points
  };

  /// Nodes with the same components held or driven.
  struct SupportCensus
  {
    std::array<bool, 6>   is_held{}, is_driven{}; ///< ux uy uz rx ry rz; what is driven is not counted as held
    std::size_t           n_nodes = 0;            ///< of what is computed
    std::array<double, 3> low{}, high{};          ///< m, the box around them
  };

  /// What will be computed, known before the first step (all but the elements with points, which grow in number).
  struct BladeCensus
  {
    std::size_t           n_elements    = 0;
    std::size_t           n_nodes       = 0;
    double                mass          = 0.;           ///< kg
    double                area          = 0.;           ///< m^2, of the mid-surface, or of the skin of a solid
    double                smallest_edge = 0.;           ///< m
    std::array<double, 3> smallest_at{};                ///< m, centroid of the element with that edge
    double                thinnest = 0., thickest = 0.; ///< m, of the elements of a shell
    std::size_t           n_thickness_given      = 0;   ///< of these, by the file of the mesh or a table of nodes
    double                largest_edge_ratio     = 1.;  ///< longest over shortest `smallest_edge` of all elements
    std::size_t           n_held_dofs            = 0;   ///< of what is computed, as are bytes
    std::size_t           n_elements_with_points = 0;   ///< that hold points through the thickness at present
    double                bytes                  = 0.;  ///< estimated memory of state, elements and surface
    MassScalingReport     mass_scaling;

    std::array<double, 3>      centre_of_mass{}; ///< m, of a rigid surface none
    std::vector<SupportCensus> supports;
    std::vector<SizeCensus>    sizes;      ///< of sections whose metal has Failure size factors
    std::vector<SectionCensus> sections;   ///< none where all elements have one
    std::vector<std::string>   held_faces; ///< entries that hold the rotation of a solid without saying so

    std::vector<FormulationCensus> formulations; ///< of a deformable blade, of sections and then of formulations
    OpenSeams                      seams;        ///< of a mesh from a file
    Warnings                       warnings;     ///< of its supports
    FileNotes                      file_notes;   ///< of the mesh's file
  };

  /// What has failed of a blade so far. Failed elements carry nothing; their mass stays on their nodes, and nodes
  /// without any element left fly on freely. The root section loses the forces and stresses (zero from then on) of
  /// those of its elements that fail; the tip is followed as long as its nodes exist, also when they fly freely.
  struct FailureReport
  {
    bool        can_fail    = false; ///< whether the material can fail
    std::size_t n_elements  = 0;     ///< failed
    std::size_t n_collapsed = 0;     ///< of these, not by damage but by the smallest step
    std::size_t n_at_root   = 0;     ///< of these, at the root section
    std::size_t n_partly    = 0;     ///< elements that carry on though points of theirs have failed
    std::size_t n_points    = 0;     ///< these points
    double      mass        = 0.;    ///< kg, of failed elements
    double      free_mass   = 0.;    ///< kg, on free nodes
    double      fibre_mass  = 0.;    ///< kg, of plies whose fibres have begun to fail
    double      matrix_mass = 0.;    ///< kg, of plies whose matrix has, those with torn fibres apart
    /// m, centroid of the one of n_partly with the most failed points (the first of several); none: 0
    std::array<double, 3> partly_at{};
    bool                  has_lost_tip = false; ///< a watched node of the tip row is free
  };

  /// Force and moment that the blade exerts on its clamped edge, and the stress that carries them.
  ///
  /// Frame: `span` points from the edge into the blade, `normal` is the mean surface normal there, away from the struck
  /// side, `chord` runs from the leading to the trailing edge (signs: orientation.h; flat plate struck from below: x,
  /// z, y). N > 0 is tension. The moment about normal x span is taken at the middle of the edge; M > 0 stretches the
  /// struck face, the one on the side of -normal. The transverse force is along `normal`.
  struct RootSectionReport
  {
    double              normal_force     = 0.; ///< N
    double              bending_moment   = 0.; ///< N m
    double              transverse_force = 0.; ///< N
    std::vector<double> chord_position;        ///< m from the middle of the edge, per root element, ascending
    std::vector<double> stress_struck;       ///< Pa, normal stress along span, face at -normal (outermost point there)
    std::vector<double> stress_rear;         ///< Pa, face at +normal
    double              peak_stress() const; ///< Pa, largest absolute value of both faces
  };

  /// Displacement (m) of the tip row along its mean surface normal, positive away from the struck side (orientation.h).
  struct TipDeflection
  {
    double mid_chord = 0.;
    double leading   = 0.; ///< corner at the smaller chord coordinate, whichever side is struck
    double trailing  = 0.;
  };

  /// What a blade of a row carries at its root, and where its tip is: in its own axes, those of the described blade
  /// turned there, so that blades that move alike report alike. Of a rigid one zeros.
  struct BladeLoads
  {
    unsigned int      place    = 1; ///< in the row
    bool              is_rigid = false;
    TipDeflection     tip;
    RootSectionReport root;
  };

  /// The part of the balance that is one blade's of a row.
  struct BladeBalance
  {
    unsigned int          place    = 1;
    bool                  is_rigid = false;
    EnergyReport          energies;  ///< kinetic and those of its elements but for their work
    std::array<double, 3> impulse{}; ///< N s, of contact so far, self-contact apart
  };

  /// Where the mid-chord line of a cantilevered blade begins and ends, undeformed.
  struct SpanLine
  {
    std::array<double, 3> root{};   ///< m, middle of the clamped edge
    std::array<double, 3> tip{};    ///< m, middle of the tip row
    std::array<double, 3> normal{}; ///< unit, of the tip, away from the struck side: along it deflections are taken
  };

  /// How static equilibrium was found (source/structure/implicit/static_solve.h); without unknowns none was asked for.
  struct StaticReport
  {
    std::size_t         n_unknowns   = 0;
    unsigned int        n_load_steps = 0, n_iterations = 0;
    std::size_t         n_linear_iterations = 0; ///< of multigrid, in all of them
    std::vector<double> residuals; ///< of the last load step: norm of the forces over that of loads and spin
    /// Directions in which the equilibrium is unstable (implicit/stability.h); nothing where that was not found.
    std::optional<std::size_t> n_unstable = 0;
  };

  struct PeakPlasticStrain
  {
    double                value   = 0.;
    std::size_t           element = 0;
    std::array<double, 3> position{};  ///< m, reference centroid
    std::size_t           section = 0; ///< as BladeParameters::by_section() counts them
  };

  PeakPlasticStrain find_largest(const std::vector<PeakPlasticStrain> &of_sections); ///< none: zero

  /// A watched node.
  struct ProbeValues
  {
    std::string           name;
    std::array<double, 3> position{};     ///< m, reference position of the node
    std::array<double, 3> displacement{}; ///< m
    std::array<double, 3> velocity{};     ///< m/s
  };
} // namespace birdstrike
