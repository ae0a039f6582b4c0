#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/io/output_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace birdstrike
{
  const NamedChoices<double> &channel_classes()
  {
    static const NamedChoices<double> classes{{"CFC 1000", 1000.}, {"CFC 600", 600.}, {"CFC 180", 180.}, {"none", 0.}};
    return classes;
  }

  const NamedChoices<bool> &blade_geometries()
  {
    static const NamedChoices<bool> choices{{"undeformed", false}, {"deformed", true}};
    return choices;
  }

  const NamedChoices<bool> &removed_particle_choices()
  {
    static const NamedChoices<bool> choices{{"left out", false}, {"fly on", true}};
    return choices;
  }

  void OutputParameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Output");
    prm.add_parameter("Directory", directory, "Folder of the run; empty stands for runs/<case name>. [-]");
    prm.add_parameter("History interval", history_interval,
                      "Simulated time between two rows of the histories; 0 writes every step. [s]", Double(0.));
    prm.add_parameter("Field interval", field_interval,
                      "Simulated time between two field files; 0 writes the first and the last state only. [s]",
                      Double(0.));
    prm.add_parameter("Console interval", console_interval, "Time on the clock between two progress lines. [s]",
                      Double(0.));
    prm.add_parameter(
      "Flush interval", flush_interval,
      "Time on the clock after which history.csv is brought up to date; results.h5 is written at the end. [s]",
      Double(0.));
    prm.add_parameter("Blade fields", blade_fields, "Whether fields of the blade are written for ParaView. [-]",
                      Bool());
    prm.add_parameter("Bird fields", bird_fields, "Whether fields of the bird are written for ParaView. [-]", Bool());
    declare_choice(
      prm, "Blade geometry", is_deformed, blade_geometries(),
      "Where the fields of the blade stand: on the undeformed mesh, to be warped by the field displacement, "
      "or on the deformed one, which any viewer shows as it is. [-]");
    declare_choice(
      prm, "Removed particles", removed_fly_on, removed_particle_choices(),
      "Particles that can meet the blade no more are removed from the computation (Bird/Retire); fields of "
      "the bird leave them out, or let them fly on as they flew, marked by the field removed. [-]");
    prm.add_parameter(
      "HDF5", hdf5,
      "Whether histories and root profiles are also written to results.h5 (HDF5, superblock of version 0, which all "
      "libraries of HDF5 read). [-]",
      Bool());
    prm.add_parameter(
      "Copy inputs", copies_inputs,
      "Whether the run folder keeps copies of all files that the case reads, in its folder inputs, so "
      "that it stands by itself wherever it is moved; else parameters.prm has their absolute paths. [-]",
      Bool());
    declare_choice(prm, "Channel class", channel_class, channel_classes(),
                   "Channel frequency class (SAE J211-1) by which the contact force is filtered, as a load cell's is: "
                   "filtered.csv, results.h5 and its peak in summary.json. [-]");
    histories.declare(prm);
    prm.enter_subsection("Checkpoint");
    prm.add_parameter(
      "Step interval", checkpoints.step_interval,
      "Time steps between two checkpoints, from which 'birdstrike resume' goes on; 0: none by steps. [-]", Integer(0));
    prm.add_parameter("Time interval", checkpoints.time_interval,
                      "Simulated time between two checkpoints; 0: none by it. [s]", Double(0.));
    prm.add_parameter(
      "Wall interval", checkpoints.wall_interval,
      "Time on the clock between two checkpoints: what a run that is killed loses at most; 0: none by it. "
      "[s]",
      Double(0.));
    prm.add_parameter("At the end", checkpoints.at_the_end,
                      "Whether the end of a run is a checkpoint, to go on to a later Time/End time. A run that SIGINT, "
                      "SIGTERM or SIGHUP stops leaves one in any case, SIGUSR1 asks for one. [-]",
                      Bool());
    prm.add_parameter("Keep", checkpoints.n_kept, "Newest checkpoints that are kept; older ones are deleted. [-]",
                      Integer(1));
    prm.leave_subsection();
    prm.leave_subsection();
  }

  void OutputParameters::check() const
  {
    if (!(console_interval > 0.))
      throw InputError("Output/Console interval is 0 s: a line for every step would be most of the work.\n"
                       "  Allowed: a number above 0; 2 is a good value.");
  }
} // namespace birdstrike
