#include "structure/stress_fields.h"
#include <birdstrike/core/number.h>

#include <Eigen/Eigenvalues>

namespace birdstrike
{
  void add_stress_fields(const std::string &suffix, const std::vector<std::array<double, 6>> &stresses,
                         std::vector<Field> &fields)
  {
    Field tensor{"stress" + suffix, "Pa", true, 6, {}};
    Field largest{"max_principal_stress" + suffix, "Pa", true, 1, {}};
    Field smallest{"min_principal_stress" + suffix, "Pa", true, 1, {}};
    for (const auto &s : stresses)
      {
        tensor.values.insert(tensor.values.end(), s.begin(), s.end());
        Matrix3<double> S;
        S << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
        const Point3 principal =
          Eigen::SelfAdjointEigenSolver<Matrix3<double>>(S, Eigen::EigenvaluesOnly).eigenvalues();
        largest.values.push_back(principal[2]);
        smallest.values.push_back(principal[0]);
      }
    for (Field *field : {&tensor, &largest, &smallest})
      fields.push_back(std::move(*field));
  }
} // namespace birdstrike
