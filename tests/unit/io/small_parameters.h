#pragma once

#include <birdstrike/core/errors.h>
#include <birdstrike/io/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

/// A few parameters of every kind, so that reading is tested without the real rooms.
struct SmallParameters
{
  double       mass     = 1.8;
  double       velocity = 177.4;
  unsigned int count    = 5;
  bool         friction = false;
  std::string  shape    = "hemispherical";
  std::string  title;
  double       thickness = 0.00427;

  void declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Bird");
    prm.add_parameter("Mass", mass, "Mass of the bird. [kg]", Double(0., 10.));
    prm.add_parameter("Shape", shape, "Shape of the bird. [-]", Selection("flat|hemispherical"));
    prm.add_parameter("Title", title, "Any text. [-]");
    prm.enter_subsection("Flight");
    prm.add_parameter("Velocity", velocity, "Speed along the path. [m/s]", Double());
    prm.leave_subsection();
    prm.leave_subsection();
    prm.enter_subsection("Blade");
    prm.add_parameter("Thickness", thickness, "Thickness of the plate. [m]", Double(0.));
    prm.add_parameter("Count", count, "Number of points. [-]", Integer(1, 7));
    prm.add_parameter("Friction", friction, "Whether the surface is rough. [-]", Bool());
    prm.leave_subsection();
  }

  void check() const
  {
    if (!(mass > 0.))
      throw birdstrike::InputError("Bird/Mass is 0.");
  }
};

/// The parameters with the file that reads them.
struct SmallCase
{
  SmallParameters           values;
  birdstrike::ParameterFile file{{birdstrike::ParameterGroup::of(values)}};
};
