#pragma once

#include "structure/elements/solid/elements.h"
#include <birdstrike/mesh/node_columns.h>
#include <birdstrike/structure/parameters.h>
#include <birdstrike/structure/reports.h>

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
  /// (2 pi r/L)^2. With elements of side a, r^2 is a^2/4 where every element has a cube's step, whatever the layers,
  /// and a^2/2 at 0.95 of the plane's: errors vanish with the mesh as its own do. Two levels of inertia, one for what
  /// is linear through the thickness and one for the rest, would save no more than the t^2/12 that the nodes have
  /// already.
  ///
  /// Measured, plate of 311.2 x 88.9 x 4.27 mm in 56 x 16 columns, first five frequencies in Hz:
  ///   layers  added   step, us         without               with
  ///   1       0.010   0.549 -> 0.648   36.874 230.139 254.117 645.59 711.68   36.868 229.879 252.835 643.85 711.68
  ///   2       0.010   0.324 -> 0.617   36.953 230.718 254.825 647.61 711.73   36.947 230.458 253.543 645.86 711.73
  ///   4       0.010   0.167 -> 0.604   36.968 230.818 254.742 647.90 711.74   36.962 230.557 253.459 646.16 711.74
  ///   4       0.020   0.167 -> 0.660                                          36.956 230.296 252.190 644.41 711.74
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
