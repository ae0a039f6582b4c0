#include <birdstrike/core/errors.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/time_control/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace birdstrike
{
  void TimeParameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Time");
    prm.add_parameter("End time", end_time,
                      "Simulated time at which the run ends. Where a bird flies, it counts from first contact. [s]",
                      Double(0.));
    prm.add_parameter("Step scale", step_scale,
                      "Time step of the blade as a share of its largest stable step. Above 1 the run is unstable. [-]",
                      Double(0., 1.));
    prm.add_parameter("Bird step scale", bird_step_scale,
                      "Time step of the bird as a share of its own limit. The limit already includes a margin. [-]",
                      Double(0., 2.));
    prm.add_parameter("Multirate", multirate,
                      "Subcycling: bird and blade each step at their own limit, at an integer ratio. [-]", Bool());
    prm.add_parameter(
      "Maximum ratio", maximum_ratio,
      "Largest number of subcycles: steps of one part within one step of the other. The blade takes more where "
      "its elements become stiffer within that step. [-]",
      Integer(1, 1000));
    prm.add_parameter("Stop at tip peak", stop_at_tip_peak,
                      "End of the run once the tip has passed its first peak after the bird's loading. [-]", Bool());
    prm.add_parameter("Tip peak wait", tip_peak_wait,
                      "Time without a higher value after which the tip's peak has passed. [s]", Double(0.));
    prm.add_parameter("Bird phase tolerance", bird_phase_tolerance,
                      "Share of the impulse at which the bird phase ends. Bird and contact are removed once nothing is "
                      "in contact and the remaining particles could add at most this share of the impulse so far. 0: "
                      "the phase ends with the last particle. [-]",
                      Double(0., 1.));
    prm.add_parameter("Smallest step", smallest_step,
                      "Smallest stable step of bird or blade, as a share of its first value. Below it, as when "
                      "elements are crushed to nothing, the run ends as a numerical failure. 0: no limit. [-]",
                      Double(0., 1.));
    prm.add_parameter(
      "Energy error limit", energy_error_limit,
      "Largest energy error as a share of the initial energy. Above it the run ends as a numerical failure. [-]",
      Double(0.));
    prm.add_parameter("Maximum wall time", maximum_wall_time,
                      "Wall-clock time at which the run ends, with its results written. 0: no limit. [s]", Double(0.));
    prm.add_parameter(
      "Threads", threads,
      "Number of threads. Results do not depend on it. 0: all cores that the process may run on. More threads than "
      "these cores take turns and slow the run down many times: they are started only with Force threads. [-]",
      Integer(0, 4096));
    prm.add_parameter("Force threads", forces_threads, "Start of all Threads, even on fewer cores (for tests). [-]",
                      Bool());
    prm.leave_subsection();
  }

  void TimeParameters::check() const
  {
    const auto require_positive = [](const double value, const std::string &entry) {
      if (!(value > 0.))
        throw InputError("Time/" + entry + " is " + number_text(value) + ".\n  Allowed: a number above 0.");
    };
    require_positive(end_time, "End time");
    require_positive(step_scale, "Step scale");
    require_positive(bird_step_scale, "Bird step scale");
    require_positive(energy_error_limit, "Energy error limit");
  }

  unsigned int TimeParameters::n_threads() const
  {
    const auto n_cores = static_cast<unsigned int>(usable_cores());
    return threads == 0 ? n_cores : forces_threads ? threads : std::min(threads, n_cores);
  }
} // namespace birdstrike
