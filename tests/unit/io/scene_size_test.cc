#include "io/scene_size.h"
#include <birdstrike/bird/packing.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scratch_folder.h"

using namespace birdstrike;

namespace
{
  template <int dim>
  void expect_mesh(const SceneSize &size, const BladeParameters &blade, const std::string &where)
  {
    const BladeMesh<dim> mesh(blade);
    EXPECT_EQ(size.n_elements, static_cast<double>(mesh.cells.size())) << where;
    EXPECT_EQ(size.n_nodes, static_cast<double>(mesh.nodes.size())) << where;
  }

  void expect_counts(const std::string &file, const std::vector<std::string> &overrides)
  {
    CaseParameters parameters;
    parameters.read(file, overrides);
    const SceneSize   size  = compute_scene_size(parameters);
    const std::string where = file + (overrides.empty() ? "" : " " + overrides.back());
    if (parameters.blade.mesh.generator == MeshGenerator::file) // its size is known when it is read
      EXPECT_EQ(size.n_elements, 0.) << where;
    else if (parameters.blade.kind == BladeKind::shell)
      expect_mesh<2>(size, parameters.blade, where);
    else if (parameters.blade.kind == BladeKind::solid)
      expect_mesh<3>(size, parameters.blade, where);
    else
      EXPECT_EQ(size.n_elements, 0.) << where;
  }

  std::string refusal_for_memory(const std::string &file, const std::vector<std::string> &overrides,
                                 const double available)
  {
    CaseParameters parameters;
    parameters.read(file, overrides);
    try
      {
        require_memory(parameters, available);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(SceneSize, CountsElementsAndNodesOfEveryShippedCaseExactly)
{
  for (const auto &entry : std::filesystem::directory_iterator(BIRDSTRIKE_SOURCE_DIR "/prm"))
    if (entry.path().extension() == ".prm")
      expect_counts(entry.path().string(), {});
  const std::string frontal = BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm", layers = "Blade/Mesh/Layers=3";
  expect_counts(frontal, {"Blade/Kind=solid", layers});
  expect_counts(frontal, {"Case/Symmetry plane=y"});
  expect_counts(frontal, {"Blade/Kind=solid", layers, "Case/Symmetry plane=y"});
  expect_counts(BIRDSTRIKE_SOURCE_DIR "/prm/fan-blade.prm", {"Blade/Kind=solid"});
}

/// The bound that count_particles states: a sixth of the outermost layer, surface over spacing squared.
TEST(SceneSize, CountsParticlesOfEveryShapeAndPackingWithinAShareOfTheirOutermostLayer)
{
  for (const auto &[shape, ratio] :
       {std::pair("cylinder", 2.), std::pair("cylinder", 0.5), std::pair("hemispherical cylinder", 2.),
        std::pair("ellipsoid", 1.5), std::pair("sphere", 1.), std::pair("slab", 1.)})
    for (const char *packing : {"cubic", "fcc"})
      for (const double spacing : {0.0121, 0.008, 0.00555, 0.004, 0.0027, 0.0019})
        {
          CaseParameters parameters;
          parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/bird-free.prm",
                          {"Bird/Shape=" + std::string(shape), "Bird/Length over diameter=" + std::to_string(ratio),
                           "Bird/Packing=" + std::string(packing), "Bird/Particle spacing=" + std::to_string(spacing),
                           "Bird/Slab lengths=0.05, 0.04, 0.06"});
          const Shape  bird(parameters.bird);
          const double built   = static_cast<double>(compute_packing(parameters.bird, bird).points.size());
          const double counted = compute_scene_size(parameters).n_particles;
          // of a body of revolution no more than of its cylinder
          const double layer = M_PI * bird.diameter() * (0.5 * bird.diameter() + bird.length()) / (spacing * spacing);
          if (bird.is_slab())
            EXPECT_EQ(counted, built) << packing << ", " << spacing;
          else
            EXPECT_LT(std::abs(counted - built), layer / 6.) << shape << ", " << packing << ", " << spacing;
        }
}

TEST(SceneSize, RefusesWhatMemoryCannotHoldAndNamesTheEntries)
{
  const std::string frontal = BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm";
  EXPECT_EQ(refusal_for_memory(frontal, {}, 1e9), "");
  const std::string bird = refusal_for_memory(frontal, {}, 1e6);
  EXPECT_NE(bird.find("Bird/Particle spacing = 0.0025 m"), std::string::npos) << bird;
  EXPECT_NE(bird.find("Bird/Density = 950 kg/m^3"), std::string::npos) << bird;
  const std::string blade = refusal_for_memory(frontal, {"Blade/Mesh/Elements along span=300"}, 1e7);
  EXPECT_NE(blade.find("Elements along chord = 18"), std::string::npos) << blade;
}

TEST(SceneSize, AdvisesASpacingThatFits)
{
  const std::string frontal = BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm";
  const std::string text    = refusal_for_memory(frontal, {}, 1e7);
  const std::size_t at      = text.rfind("spacing to ");
  ASSERT_NE(at, std::string::npos) << text;
  const std::string spacing = text.substr(at + 11, text.find(" m or", at) - at - 11);
  EXPECT_EQ(refusal_for_memory(frontal, {"Bird/Particle spacing=" + spacing}, 1e7), "");
}

TEST(SceneSize, ReadingRefusesAtOnceWhatNoMachineHolds)
{
  const ScratchFolder scratch;
  const std::string   file = scratch.write("case.prm", "");
  for (const char *entry : {"Bird/Particle spacing=1e-6", "Bird/Density=9.5e-10"})
    EXPECT_THROW(CaseParameters().read(file, {entry}), InputError) << entry;
  EXPECT_THROW(CaseParameters().read(file, {"Blade/Mesh/Elements along span=100000",
                                            "Blade/Mesh/Elements along chord=100000", "Case/Symmetry plane=y"}),
               InputError);
}
