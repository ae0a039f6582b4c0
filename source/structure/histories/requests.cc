#include <birdstrike/structure/histories.h>

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/blade.h>

#include <deal.II/base/parameter_handler.h>

namespace birdstrike
{
  void HistoryRequests::declare(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Histories");
    prm.add_parameter("Axes", axes,
                      "Axes of the components in nodes.csv and elements.csv. global: the global axes. blade: span, "
                      "chord and normal of the undeformed blade at the place. Six numbers: a vector along axis 1 and "
                      "one in the plane of axes 1 and 2. [-]");
    prm.add_parameter("Nodes", nodes,
                      "Nodes whose displacement, velocity and acceleration nodes.csv contains, separated by "
                      "semicolons. 'name: x y z': the nearest node. 'name: node 17': the number of field 'node'. [m]");
    prm.add_parameter("Elements", elements,
                      "Elements whose stress, strain and plastic strain elements.csv contains: 'name: x y z | layer' "
                      "or 'name: element 17 | layer', separated by semicolons. The layer is a share of half the "
                      "thickness, from -1 (bottom) to 1 (top). Its nearest integration point is taken, and in a "
                      "laminate the layer itself. Bricks have -1, 0 and 1. Without a layer: 0. [m]");
    prm.add_parameter("Gauges", gauges,
                      "Strain gauges for gauges.csv: 'name: x y z | direction | face', separated by semicolons. "
                      "Direction: span, chord, degrees from the span towards the chord, or a vector. Face: struck, "
                      "other, top or bottom. Without them: span and struck. [m]");
    prm.add_parameter("Stations", stations,
                      "Shares of the span, from the root (0) to below 1, at which sections.csv contains the section's "
                      "force and moment, e.g. '0, 0.1, 0.5'. [-]");
    prm.add_parameter("Patches", patches,
                      "Parts of the surface whose contact force, pressure and impulse patches.csv contains, separated "
                      "by semicolons. The forms are 'name: x y z radius' and 'name: xmin ymin zmin xmax ymax zmax'. A "
                      "part consists of the facets whose undeformed centre lies within. [m]");
    prm.leave_subsection();
  }

  BladeHistories Blade::make_histories(const HistoryRequests &requests) const
  {
    for (const auto &[name, text] : {std::pair("Nodes", &requests.nodes), std::pair("Elements", &requests.elements),
                                     std::pair("Gauges", &requests.gauges), std::pair("Stations", &requests.stations)})
      if (!text->empty())
        throw InputError(std::string("Output/Histories/") + name + " = '" + *text + "', and a blade of kind '" +
                         blade_kinds().name(kind()) +
                         "' does not deform.\nLeave it empty, or set Blade/Kind to shell or solid.");
    return {};
  }
} // namespace birdstrike
