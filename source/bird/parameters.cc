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
                        "Presence of this bird in the scene. false: no particles are built. [-]");
      declare_choice(prm, "Shape", bird.shape, bird_shapes(),
                     "Shape of the bird. slab: a box with Slab lengths along x, y, z, for verification. [-]");
      prm.add_parameter("Mass", bird.mass, "Mass of the bird, which sets its size. A slab does not use it. [kg]",
                        positive);
      prm.add_parameter("Density", bird.density, "Density of the bird at zero pressure. [kg/m^3]", positive);
      prm.add_parameter("Length over diameter", bird.length_to_diameter,
                        "Ratio of the bird's whole length to its diameter. [-]", Patterns::Double(0.001, 1000.));
      prm.add_parameter("Slab lengths", bird.slab_lengths, "Lengths of a slab along x, y and z. [m]", three_numbers);
      declare_choice(prm, "Periodic directions", bird.is_periodic, directions,
                     "Periodic directions of a slab, or of a cylinder along its axis. [-]");
      declare_choice(prm, "Packing", bird.packing, bird_lattices(),
                     "Lattice of the particles at the start. Its layers fill the length of a cylinder or slice. [-]");
      prm.add_parameter(
        "Particle spacing", bird.spacing,
        "Cube root of the volume of one particle. It is adjusted slightly to meet the mass exactly. [m]", positive);
    }

    void declare_slice(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.enter_subsection("Slice");
      prm.add_parameter("Between", bird.slice_between,
                        "Distances of two planes from the centre of the whole bird, along Normal. The slice is the "
                        "part of the bird between them. Mass is that of the whole bird. Empty: the whole bird. [m]",
                        Patterns::List(Patterns::Double(), 0, 2));
      prm.add_parameter("Normal", bird.slice_normal,
                        "Normal of the planes of the slice, in fixed axes, of any length. Empty: the bird's own axis, "
                        "which points ahead. [-]",
                        Patterns::List(Patterns::Double(), 0, 3));
      prm.add_parameter(
        "Number of blades", bird.slice_blades,
        "Number of blades of the rotating row (Blade/Spin); the case computes one of them. Between and Normal follow "
        "from the paths of the leading edges of this blade and of the one before it. With Aim span fraction alone, the "
        "bird aims between these paths, with the edge as spin and steady loads have moved it. Otherwise the slice is "
        "centred at the aim. 0: Between and Normal apply. [-]",
        Patterns::Integer(0));
      prm.leave_subsection();
    }

    void declare_motion(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.add_parameter(
        "Velocity", bird.velocity,
        "Velocity of the bird. Alternatively, set Speed with Angle to surface or Flight direction. [m/s]",
        three_numbers);
      prm.add_parameter("Speed", bird.speed, "Speed of the bird. Empty: that of Velocity. [m/s]",
                        Patterns::List(positive, 0, 1));
      prm.add_parameter(
        "Angle to surface", bird.angle_to_surface,
        "Angle between the velocity and the blade's surface at the aim point, in the plane of its normal and its "
        "chord. 90: along the normal (span x chord: +z on the built-in plate). Below 90 the bird flies from the "
        "leading towards the trailing edge, above 90 back. Negative angles come from the other side. The entry is for "
        "a blade at rest. Empty: Velocity or Flight direction applies. [degree]",
        Patterns::List(Patterns::Double(-180., 180.), 0, 1));
      prm.add_parameter("Flight direction", bird.flight_direction,
                        "Direction of the velocity, of any length. Empty: Velocity or Angle to surface applies. [-]",
                        Patterns::List(Patterns::Double(), 0, 3));
      prm.add_parameter(
        "Yaw", bird.yaw,
        "Rotation of the bird's axis away from its velocity. The axis of this rotation is normal to the velocity and "
        "nearest to the span. The span is x, or from root to tip of a mesh from a file that has both (Blade/Supports). "
        "For a bird that flies along it, y takes its place. [degree]",
        Patterns::Double(-180., 180.));
      prm.add_parameter("Pitch", bird.pitch,
                        "Rotation of the bird's axis away from its velocity, about the direction normal to velocity "
                        "and yaw axis. [degree]",
                        Patterns::Double(-90., 90.));
      prm.add_parameter(
        "Roll", bird.roll,
        "Rotation of the bird about its own axis, of a slice about its normal. It turns only the lattice of round "
        "shapes, and does not turn a slab. Where an edge cuts the bird, 22.5 keeps rows of particles from lying along "
        "the edge. Such an edge would catch or miss a whole row at once. [degree]",
        Patterns::Double(-180., 180.));
      prm.add_parameter(
        "Lattice shift", bird.lattice_shift,
        "Offset of the particle lattice across the bird's axis (of a slice along its planes), in two directions. Its "
        "unit is the edge of the lattice's cell, one spacing of the cubic packing. Mass and shape stay. The change of "
        "results with it is the scatter of a single run: an edge or a facet catches other rows. [-]",
        Patterns::List(Patterns::Double(-1., 1.), 2, 2));
      prm.add_parameter(
        "Aim point", bird.aim_point,
        "Point through which the bird's centre would fly without an obstacle, of a slice the centre of the whole bird. "
        "With Aim span fraction it is a point of the blade as built, and moves with the blade. [m]",
        three_numbers);
      prm.add_parameter(
        "Position", bird.position,
        "Position of the bird's centre (of a slice: of the whole bird) at time 0, as in decks of other codes. It "
        "replaces Aim point and Arrival time, which follow: the bird flies from there along Velocity. Time 0 is then "
        "that of the position, not that of first contact. Empty: Aim point applies. [m]",
        Patterns::List(Patterns::Double(), 0, 3));
      prm.add_parameter("Aim span fraction", bird.aim_span_fraction,
                        "Share of the span, 0 at the root and 1 at the tip, at which the bird aims on the blade's "
                        "surface. It goes together with Aim chord fraction. The aim is on the surface as spin and "
                        "steady loads have moved it. Empty: Aim point applies. [-]",
                        Patterns::List(Patterns::Double(0., 1.), 0, 1));
      prm.add_parameter("Aim chord fraction", bird.aim_chord_fraction,
                        "Share of the chord at which the bird aims, 0 at the leading and 1 at the trailing edge. [-]",
                        Patterns::List(Patterns::Double(0., 1.), 0, 1));
      prm.add_parameter("Chordwise offset", bird.chordwise_offset,
                        "Shift of the aim point along the chord of the section where the bird aims, towards the "
                        "trailing edge. Where the blade has no chord, the shift is along y. [m]",
                        Patterns::Double());
      prm.add_parameter("Stand-off", bird.stand_off,
                        "Distance from the bird's centre to the aim point at the start. 0: twice the radius of the "
                        "sphere around the bird, or more where the blade is in its way earlier. [m]",
                        not_negative);
      prm.add_parameter("Arrival time", bird.arrival,
                        "Time of the bird's first contact with a blade that is undeformed but has rotated with its hub "
                        "until then. Before it the bird flies freely at no cost. It follows from Position where that "
                        "is set, and 0 does not contradict it. [s]",
                        not_negative);
    }

    void declare_method(ParameterHandler &prm, BirdParameters &bird)
    {
      declare_choice(prm, "Formulation", bird.formulation, particle_formulations(),
                     "Formulation of the SPH equations. riemann: limited acoustic Riemann flux. standard: artificial "
                     "viscosity. [-]");
      declare_choice(prm, "Kernel", bird.kernel, kernels,
                     "Smoothing kernel. automatic: wendland with riemann, cubic spline with standard. [-]");
      prm.add_parameter("Smoothing length ratio", bird.smoothing_ratio,
                        "Ratio of smoothing length to particle spacing. [-]", Patterns::Double(0.8, 4.));
      prm.add_parameter("Viscosity alpha", bird.alpha, "Linear artificial viscosity of the standard formulation. [-]",
                        not_negative);
      prm.add_parameter("Viscosity beta", bird.beta, "Quadratic artificial viscosity of the standard formulation. [-]",
                        not_negative);
      declare_choice(prm, "Density by", bird.density_by, densities,
                     "Source of the density in the standard formulation. summation: a sum over neighbours. continuity: "
                     "integration of the continuity equation. [-]");
      prm.add_parameter("Gradient correction", bird.gradient_correction,
                        "Correction of kernel gradients near free surfaces in the riemann formulation. [-]");
      prm.add_parameter("Correction interval", bird.correction_interval,
                        "Number of evaluations of the rates after which the correction matrices are renewed. [-]",
                        Patterns::Integer(1, 1000));
      declare_choice(prm, "Pair precision", bird.pair_precision, precisions,
                     "Number type of the exchange between two particles in the riemann formulation. State and sums "
                     "over time are double. [-]");
      declare_choice(prm, "Reconstruction", bird.reconstruction, reconstructions,
                     "Reconstruction of the velocity at the midpoint of a pair in the riemann formulation. linear: "
                     "from the velocity gradients. [-]");
      prm.enter_subsection("Strength");
      prm.add_parameter("Shear modulus", bird.shear_modulus,
                        "Shear modulus G of a bird with strength. It shortens time steps: waves travel at sqrt(c^2 + 4 "
                        "G/(3 rho)). [Pa]",
                        not_negative);
      prm.add_parameter("Yield stress", bird.yield_stress,
                        "Yield stress Y of the bird (von Mises). Beside the pressure the bird is elastic and perfectly "
                        "plastic. Where the pressure has a lower limit of zero, material that has expanded by 1 % of "
                        "its volume has no strength. 0: a liquid. [Pa]",
                        not_negative);
      prm.leave_subsection();
      prm.add_parameter("Courant number", bird.courant_number,
                        "Time step as a share of smoothing length over signal speed. Its product with Time/Bird step "
                        "scale is at most 0.5 (riemann) or 0.7 (standard). Larger values would gain nothing. [-]",
                        Patterns::Double(0.01, 0.7));
      prm.add_parameter("Skin", bird.skin, "Ratio of the neighbour list's skin to the kernel's support. [-]",
                        Patterns::Double(0.001, 1.));
      prm.add_parameter("Retire", bird.retire,
                        "Removal of free particles that cannot meet the blade any more. Their mass, momentum and "
                        "energy stay in the balance. [-]");
      prm.add_parameter("Retirement margin", bird.retirement_margin,
                        "Margin around the blade's bounding box. Particles are removed only if their straight path "
                        "misses the box with this margin. Empty: 1.25 diameters of the bird. [m]",
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
