#pragma once

#include <birdstrike/bird/packing.h>
#include <birdstrike/bird/rates.h>
#include <birdstrike/bird/retirement.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/energy_report.h>
#include <birdstrike/core/fields.h>
#include <birdstrike/core/half_kick.h>
#include <birdstrike/core/step_limit.h>

#include <functional>
#include <memory>
#include <string>

namespace birdstrike
{
  /// The SPH bird: particles, their neighbour list and their rates, advanced by velocity Verlet. SI units.
  ///
  ///   kick(dt/2, first)    v += f dt/2m,  mu compressed over dt/2
  ///   drift(dt)            x += v dt
  ///   update_neighbor_list()  rebuilt when its skin is used up
  ///   compute_rates()      at v + f_old dt/2m and at mu compressed further, both predicted to the end of the step; the
  ///                        second kick then corrects them with the new rates (trapezoidal rule)
  ///   kick(dt/2, second)
  ///
  /// Where forces leap, as in the first steps of a shock, the rates are evaluated again at what new and old ones
  /// predict together: whenever the energy that the prediction makes (compute_prediction_error), summed over the bird,
  /// is more than a ten-thousandth of that with which it closes in.
  ///
  /// What the liquid stores is the energy of its equation of state at the present densities; what it dissipates is the
  /// integral of its rate (rates.h), trapezoidal as everything. Beside them stands an energy equation, `internal`: the
  /// pairwise work at the predicted velocity, corrected by each half kick to the velocity of the drift. Kinetic energy
  /// with staggering (core/energy_report.h) + internal - contact work is constant to round-off. Internal less stored
  /// and dissipated is what the integration of density and heat in time is wrong by, mostly the error of prediction.
  ///
  /// A bird with strength carries a deviatoric stress beside the pressure (bird/strength.h): its rates are predicted
  /// and kicked as those of the density, what shear stores is part of the elastic energy and plastic work of the
  /// dissipated.
  ///
  /// Raises NumericalFailure from compute_rates (density, motion), InputError from the constructor. Knows no blade:
  /// contact adds to what clear_contact_forces() hands over, before compute_rates(). Reports are of the whole bird
  /// where half of it is computed; `state`, `points` and `snapshot` are what is computed.
  class Bird
  {
  public:
    Bird(const BirdParameters &parameters, const EosParameters &eos, ThreadPool &pool);

    /// Puts the bird at its start (again): undeformed, at its velocity.
    void place();

    /// Moves the undeformed bird by t seconds (t may be negative) in closed form, seen from a frame of that velocity
    /// (m/s).
    void advance_in_flight(double t, const Point3 &frame = Point3::Zero());

    /// The speed (m/s) at which the surface is met: the slope of the liquid's shock curve, which contact takes, is that
    /// of this speed, the same in every frame, and so is the energy that errors of prediction are measured by. Without
    /// this call it is the bird's own speed.
    void set_closing_speed(double speed);

    /// shocked_step() at the closing speed, s. Contact with light blades is softened for it.
    double strike_step() const
    {
      return step_of_strike;
    }

    /// Longest step behind the shock of a rigid surface that is met at the speed (m/s): h/(c + 1.2 v) with the sound
    /// speed of the Hugoniot state.
    double shocked_step(double speed) const;

    /// Overwrites position, velocity and mu particle by particle, for verification; evaluates the rates.
    void set_state(const std::function<void(Point3 &x, Point3 &v, double &mu)> &state);

    void kick(double dt, HalfKick half)
    {
      kick(dt, half, dt);
    }
    /// Where contact acts in several steps within one of the bird: in this half kick for contact_dt (s) only, and in
    /// kick_contact() between the drifts.
    void        kick(double dt, HalfKick half, double contact_dt);
    void        kick_contact(double dt, HalfKick half);
    void        drift(double dt);
    void        update_neighbor_list();
    PointForces clear_contact_forces(); ///< contact adds to them
    void        compute_rates();

    /// CFL h/(c + 1.2 largest approach speed): not the bird's own speed; isolated particles have no vote. Where c at
    /// rest is that of bubbles, never longer than strike_step(): one step would carry such a liquid past its pores.
    StepLimit step_limit() const;
    double    step_price() const; ///< ns, core/prices.h

    /// Removes loose particles whose path misses the box grown by the margin of the parameters; returns their number.
    std::size_t retire(const Box &blade_box);

    /// All that the next step depends on, particle by particle.
    void archive(Archive &archive);

    PointsView     points() const;
    EnergyReport   energies() const;
    MomentumReport momenta() const;
    FieldSnapshot  snapshot(std::size_t first_id = 0) const; ///< ids from there on
    std::size_t    n_particles() const;
    std::string    summary() const;

    const Particles &state() const
    {
      return particles;
    }
    const Packing &packing() const
    {
      return packed;
    }
    /// Evaluations that were done again at a better prediction.
    unsigned long n_second_evaluations() const
    {
      return n_second;
    }
    std::size_t n_list_builds() const
    {
      return list.n_builds();
    }
    const RetiredShare &retired() const
    {
      return retired_share;
    }

  private:
    bool   is_badly_predicted() const;
    void   relax_prediction();
    void   predict_velocity_gradients();
    void   kick_stress(double dt);
    void   book_contact(double dt);
    void   follow_step(double new_half_step, double new_contact_half);
    double stored_energy(double mu) const;    ///< J/kg
    double shear_energy(std::size_t p) const; ///< J/kg, of a particle

    BirdParameters         parameters;
    EquationOfState        eos;
    ThreadPool            &pool;
    Shape                  shape;
    Packing                packed;
    Particles              particles;
    NeighborList           list;
    std::unique_ptr<Rates> rates;
    Particles::Column      particle_masses;        ///< kg, the same number for every particle: contact sees an array
    double                 half_step         = 0.; ///< s, of the latest first kick
    double                 staggered_half    = 0.; ///< s, that the staggering refers to, and of contact
    double                 staggered_contact = 0.;
    double                 staggering        = 0.; ///< J, by changes of the step
    double                 hugoniot_slope    = 0.;
    double                 struck_sound      = 0.;    ///< m/s, EquationOfState::struck_sound_speed
    double                 shock_pressure    = 0.;    ///< over rho0 c0^2
    double                 step_of_strike    = 0.;    ///< s
    double                 closing_energy    = 0.;    ///< J
    bool                   is_soft           = false; ///< until it is struck: struck_sound is not that at rest
    unsigned long          n_second          = 0;
    bool                   has_contact_force = false;
    std::uint64_t          revision          = 0;
    RetiredShare           retired_share;
    double                 contact_work = 0.;
    Point3                 contact_impulse{0., 0., 0.};
  };
} // namespace birdstrike
