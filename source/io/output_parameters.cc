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
    prm.add_parameter("Directory", directory, "Folder of the run. Empty: runs/<case name>. [-]");
    prm.add_parameter("History interval", history_interval,
                      "Simulated time between two rows of the histories. 0: every step. [s]", Double(0.));
    prm.add_parameter("Field interval", field_interval,
                      "Simulated time between two field files. 0: the first and the last state only. [s]", Double(0.));
    prm.add_parameter("Console interval", console_interval, "Wall-clock time between two progress lines. [s]",
                      Double(0.));
    prm.add_parameter("Flush interval", flush_interval,
                      "Wall-clock time between two updates of history.csv. results.h5 is written at the end. [s]",
                      Double(0.));
    prm.add_parameter("Blade fields", blade_fields, "Output of the blade's fields for ParaView. [-]", Bool());
    prm.add_parameter("Bird fields", bird_fields, "Output of the bird's fields for ParaView. [-]", Bool());
    declare_choice(prm, "Blade geometry", is_deformed, blade_geometries(),
                   "Geometry of the blade's fields. undeformed: the undeformed mesh, to be warped by the field "
                   "displacement. deformed: the deformed mesh, which any viewer shows as it is. [-]");
    declare_choice(
      prm, "Removed particles", removed_fly_on, removed_particle_choices(),
      "Output of particles that Bird/Retire has removed from the computation. left out: fields of the bird do not "
      "contain them. fly on: they continue along their flight, marked by the field removed. [-]");
    prm.add_parameter("HDF5", hdf5,
                      "Output of histories and root profiles to results.h5 as well. The format is HDF5 with a "
                      "superblock of version 0, which all libraries of HDF5 read. [-]",
                      Bool());
    prm.add_parameter("Copy inputs", copies_inputs,
                      "Copies of all files that the case reads, in the folder inputs of the run folder. The run folder "
                      "can then be moved anywhere. false: parameters.prm has their absolute paths. [-]",
                      Bool());
    declare_choice(prm, "Channel class", channel_class, channel_classes(),
                   "Channel frequency class (SAE J211-1) of the filter on the contact force, as for a load cell. The "
                   "filtered force is in filtered.csv and results.h5, its peak in summary.json. [-]");
    histories.declare(prm);
    prm.enter_subsection("Checkpoint");
    prm.add_parameter(
      "Step interval", checkpoints.step_interval,
      "Number of time steps between two checkpoints, from which 'birdstrike resume' continues. 0: none by steps. [-]",
      Integer(0));
    prm.add_parameter("Time interval", checkpoints.time_interval,
                      "Simulated time between two checkpoints. 0: none by simulated time. [s]", Double(0.));
    prm.add_parameter(
      "Wall interval", checkpoints.wall_interval,
      "Wall-clock time between two checkpoints, the most that a killed run loses. 0: none by wall-clock time. [s]",
      Double(0.));
    prm.add_parameter("At the end", checkpoints.at_the_end,
                      "Checkpoint at the end of the run, to continue to a later Time/End time. A run that SIGINT, "
                      "SIGTERM or SIGHUP stops leaves a checkpoint in any case. SIGUSR1 requests one. [-]",
                      Bool());
    prm.add_parameter("Keep", checkpoints.n_kept,
                      "Number of newest checkpoints that are kept. Older ones are deleted. [-]", Integer(1));
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
