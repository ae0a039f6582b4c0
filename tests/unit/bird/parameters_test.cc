#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(BirdParameters, AreReadFromTheirSection)
{
  BirdParameters           parameters;
  dealii::ParameterHandler prm;
  parameters.declare(prm);
  prm.parse_input_from_string("subsection Bird\n set Mass = 0.0826\n set Velocity = 0, 243.2, 179.3\n"
                              " set Shape = hemispherical cylinder\nend\n");
  EXPECT_EQ(parameters.mass, 0.0826);
  EXPECT_EQ(parameters.velocity[1], 243.2);
  EXPECT_EQ(parameters.shape, BirdShape::hemispherical_cylinder);
  EXPECT_NO_THROW(parameters.check());
}

TEST(BirdParameters, RefuseWhatCannotBeRun)
{
  const auto refuses = [](const auto &spoil) {
    BirdParameters parameters;
    spoil(parameters);
    try
      {
        parameters.check();
      }
    catch (const InputError &error)
      {
        return std::string(error.what()).find("Section 'Bird'") == 0;
      }
    return false;
  };
  EXPECT_TRUE(refuses([](BirdParameters &p) { p.spacing = 0.05; }));
  EXPECT_TRUE(refuses([](BirdParameters &p) { p.shape = BirdShape::slab; }));
  EXPECT_TRUE(refuses([](BirdParameters &p) { p.is_periodic = {{true, true, false}}; }));
  EXPECT_TRUE(refuses([](BirdParameters &p) { p.kernel = SmoothingKernel::cubic_spline; }));
  EXPECT_TRUE(refuses([](BirdParameters &p) {
    p.shape              = BirdShape::hemispherical_cylinder;
    p.length_to_diameter = 0.8;
  }));
  EXPECT_TRUE(refuses([](BirdParameters &p) {
    p.formulation    = ParticleFormulation::standard;
    p.reconstruction = Reconstruction::linear;
  }));
  EXPECT_FALSE(refuses([](BirdParameters &) {}));
}
