#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

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

    void declare_body(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.add_parameter("Enabled", bird.enabled, "Whether the scene has a bird; without one no particle is built. [-]");
      prm.add_parameter("Shape", bird.shape,
                        "Shape of the bird; a slab is a box of given lengths along x, y, z for verification. [-]",
                        Patterns::Selection("cylinder|hemispherical cylinder|ellipsoid|sphere|slab"));
      prm.add_parameter("Mass", bird.mass, "Mass of the bird; the size follows from it (not used by a slab). [kg]",
                        positive);
      prm.add_parameter("Density", bird.density, "Density of the bird at zero pressure. [kg/m^3]", positive);
      prm.add_parameter("Length over diameter", bird.length_to_diameter,
                        "Ratio of the bird's whole length to its diameter. [-]", Patterns::Double(0.001, 1000.));
      prm.add_parameter("Slab lengths", bird.slab_lengths, "Lengths of a slab along x, y and z. [m]", three_numbers);
      prm.add_parameter("Periodic directions", bird.periodic_directions,
                        "Directions in which a slab, or a cylinder along its axis, repeats itself for ever. [-]",
                        Patterns::Selection("none|x|y|z|xy|xz|yz|xyz"));
      prm.add_parameter("Packing", bird.packing, "Lattice on which the particles start. [-]",
                        Patterns::Selection("cubic|fcc"));
      prm.add_parameter("Particle spacing", bird.spacing,
                        "Cube root of the volume of one particle; adjusted slightly to meet the mass exactly. [m]",
                        positive);
    }

    void declare_motion(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.add_parameter("Velocity", bird.velocity, "Velocity of the bird. [m/s]", three_numbers);
      prm.add_parameter("Yaw", bird.yaw,
                        "Turn of the bird's axis away from its velocity, about the direction nearest to the span. "
                        "[degree]",
                        Patterns::Double(-180., 180.));
      prm.add_parameter("Pitch", bird.pitch,
                        "Turn of the bird's axis away from its velocity, about the direction normal to velocity and "
                        "yaw axis. [degree]",
                        Patterns::Double(-90., 90.));
      prm.add_parameter(
        "Roll", bird.roll,
        "Turn of the bird about its own axis. Of round shapes it turns the lattice alone (a slab is not turned): "
        "where an edge cuts the bird, 22.5 keeps rows of particles from lying along the edge, "
        "which would catch or miss a whole row at once. [degree]",
        Patterns::Double(-180., 180.));
      prm.add_parameter("Aim point", bird.aim_point,
                        "Point that the bird's centre would fly through if nothing stood in its way. [m]",
                        three_numbers);
      prm.add_parameter("Chordwise offset", bird.chordwise_offset, "Shift of the aim point along the chord (y). [m]",
                        Patterns::Double());
      prm.add_parameter("Stand-off", bird.stand_off,
                        "Distance from the bird's centre to the aim point at the start; 0 chooses twice the radius of "
                        "the sphere around the bird, or more where the blade is in its way before. [m]",
                        not_negative);
    }

    void declare_method(ParameterHandler &prm, BirdParameters &bird)
    {
      prm.add_parameter("Formulation", bird.formulation,
                        "Particle equations: riemann (limited acoustic Riemann flux) or standard (artificial "
                        "viscosity). [-]",
                        Patterns::Selection("riemann|standard"));
      prm.add_parameter("Kernel", bird.kernel,
                        "Smoothing kernel; automatic takes wendland with riemann and cubic spline with standard. [-]",
                        Patterns::Selection("automatic|wendland|cubic spline"));
      prm.add_parameter("Smoothing length ratio", bird.smoothing_ratio, "Smoothing length over particle spacing. [-]",
                        Patterns::Double(0.8, 4.));
      prm.add_parameter("Viscosity alpha", bird.alpha, "Linear artificial viscosity of the standard formulation. [-]",
                        not_negative);
      prm.add_parameter("Viscosity beta", bird.beta, "Quadratic artificial viscosity of the standard formulation. [-]",
                        not_negative);
      prm.add_parameter("Density by", bird.density_by,
                        "How the standard formulation gets the density: by summation over neighbours or by "
                        "integrating continuity. [-]",
                        Patterns::Selection("continuity|summation"));
      prm.add_parameter("Gradient correction", bird.gradient_correction,
                        "Whether the riemann formulation corrects kernel gradients near free surfaces. [-]");
      prm.add_parameter("Correction interval", bird.correction_interval,
                        "Evaluations of the rates after which the correction matrices are renewed. [-]",
                        Patterns::Integer(1, 1000));
      prm.add_parameter("Pair precision", bird.pair_precision,
                        "Number type of what a pair of particles exchanges in the riemann formulation; state and sums "
                        "over time are double. [-]",
                        Patterns::Selection("double|float"));
      prm.add_parameter("Reconstruction", bird.reconstruction,
                        "Velocity at the midpoint of a pair in the riemann formulation: none, or linear from the "
                        "velocity gradients. [-]",
                        Patterns::Selection("none|linear"));
      prm.add_parameter("Tension cut-off", bird.tension_cutoff,
                        "Whether pressure stops at zero in tension; volume goes on evolving. [-]");
      prm.add_parameter("Courant number", bird.courant_number,
                        "Share of smoothing length over signal speed taken as the time step; times Time/Bird step "
                        "scale at most 0.5 (riemann) or 0.7 (standard), above which nothing is gained. [-]",
                        Patterns::Double(0.01, 0.7));
      prm.add_parameter("Skin", bird.skin, "Skin of the neighbour list over the kernel's support. [-]",
                        Patterns::Double(0.001, 1.));
      prm.add_parameter("Retire", bird.retire,
                        "Whether loose particles that can no longer meet the blade leave the computation. [-]");
      prm.add_parameter("Retirement margin", bird.retirement_margin,
                        "Distance by which the blade's box grows before a path is said to miss it. [m]", not_negative);
    }

    [[noreturn]] void refuse(const std::string &entry, const std::string &found, const std::string &action)
    {
      throw InputError("Section 'Bird', entry '" + entry + "': " + found + "\n" + action);
    }
  } // namespace

  void BirdParameters::declare(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Bird");
    declare_body(prm, *this);
    declare_motion(prm, *this);
    declare_method(prm, *this);
    prm.leave_subsection();
  }

  void BirdParameters::check() const
  {
    if (!enabled)
      return;
    if (shape == "slab")
      {
        for (const double length : slab_lengths)
          if (length < spacing)
            refuse("Slab lengths", std::to_string(length) + " m is less than one particle spacing.",
                   "Give three lengths of at least the particle spacing.");
      }
    else if (spacing > 0.5 * std::cbrt(mass / density))
      refuse("Particle spacing", std::to_string(spacing) + " m leaves fewer than about eight particles.",
             "Choose a spacing below " + std::to_string(0.5 * std::cbrt(mass / density)) + " m.");
    if (periodic_directions != "none" && shape != "slab" && shape != "cylinder")
      refuse("Periodic directions", "a " + shape + " cannot repeat itself.", "Use 'none', or a slab or cylinder.");
    if (shape != "slab" && periodic_directions.size() == 2)
      refuse("Periodic directions", "a cylinder repeats itself along its axis only.", "Name one direction.");
    if (shape == "hemispherical cylinder" && length_to_diameter < 1.)
      refuse("Length over diameter", "hemispherical ends need a length of at least one diameter.",
             "Give 1 or more, or choose 'ellipsoid'.");
    if (is_riemann() && kernel == "cubic spline")
      refuse("Kernel", "the riemann formulation is written for the Wendland kernel.",
             "Choose 'automatic', or Formulation = standard.");
    if (is_riemann() && !gradient_correction && reconstruction != "none")
      refuse("Reconstruction", "its velocity gradients need the gradient correction.",
             "Set 'none', or Gradient correction = true.");
    if (is_halved)
      check_halves();
    if (!is_riemann() && reconstruction != "none")
      refuse("Reconstruction", "the standard formulation has none.", "Set 'none', or Formulation = riemann.");
  }

  void BirdParameters::check_halves() const
  {
    const auto refuse_half = [](const std::string &entry, const std::string &found, const std::string &action) {
      refuse(entry, found + " has no mirror plane y = 0.", action + ", or compute the whole bird.");
    };
    if (velocity[1] != 0.)
      refuse_half("Velocity", "a velocity of " + std::to_string(velocity[1]) + " m/s along y", "Let y be 0");
    if (aim_point[1] != 0. || chordwise_offset != 0.)
      refuse_half(aim_point[1] != 0. ? "Aim point" : "Chordwise offset", "an aim beside the plane", "Aim at y = 0");
    if (yaw != 0.)
      refuse_half("Yaw", "a yawed bird", "Set it to 0 (pitch stays in the plane)");
    if (roll != 0.)
      refuse_half("Roll", "a lattice turned about the bird's axis", "Set it to 0");
    if (std::hypot(velocity[1], velocity[2]) < 1e-3 * std::abs(velocity[0]))
      refuse_half("Velocity", "the frame of a bird that flies along x", "Let it fly across the span");
    if (packing != "cubic")
      refuse_half("Packing", "the " + packing + " lattice", "Choose 'cubic'");
    if (!is_riemann())
      refuse("Formulation", "mirror images are written for the riemann formulation.",
             "Set it, or compute the whole bird.");
    if (periodic_directions != "none")
      refuse("Periodic directions", "they do not go with a symmetry plane.", "Set 'none', or compute the whole bird.");
    if (shape == "slab")
      refuse("Shape", "a slab is not halved.", "Choose another shape, or compute the whole slab.");
  }

  bool BirdParameters::is_periodic(const int direction) const
  {
    return periodic_directions != "none" && periodic_directions.find("xyz"[direction]) != std::string::npos;
  }

  double BirdParameters::largest_courant_number() const
  {
    return is_riemann() ? 0.5 : 0.7;
  }

  bool BirdParameters::is_riemann() const
  {
    return formulation == "riemann";
  }
} // namespace birdstrike
