#include "io/scene_size.h"
#include <birdstrike/bird/packing.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/io/case_parameters.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double most_particles = 4e9;     ///< numbered with 32 bits
    constexpr double most_nodes     = 4e9 / 6; ///< so are their unknowns

    // Largest memory of a run, bytes: resident set over that of a small one. 131 000 particles with contact and fields
    // on their way to the disk (a checkpoint goes there as it is described); 60 000 shells, 15 000 bricks in one layer.
    constexpr double with_checkpoint_particle = 1500., with_checkpoint_element = 2000., with_checkpoint_node = 2000.;

    double price_of_particle(const OutputParameters &output)
    {
      return output.checkpoints.are_planned() ? with_checkpoint_particle : prices::building_particle;
    }

    double count_computed(const BirdParameters &bird, const bool is_halved)
    {
      return count_particles(bird) / (is_halved ? 2. : 1.);
    }

    std::string gibibytes(const double bytes)
    {
      return fmt::format("{:.3g} GiB", bytes / (1024. * 1024. * 1024.));
    }

    std::string describe_bird(const BirdParameters &bird, const double n_particles)
    {
      const Shape shape(bird);
      return fmt::format("{6}, {1:.4g} m long and {2:.4g} m thick by {3}, takes {4:.3g} particles at {0}/Particle "
                         "spacing = {5:g} m.",
                         bird.section, shape.whole_length(), shape.whole_diameter(),
                         shape.is_slab() ? bird.section + "/Slab lengths"
                                         : fmt::format("{0}/Mass = {1:g} kg and {0}/Density = {2:g} kg/m^3",
                                                       bird.section, bird.mass, bird.density),
                         n_particles, bird.spacing, shape.is_slice() ? "A slice of the bird" : "The bird");
    }

    std::string describe_mesh(const BladeParameters &blade, const SceneSize &size)
    {
      const MeshParameters &mesh = blade.mesh;
      return fmt::format("The blade takes {:.3g} elements and {:.3g} nodes by Blade/Mesh/Elements along span = {}, "
                         "Elements along chord = {}{}.",
                         size.n_elements, size.n_nodes, mesh.n_span, mesh.n_chord,
                         blade.kind == BladeKind::solid ? fmt::format(", Layers = {}", mesh.n_layers) : "");
    }
  } // namespace

  SceneSize compute_scene_size(const CaseParameters &parameters)
  {
    SceneSize size;
    for (const BirdCase &each : parameters.birds())
      size.n_particles += count_computed(each.bird, parameters.has_symmetry_plane);
    const BladeParameters &blade = parameters.blade;
    if (blade.is_deformable() || (blade.kind == BladeKind::rigid && blade.rigid.surface == RigidSurface::mesh))
      {
        const auto counts = blade.count_generated(blade.kind == BladeKind::solid);
        size.n_elements   = counts.elements;
        size.n_nodes      = counts.nodes;
      }
    const bool is_archived = parameters.output.checkpoints.are_planned();
    size.bytes_of_bird     = price_of_particle(parameters.output) * size.n_particles;
    size.bytes_of_blade    = (is_archived ? with_checkpoint_element : prices::building_element) * size.n_elements +
                          (is_archived ? with_checkpoint_node : prices::building_node) * size.n_nodes;
    return size;
  }

  void require_memory(const CaseParameters &parameters, const double available)
  {
    const SceneSize size   = compute_scene_size(parameters);
    const double    needed = size.bytes_of_bird + size.bytes_of_blade;
    if (needed <= available && size.n_particles <= most_particles && size.n_nodes <= most_nodes)
      return;
    const std::string found =
      fmt::format("The case needs about {} of memory; {} are there.\n", gibibytes(needed), gibibytes(available));
    if (size.bytes_of_blade > size.bytes_of_bird)
      throw InputError(found + describe_mesh(parameters.blade, size) + "\nReduce these numbers.");
    const double          left    = std::max(0.1 * available, 0.9 * available - size.bytes_of_blade);
    const double          fitting = std::min(left / price_of_particle(parameters.output), most_particles);
    const auto            birds   = parameters.birds();
    const BirdParameters &largest =
      std::max_element(birds.begin(), birds.end(), [](const BirdCase &a, const BirdCase &b) {
        return count_particles(a.bird) < count_particles(b.bird);
      })->bird;
    const double spacing = largest.spacing * std::cbrt(size.n_particles / fitting);
    throw InputError(
      found + describe_bird(largest, count_computed(largest, parameters.has_symmetry_plane)) +
      fmt::format("\nIf that is its size, set {}/Particle spacing to {:.2g} m or more.", largest.section, spacing));
  }
} // namespace birdstrike
