#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    const Patterns::Double positive(1e-300);
    const Patterns::Double not_negative(0.);
    const Patterns::List   three_numbers(Patterns::Double(), 3, 3);

    const NamedChoices<std::array<bool, 3>> directions{
      {"none", {{false, false, false}}}, {"x", {{true, false, false}}}, {"y", {{false, true, false}}},
      {"z", {{false, false, true}}},     {"xy", {{true, true, false}}}, {"xz", {{true, false, true}}},
      {"yz", {{false, true, true}}},     {"xyz", {{true, true, true}}}};
    const NamedChoices<SmoothingKernel> kernels{{"automatic", SmoothingKernel::automatic},
                                                {"wendland", SmoothingKernel::wendland},
                                                {"cubic spline", SmoothingKernel::cubic_spline}};
    const NamedChoices<DensityBy> densities{{"continuity", DensityBy::continuity}, {"summation", DensityBy::summation}};
    const NamedChoices<PairPrecision>  precisions{{"double", PairPrecision::as_double},
                                                 {"float", PairPrecision::as_float}};
    const NamedChoices<Reconstruction> reconstructions{{"none", Reconstruction::none},
                                                       {"linear", Reconstruction::linear}};

    void declare_body(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.add_parameter("Enabled", bird.enabled,
                        "Whether the scene has this bird; without one no particle is built. [-]");
      declare_choice(prm, "Shape", bird.shape, bird_shapes(),
                     "Shape of the bird; a slab is a box of given lengths along x, y, z for verification. [-]");
      prm.add_parameter("Mass", bird.mass, "Mass of the bird; the size follows from it (not used by a slab). [kg]",
                        positive);
      prm.add_parameter("Density", bird.density, "Density of the bird at zero pressure. [kg/m^3]", positive);
      prm.add_parameter("Length over diameter", bird.length_to_diameter,
                        "Ratio of the bird's whole length to its diameter. [-]", Patterns::Double(0.001, 1000.));
      prm.add_parameter("Slab lengths", bird.slab_lengths, "Lengths of a slab along x, y and z. [m]", three_numbers);
      declare_choice(prm, "Periodic directions", bird.is_periodic, directions,
                     "Directions in which a slab, or a cylinder along its axis, repeats itself for ever. [-]");
      declare_choice(prm, "Packing", bird.packing, bird_lattices(),
                     "Lattice on which the particles start; its layers fill the length of a cylinder or slice. [-]");
      prm.add_parameter("Particle spacing", bird.spacing,
                        "Cube root of the volume of one particle; adjusted slightly to meet the mass exactly. [m]",
                        positive);
    }

    void declare_slice(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.enter_subsection("Slice");
      prm.add_parameter("Between", bird.slice_between,
                        "The part of the bird that is there: between two planes square to Normal, at these distances "
                        "from the centre of the whole bird; Mass is the whole bird's. Empty: the whole bird. [m]",
                        Patterns::List(Patterns::Double(), 0, 2));
      prm.add_parameter("Normal", bird.slice_normal,
                        "Normal of the planes of the slice, in fixed axes, of any length; empty: the bird's own axis, "
                        "which points ahead. [-]",
                        Patterns::List(Patterns::Double(), 0, 3));
      prm.add_parameter(
        "Number of blades", bird.slice_blades,
        "Of the row, of which one turns here (Blade/Spin): Between and Normal follow, as the paths of the leading "
        "edges of this blade and of the one before it. With Aim span fraction alone the bird aims between these, as "
        "spin and steady loads have moved the edge; else the slice is centred at the aim. 0: they are as given. [-]",
        Patterns::Integer(0));
      prm.leave_subsection();
    }

    void declare_motion(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.add_parameter("Velocity", bird.velocity,
                        "Velocity of the bird; or give Speed with Angle to surface or Flight direction. [m/s]",
                        three_numbers);
      prm.add_parameter("Speed", bird.speed, "Speed of the bird; empty: that of Velocity. [m/s]",
                        Patterns::List(positive, 0, 1));
      prm.add_parameter(
        "Angle to surface", bird.angle_to_surface,
        "Angle between the velocity and the blade's surface at the aim point, in the plane of its normal "
        "and its chord: 90 flies along the normal (span x chord: +z on the built-in plate), less from the leading "
        "towards the trailing edge, more than 90 back; negative angles come from the other side. For a "
        "blade at rest; empty: as Velocity or Flight direction say. [degree]",
        Patterns::List(Patterns::Double(-180., 180.), 0, 1));
      prm.add_parameter("Flight direction", bird.flight_direction,
                        "Direction of the velocity, of any length; empty: as Velocity or Angle to surface say. [-]",
                        Patterns::List(Patterns::Double(), 0, 3));
      prm.add_parameter(
        "Yaw", bird.yaw,
        "Turn of the bird's axis away from its velocity, about the direction square to it that is nearest "
        "to the span: from root to tip of a mesh from a file that has both (Blade/Supports), else x; "
        "y for a bird that flies along it. [degree]",
        Patterns::Double(-180., 180.));
      prm.add_parameter("Pitch", bird.pitch,
                        "Turn of the bird's axis away from its velocity, about the direction normal to velocity and "
                        "yaw axis. [degree]",
                        Patterns::Double(-90., 90.));
      prm.add_parameter(
        "Roll", bird.roll,
        "Turn of the bird about its own axis, of a slice about its normal. Of round shapes it turns the lattice alone "
        "(a slab is not turned): "
        "where an edge cuts the bird, 22.5 keeps rows of particles from lying along the edge, "
        "which would catch or miss a whole row at once. [degree]",
        Patterns::Double(-180., 180.));
      prm.add_parameter(
        "Lattice shift", bird.lattice_shift,
        "Offset of the particle lattice across the bird's axis (of a slice along its planes), in two directions, in "
        "edges of the lattice's cell (a spacing of the cubic packing); mass and shape stay. By how much results change "
        "with it is the scatter of a single run: which rows an edge or a facet catches. [-]",
        Patterns::List(Patterns::Double(-1., 1.), 2, 2));
      prm.add_parameter(
        "Aim point", bird.aim_point,
        "Point that the bird's centre would fly through if nothing stood in its way; of a slice the centre of the "
        "whole bird. Beside Aim span fraction it is that of the blade as it is built, and goes with it. [m]",
        three_numbers);
      prm.add_parameter(
        "Position", bird.position,
        "Position of the bird's centre (of a slice: of the whole bird) at time 0, as decks of other codes give it. It "
        "stands for Aim point and Arrival time, which follow: the bird flies from there along Velocity. Time 0 is then "
        "that of the position, not that of the first touch. Empty: Aim point. [m]",
        Patterns::List(Patterns::Double(), 0, 3));
      prm.add_parameter(
        "Aim span fraction", bird.aim_span_fraction,
        "Share of the span, 0 at the root and 1 at the tip, at which the bird aims on the blade's surface, "
        "with Aim chord fraction, as spin and steady loads have moved it; empty: Aim point. [-]",
        Patterns::List(Patterns::Double(0., 1.), 0, 1));
      prm.add_parameter("Aim chord fraction", bird.aim_chord_fraction,
                        "Share of the chord of that section, 0 at the leading and 1 at the trailing edge. [-]",
                        Patterns::List(Patterns::Double(0., 1.), 0, 1));
      prm.add_parameter(
        "Chordwise offset", bird.chordwise_offset,
        "Shift of the aim point along the chord of the section where the bird aims, towards the trailing "
        "edge; along y where the blade has no chord. [m]",
        Patterns::Double());
      prm.add_parameter("Stand-off", bird.stand_off,
                        "Distance from the bird's centre to the aim point at the start; 0 chooses twice the radius of "
                        "the sphere around the bird, or more where the blade is in its way before. [m]",
                        not_negative);
      prm.add_parameter(
        "Arrival time", bird.arrival,
        "Time of the bird's first touch, for a blade that is not deformed but has turned with its hub until "
        "then; before, the bird flies freely and costs nothing. With Position it follows, and 0 does not contradict "
        "it. [s]",
        not_negative);
    }

    void declare_method(ParameterHandler &prm, BirdParameters &bird)
    {
      declare_choice(prm, "Formulation", bird.formulation, particle_formulations(),
                     "Particle equations: riemann (limited acoustic Riemann flux) or standard (artificial "
                     "viscosity). [-]");
      declare_choice(prm, "Kernel", bird.kernel, kernels,
                     "Smoothing kernel; automatic takes wendland with riemann and cubic spline with standard. [-]");
      prm.add_parameter("Smoothing length ratio", bird.smoothing_ratio, "Smoothing length over particle spacing. [-]",
                        Patterns::Double(0.8, 4.));
      prm.add_parameter("Viscosity alpha", bird.alpha, "Linear artificial viscosity of the standard formulation. [-]",
                        not_negative);
      prm.add_parameter("Viscosity beta", bird.beta, "Quadratic artificial viscosity of the standard formulation. [-]",
                        not_negative);
      declare_choice(prm, "Density by", bird.density_by, densities,
                     "How the standard formulation gets the density: by summation over neighbours or by "
                     "integrating continuity. [-]");
      prm.add_parameter("Gradient correction", bird.gradient_correction,
                        "Whether the riemann formulation corrects kernel gradients near free surfaces. [-]");
      prm.add_parameter("Correction interval", bird.correction_interval,
                        "Evaluations of the rates after which the correction matrices are renewed. [-]",
                        Patterns::Integer(1, 1000));
      declare_choice(prm, "Pair precision", bird.pair_precision, precisions,
                     "Number type of what a pair of particles exchanges in the riemann formulation; state and sums "
                     "over time are double. [-]");
      declare_choice(prm, "Reconstruction", bird.reconstruction, reconstructions,
                     "Velocity at the midpoint of a pair in the riemann formulation: none, or linear from the "
                     "velocity gradients. [-]");
      prm.enter_subsection("Strength");
      prm.add_parameter("Shear modulus", bird.shear_modulus,
                        "Shear modulus G of a bird with strength; it shortens steps as sqrt(c^2 + 4 G/(3 rho)) does. "
                        "[Pa]",
                        not_negative);
      prm.add_parameter("Yield stress", bird.yield_stress,
                        "Yield stress Y of the bird: elastic, perfectly plastic beside the pressure (von Mises); 0: a "
                        "liquid. Where pressure stops at zero, what has come apart by 1 % of its volume has none. [Pa]",
                        not_negative);
      prm.leave_subsection();
      prm.add_parameter("Courant number", bird.courant_number,
                        "Share of smoothing length over signal speed taken as the time step; times Time/Bird step "
                        "scale at most 0.5 (riemann) or 0.7 (standard), above which nothing is gained. [-]",
                        Patterns::Double(0.01, 0.7));
      prm.add_parameter("Skin", bird.skin, "Skin of the neighbour list over the kernel's support. [-]",
                        Patterns::Double(0.001, 1.));
      prm.add_parameter(
        "Retire", bird.retire,
        "Whether free particles that can no longer meet the blade are deactivated (deleted from the computation, their "
        "mass, momentum and energy kept in the balance). [-]");
      prm.add_parameter(
        "Retirement margin", bird.retirement_margin,
        "Margin around the blade's bounding box: particles are deactivated only if their straight path misses the box "
        "with this margin; empty: 1.25 diameters of the bird. [m]",
        Patterns::List(not_negative, 0, 1));
    }
  } // namespace

  const NamedChoices<BirdShape> &bird_shapes()
  {
    static const NamedChoices<BirdShape> choices{{"cylinder", BirdShape::cylinder},
                                                 {"hemispherical cylinder", BirdShape::hemispherical_cylinder},
                                                 {"ellipsoid", BirdShape::ellipsoid},
                                                 {"sphere", BirdShape::sphere},
                                                 {"slab", BirdShape::slab}};
    return choices;
  }

  const NamedChoices<BirdLattice> &bird_lattices()
  {
    static const NamedChoices<BirdLattice> choices{{"cubic", BirdLattice::cubic}, {"fcc", BirdLattice::fcc}};
    return choices;
  }

  const NamedChoices<ParticleFormulation> &particle_formulations()
  {
    static const NamedChoices<ParticleFormulation> choices{{"riemann", ParticleFormulation::riemann},
                                                           {"standard", ParticleFormulation::standard}};
    return choices;
  }

  void BirdParameters::declare(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    declare_body(prm, *this);
    declare_slice(prm, *this);
    declare_motion(prm, *this);
    declare_method(prm, *this);
    prm.leave_subsection();
  }

  std::array<double, 3> BirdParameters::target() const
  {
    const std::array<double, 3> chord = aimed_surface ? aimed_surface->chord : std::array<double, 3>{{0., 1., 0.}};
    std::array<double, 3>       point = aim_point;
    for (std::size_t d = 0; d < 3; ++d)
      point[d] += chordwise_offset * chord[d];
    return point;
  }

  double BirdParameters::largest_courant_number() const
  {
    return is_riemann() ? 0.5 : 0.7;
  }

  bool BirdParameters::is_riemann() const
  {
    return formulation == ParticleFormulation::riemann;
  }
} // namespace birdstrike
