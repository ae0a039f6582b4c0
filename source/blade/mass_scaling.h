#pragma once

#include <birdstrike/blade/node_columns.h>
#include <birdstrike/blade/parameters.h>
#include <birdstrike/blade/reports.h>
#include <birdstrike/blade/solid_elements.h>

#include <span>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  void declare_mass_scaling(dealii::ParameterHandler &prm, BladeParameters::MassScaling &parameters);

  /// Selective mass scaling of a layered solid: how much of it, so that thin layers do not rule the step.
  ///
  /// Every element gets the least factor on its inertia against differences through the thickness (MassScale) with
  /// which its bound allows the wanted step: that of Target step, or, if none is given, 0.95 of what the dimensions in
  /// the plane would allow with any inertia, less where Largest added inertia does not let it. Elements that allow the
  /// step anyway stay as they are.
  ///
  /// What is added is measured by the rotation of the blade as a whole: the largest ratio, over all axes through the
  /// centre of mass, of the added moment of inertia to the blade's own,
  ///   max_w (w.A w)/(w.J w),   A = sum_edges k (|d|^2 1 - d d^T),   J = sum_nodes m (|r|^2 1 - r r^T).
  /// For a plate of width b whose columns have added r^2 per mass it is 12 r^2/b^2, about the slenderest axis: the same
  /// ratio as in the first mode of torsion, whose frequency falls by half of it; bending waves of length L lose half of
  /// (2 pi r/L)^2.
  struct MassScaling
  {
    std::vector<MassScale> scale;    ///< [elements]
    std::vector<double>    coupling; ///< kg, by place in the columns
    MassScalingReport      report;
  };

  /// `nodal_mass` in kg. Throws InputError for a target that no factor reaches or that adds more than allowed.
  MassScaling choose_mass_scaling(const BladeParameters &parameters, const VolumeMesh &mesh, const NodeColumns &columns,
                                  const SolidElements &elements, std::span<const double> nodal_mass);
} // namespace birdstrike
