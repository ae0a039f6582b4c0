#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>

#include <algorithm>
#include <cmath>

/// Rules between the entries of the bird.
namespace birdstrike
{
  void BirdParameters::refuse(const std::string &entry, const std::string &found, const std::string &action) const
  {
    throw InputError("Section '" + section + "', entry '" + entry + "': " + found + "\n" + action);
  }

  void BirdParameters::check() const
  {
    if (!enabled)
      return;
    if (!flight_direction.empty() && (flight_direction.size() != 3 ||
                                      std::hypot(flight_direction[0], flight_direction[1], flight_direction[2]) == 0.))
      refuse("Flight direction", "it is no direction.", "Give three numbers that are not all zero.");
    if (aim_span_fraction.empty() != aim_chord_fraction.empty() &&
        !(slice_blades > 0 && aim_chord_fraction.empty())) // then it follows
      refuse(aim_span_fraction.empty() ? "Aim span fraction" : "Aim chord fraction", "it is not given, its partner is.",
             "Give both shares, or none and Aim point.");
    const auto n_periodic = std::count(is_periodic.begin(), is_periodic.end(), true);
    if (shape == BirdShape::slab)
      {
        for (const double length : slab_lengths)
          if (length < spacing)
            refuse("Slab lengths", number_text(length) + " m is less than one particle spacing.",
                   "Give three lengths of at least the particle spacing.");
      }
    else if (spacing > 0.5 * std::cbrt(mass / density))
      refuse("Particle spacing", number_text(spacing) + " m leaves fewer than about eight particles.",
             "Choose a spacing below " + number_text(0.5 * std::cbrt(mass / density)) +
               " m; '4 mm' or 0.004 are four millimetres.");
    if (n_periodic > 0 && shape != BirdShape::slab && shape != BirdShape::cylinder)
      refuse("Periodic directions", "a " + bird_shapes().name(shape) + " cannot repeat itself.",
             "Use 'none', or a slab or cylinder.");
    if (shape != BirdShape::slab && n_periodic > 1)
      refuse("Periodic directions", "a cylinder repeats itself along its axis only.", "Name one direction.");
    if (shape == BirdShape::hemispherical_cylinder && length_to_diameter < 1.)
      refuse("Length over diameter", "hemispherical ends need a length of at least one diameter.",
             "Give 1 or more, or choose 'ellipsoid'.");
    if (is_riemann() && kernel == SmoothingKernel::cubic_spline)
      refuse("Kernel", "the riemann formulation is written for the Wendland kernel.",
             "Choose 'automatic', or Formulation = standard.");
    if (is_riemann() && !gradient_correction && reconstruction != Reconstruction::none)
      refuse("Reconstruction", "its velocity gradients need the gradient correction.",
             "Set 'none', or Gradient correction = true.");
    if (is_halved)
      check_halves();
    if (shape == BirdShape::slab && is_lattice_shifted())
      refuse("Lattice shift", "a slab is whole cells of its lattice.", "Set 0, 0, or shift the aim point.");
    check_strength();
    check_slice();
    check_position();
    if (!is_riemann() && reconstruction != Reconstruction::none)
      refuse("Reconstruction", "the standard formulation has none.", "Set 'none', or Formulation = riemann.");
  }

  void BirdParameters::check_strength() const
  {
    if (!has_strength() && shear_modulus > 0.)
      refuse("Strength/Shear modulus", "it is given, and no Yield stress: a liquid has no shear modulus.",
             "Give Yield stress too, or leave both out.");
    if (!has_strength())
      return;
    if (!(shear_modulus > 0.))
      refuse("Strength/Yield stress", "it is given, and no Shear modulus.",
             "Give it too. Above 100 times the yield stress it changes only the time step, not the flow.");
    if (!is_riemann())
      refuse("Strength/Yield stress", "the standard formulation has no velocity gradients to strain it by.",
             "Set Formulation = riemann, or leave it out.");
    if (!gradient_correction)
      refuse("Strength/Yield stress", "its velocity gradients need the gradient correction.",
             "Set Gradient correction = true, or leave it out.");
  }

  void BirdParameters::check_slice() const
  {
    if (!is_slice() && slice_blades == 0)
      {
        if (!slice_normal.empty())
          refuse("Slice/Normal", "it is given, and no Between: the bird is whole.", "Give both, or leave it out.");
        return;
      }
    if (slice_blades == 1)
      refuse("Slice/Number of blades", "one blade has none before it.", "Give 2 or more, or 0.");
    if (is_slice() && (slice_between.size() != 2 || !(slice_between[0] < slice_between[1])))
      refuse("Slice/Between", "it is no interval.", "Give two distances, in m, the smaller one first.");
    if (!slice_normal.empty() &&
        (slice_normal.size() != 3 || std::hypot(slice_normal[0], slice_normal[1], slice_normal[2]) == 0.))
      refuse("Slice/Normal", "it is no direction.", "Give three numbers that are not all zero.");
    if (shape == BirdShape::slab)
      refuse("Slice/Between", "a slab is not sliced.", "Give its lengths (Slab lengths).");
    if (std::count(is_periodic.begin(), is_periodic.end(), true) > 0)
      refuse("Slice/Between", "a slice cannot be combined with Periodic directions.",
             "Leave it out, since a periodic bird has no ends, or set Periodic directions = none.");
  }

  void BirdParameters::check_position() const
  {
    if (position.empty())
      return;
    if (position.size() != 3)
      refuse("Position", "it is no place.", "Give three numbers.");
    const auto refuse_beside = [this](const std::string &entry) {
      refuse(entry, "it is given beside Position, which says where the bird is at time 0.",
             "Leave one of the two out.");
    };
    if (!aim_span_fraction.empty() || !aim_chord_fraction.empty())
      refuse_beside("Aim span fraction");
    if (chordwise_offset != 0.)
      refuse_beside("Chordwise offset");
    if (stand_off != 0.)
      refuse_beside("Stand-off");
    if (slice_blades > 0)
      refuse("Slice/Number of blades", "it cuts the bird where it aims, and Position is given.",
             "Give the planes by Slice/Between and Normal, or Aim point instead of Position.");
    if (!angle_to_surface.empty())
      refuse("Angle to surface", "it is measured where the bird aims, and Position is given.",
             "Give Velocity, or Speed with Flight direction.");
  }

  void BirdParameters::check_halves() const
  {
    const auto refuse_half = [this](const std::string &entry, const std::string &found, const std::string &action) {
      refuse(entry, found + " has no mirror plane y = 0.", action + ", or compute the whole bird.");
    };
    if (velocity[1] != 0.)
      refuse_half("Velocity", "a velocity of " + number_text(velocity[1]) + " m/s along y", "Let y be 0");
    if (aim_point[1] != 0. || chordwise_offset != 0.)
      refuse_half(aim_point[1] != 0. ? "Aim point" : "Chordwise offset", "an aim beside the plane", "Aim at y = 0");
    if (!position.empty() && position[1] != 0.)
      refuse_half("Position", "a place beside the plane", "Let y be 0");
    if (yaw != 0.)
      refuse_half("Yaw", "a yawed bird", "Set it to 0 (pitch stays in the plane)");
    if (roll != 0.)
      refuse_half("Roll", "a lattice turned about the bird's axis", "Set it to 0");
    if (is_lattice_shifted())
      refuse_half("Lattice shift", "a lattice shifted across the bird's axis", "Set 0, 0");
    if (std::hypot(velocity[1], velocity[2]) < 1e-3 * std::abs(velocity[0]))
      refuse_half("Velocity", "the frame of a bird that flies along x", "Let it fly across the span");
    if (!slice_normal.empty() && slice_normal[1] != 0.)
      refuse_half("Slice/Normal", "a normal with a part along y", "Let y be 0");
    if (packing != BirdLattice::cubic)
      refuse_half("Packing", "the " + bird_lattices().name(packing) + " lattice", "Choose 'cubic'");
    if (!is_riemann())
      refuse("Formulation", "mirror images are written for the riemann formulation.",
             "Set it, or compute the whole bird.");
    if (std::count(is_periodic.begin(), is_periodic.end(), true) > 0)
      refuse("Periodic directions", "they cannot be combined with a symmetry plane.",
             "Set 'none', or compute the whole bird.");
    if (shape == BirdShape::slab)
      refuse("Shape", "a slab is not halved.", "Choose another shape, or compute the whole slab.");
  }
} // namespace birdstrike
