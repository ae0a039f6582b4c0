#pragma once

#include "solid_harness.h"

namespace solid_harness
{
  /// Quarter of a cylinder about z: 3 n^2 bricks a section (a square and two blocks around it), n_z layers.
  Mesh make_quarter_cylinder(unsigned int n, unsigned int n_z, double radius, double height);
  /// An eighth of a thick sphere: three blocks, each of n_angle^2 bricks around an axis, n_radius layers: no brick
  /// touches a pole.
  Mesh make_octant(unsigned int n_angle, unsigned int n_radius, double inner, double outer);
} // namespace solid_harness
