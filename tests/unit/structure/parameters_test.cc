#include <birdstrike/core/errors.h>
#include <birdstrike/structure/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <sstream>

namespace birdstrike::parameters_test
{
  namespace
  {
    TEST(BladeParameters, ReadWhatIsWritten)
    {
      BladeParameters          p;
      dealii::ParameterHandler prm;
      p.declare(prm);
      prm.parse_input_from_string("set Kind = rigid\n"
                                  "subsection Mesh\n set Length = 0.5\n set Elements along span = 10\nend\n"
                                  "subsection Supports\n set Held = 3: ux uy; 2: hinged\nend\n"
                                  "subsection Rigid\n set Normal = 0, 1, 1\nend\n");
      EXPECT_EQ(p.kind, BladeKind::rigid);
      EXPECT_EQ(p.mesh.length, 0.5);
      EXPECT_EQ(p.mesh.n_span, 10u);
      EXPECT_EQ(p.supports.held, "3: ux uy; 2: hinged");
      EXPECT_EQ(p.rigid.normal, (std::array<double, 3>{{0., 1., 1.}}));
      EXPECT_NO_THROW(p.check());
    }

    // The handler shows the defaults of the struct, so that they live in one place.
    TEST(BladeParameters, DefaultsAreThoseOfTheStruct)
    {
      BladeParameters          p;
      dealii::ParameterHandler prm;
      p.declare(prm);
      prm.enter_subsection("Mesh");
      EXPECT_EQ(prm.get_double("Chord"), BladeParameters().mesh.chord);
      prm.leave_subsection();
      prm.enter_subsection("Rigid");
      EXPECT_EQ(prm.get("Normal"), "0, 0, 1");
      prm.leave_subsection();
    }

    TEST(BladeParameters, RefusesWhatCannotBe)
    {
      BladeParameters p;
      p.kind         = BladeKind::rigid;
      p.rigid.normal = {{0., 0., 0.}};
      EXPECT_THROW(p.check(), InputError);
      p.kind           = BladeKind::shell;
      p.mesh.generator = MeshGenerator::file;
      EXPECT_THROW(p.check(), InputError);
      p                  = BladeParameters();
      p.element.n_points = 6;
      EXPECT_THROW(p.check(), InputError);
    }

    // A file that would not be read, and a thickness that bricks would not have, are refused, not passed over.
    TEST(BladeParameters, RefusesWhatWouldNotBeUsed)
    {
      for (const BladeKind kind : {BladeKind::shell, BladeKind::solid, BladeKind::rigid})
        {
          BladeParameters p;
          p.kind      = kind;
          p.mesh.file = "blade.msh";
          if (kind == BladeKind::rigid)
            {
              EXPECT_NO_THROW(p.check()) << "a rectangle";
              p.rigid.surface = RigidSurface::mesh;
            }
          EXPECT_THROW(p.check(), InputError);
          p.mesh.generator = MeshGenerator::file;
          EXPECT_NO_THROW(p.check());
        }
      BladeParameters p;
      p.thickness.by_material = "1: 8e-3";
      EXPECT_NO_THROW(p.check());
      p.kind = BladeKind::solid;
      EXPECT_THROW(p.check(), InputError);
    }
  } // namespace
} // namespace birdstrike::parameters_test
