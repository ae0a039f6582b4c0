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
                      "Simulated time at which the run ends, counted from first contact where a bird flies. [s]",
                      Double(0.));
    prm.add_parameter("Step scale", step_scale,
                      "Share of the blade's largest stable step that is taken; above 1 the run is unstable. [-]",
                      Double(0., 1.));
    prm.add_parameter("Bird step scale", bird_step_scale,
                      "Share of the bird's own step limit that is taken; the limit holds a margin already. [-]",
                      Double(0., 2.));
    prm.add_parameter("Multirate", multirate,
                      "Whether bird and blade each step at their own limit, at an integer ratio. [-]", Bool());
    prm.add_parameter(
      "Maximum ratio", maximum_ratio,
      "Largest number of subcycles: steps of one part within one step of the other. The blade takes more where "
      "its elements become stiffer within that step. [-]",
      Integer(1, 1000));
    prm.add_parameter("Stop at tip peak", stop_at_tip_peak,
                      "Whether the run ends once the tip has passed its first peak after the bird's loading. [-]",
                      Bool());
    prm.add_parameter("Tip peak wait", tip_peak_wait,
                      "The tip's peak has passed when no higher value came for this long. [s]", Double(0.));
    prm.add_parameter("Bird phase tolerance", bird_phase_tolerance,
                      "Bird and contact are dropped once nothing touches and the impulse that the particles left could "
                      "still give is at most this share of the impulse given; 0 waits for the last particle. [-]",
                      Double(0., 1.));
    prm.add_parameter(
      "Smallest step", smallest_step,
      "The run ends as a numerical failure when the stable step of bird or blade falls below this share "
      "of its first value, as when elements are crushed to nothing; 0 never does. [-]",
      Double(0., 1.));
    prm.add_parameter("Energy error limit", energy_error_limit,
                      "The run ends as a numerical failure when the energy error exceeds this share of the initial "
                      "energy. [-]",
                      Double(0.));
    prm.add_parameter("Maximum wall time", maximum_wall_time,
                      "The run ends, with its results written, after this time on the clock; 0 sets no limit. [s]",
                      Double(0.));
    prm.add_parameter("Threads", threads,
                      "Number of threads; results do not depend on it, and 0 takes every core that the process may run "
                      "on. More threads "
                      "than these cores take turns and slow the run down many times: they are not started unless Force "
                      "threads says so. "
                      "[-]",
                      Integer(0, 4096));
    prm.add_parameter("Force threads", forces_threads,
                      "Whether as many threads start as Threads says, even on fewer cores (for tests). [-]", Bool());
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
