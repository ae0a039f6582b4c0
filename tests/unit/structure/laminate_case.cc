#include "laminate_case.h"

namespace laminate_case
{
  Ply carbon()
  {
    Ply ply;
    ply.density    = 1600.;
    ply.young_1    = 138e9;
    ply.young_2    = 9e9;
    ply.poisson_12 = 0.3;
    ply.shear_12 = ply.shear_13 = 6.9e9;
    ply.shear_23                = 3.4e9;
    return ply;
  }

  Ply of_ratio(const double young, const double shear_12, const double shear_23)
  {
    Ply ply;
    ply.density    = 1.;
    ply.young_1    = young;
    ply.young_2    = 1.;
    ply.poisson_12 = 0.25;
    ply.shear_12 = ply.shear_13 = shear_12;
    ply.shear_23                = shear_23;
    return ply;
  }

  std::vector<PlyLayer> equal_plies(const std::vector<double> &angles)
  {
    std::vector<PlyLayer> plies;
    for (const double angle : angles)
      plies.push_back({angle, 1. / angles.size()});
    return plies;
  }

  ShellSection section_of(const Ply &ply, const std::vector<PlyLayer> &plies, const ShellFormulation formulation,
                          const Point3 &reference)
  {
    ShellSection section;
    section.formulation = formulation;
    section.laminate    = std::make_shared<Laminate>(ply, plies, reference);
    return section;
  }

  ABD lamination_theory(const std::vector<Ply> &of, const std::vector<PlyLayer> &plies, const double thickness)
  {
    ABD    result;
    double z = -0.5 * thickness;
    for (const PlyLayer &ply : plies)
      {
        const Ply      &p     = of[ply.material];
        const double    nu_21 = p.poisson_12 * p.young_2 / p.young_1, d = 1. - p.poisson_12 * nu_21;
        const double    Q11 = p.young_1 / d, Q22 = p.young_2 / d, Q12 = p.poisson_12 * p.young_2 / d, Q66 = p.shear_12;
        const double    c = std::cos(ply.angle * M_PI / 180.), s = std::sin(ply.angle * M_PI / 180.);
        const double    c2 = c * c, s2 = s * s;
        const double    q11 = Q11 * c2 * c2 + 2. * (Q12 + 2. * Q66) * s2 * c2 + Q22 * s2 * s2;
        const double    q22 = Q11 * s2 * s2 + 2. * (Q12 + 2. * Q66) * s2 * c2 + Q22 * c2 * c2;
        const double    q12 = (Q11 + Q22 - 4. * Q66) * s2 * c2 + Q12 * (s2 * s2 + c2 * c2);
        const double    q66 = (Q11 + Q22 - 2. * Q12 - 2. * Q66) * s2 * c2 + Q66 * (s2 * s2 + c2 * c2);
        const double    q16 = (Q11 - Q12 - 2. * Q66) * s * c * c2 + (Q12 - Q22 + 2. * Q66) * s * s2 * c;
        const double    q26 = (Q11 - Q12 - 2. * Q66) * s * s2 * c + (Q12 - Q22 + 2. * Q66) * s * c * c2;
        Matrix3<double> Q;
        Q << q11, q12, q16, q12, q22, q26, q16, q26, q66;
        const double top = z + ply.share * thickness;
        result.A += (top - z) * Q;
        result.B += 0.5 * (top * top - z * z) * Q;
        result.D += (top * top * top - z * z * z) / 3. * Q;
        z = top;
      }
    return result;
  }

  ABD lamination_theory(const Ply &p, const std::vector<PlyLayer> &plies, const double thickness)
  {
    return lamination_theory(std::vector<Ply>{p}, plies, thickness);
  }

  Ply isotropic(const double young, const double poisson, const double density)
  {
    Ply ply;
    ply.density = density;
    ply.young_1 = ply.young_2 = young;
    ply.poisson_12            = poisson;
    ply.shear_12 = ply.shear_13 = ply.shear_23 = 0.5 * young / (1. + poisson);
    return ply;
  }

  ShellSection section_of(const std::vector<Ply> &of, const std::vector<PlyLayer> &plies,
                          const ShellFormulation formulation)
  {
    ShellSection section;
    section.formulation = formulation;
    section.laminate    = std::make_shared<Laminate>(of, plies, Point3::UnitX());
    return section;
  }
} // namespace laminate_case
