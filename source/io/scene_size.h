#pragma once

namespace birdstrike
{
  struct CaseParameters;

  /// How much of everything a case holds, known from its entries before anything is built: of what is computed, which
  /// is half of it with a plane of symmetry. A mesh from a file counts as nothing, for its file says what it holds.
  struct SceneSize
  {
    double n_particles = 0.; ///< bird/packing.h: count_particles
    double n_elements = 0., n_nodes = 0.;
    double bytes_of_bird = 0., bytes_of_blade = 0.; ///< largest while the scene is built (core/prices.h)
                                                    ///< or, where checkpoints are planned, written
  };

  SceneSize compute_scene_size(const CaseParameters &parameters);

  /// Throws InputError, naming the entries that make it so large, for a scene that needs more than `available` bytes or
  /// more particles or nodes than have numbers.
  void require_memory(const CaseParameters &parameters, double available);
} // namespace birdstrike
