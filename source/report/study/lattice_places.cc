#include "report/study/lattice_places.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t           most_places    = 64;
    constexpr double                plastic_number = 1.3247179572447460; ///< root of x^3 = x + 1
    constexpr std::array<double, 2> increments     = {1. / plastic_number, 1. / (plastic_number * plastic_number)};

    void require_lattices(const CaseParameters &parameters)
    {
      const auto refuse = [](const std::string &found, const std::string &action) {
        throw InputError("--places: " + found + ".\n  Action: " + action + ".");
      };
      if (parameters.birds().empty())
        refuse("there is no bird whose lattice could lie elsewhere", "leave it out");
      if (parameters.has_symmetry_plane)
        refuse("half a bird has its lattice as the plane of symmetry asks for", "--set \"Case/Symmetry plane=none\"");
      for (const BirdCase &each : parameters.birds())
        if (each.bird.shape == BirdShape::slab)
          refuse(each.bird.section + ": a slab is whole cells of its lattice", "another shape, or leave it out");
    }
  } // namespace

  std::vector<std::vector<std::string>> make_lattice_places(const CaseParameters &parameters,
                                                            const std::size_t     n_places)
  {
    if (n_places == 0 || n_places > most_places)
      throw InputError(fmt::format("--places {}.\n  Allowed: 1 to {}.", n_places, most_places));
    if (n_places > 1)
      require_lattices(parameters);
    std::vector<std::vector<std::string>> places(n_places);
    const std::vector<BirdCase>           birds = parameters.birds();
    for (std::size_t k = 1; k < n_places; ++k)
      for (std::size_t b = 0; b < birds.size(); ++b)
        {
          const BirdParameters &bird = birds[b].bird;
          const auto            n    = static_cast<double>((k - 1) * birds.size() + b + 1);
          std::array<double, 2> shift;
          for (unsigned int d = 0; d < 2; ++d)
            shift[d] = std::remainder(bird.lattice_shift[d] + n * increments[d], 1.);
          places[k].push_back(fmt::format("{}/Lattice shift={:.4f}, {:.4f}", bird.section, shift[0], shift[1]));
        }
    return places;
  }

  std::vector<PlaceMean> mean_over_places(const std::vector<double> &values, const std::size_t n_places)
  {
    constexpr double       absent = std::numeric_limits<double>::quiet_NaN();
    const auto             n      = static_cast<double>(n_places);
    std::vector<PlaceMean> means;
    for (std::size_t first = 0; first + n_places <= values.size(); first += n_places)
      {
        double sum = 0., squares = 0.;
        for (std::size_t k = first; k < first + n_places; ++k)
          sum += values[k];
        for (std::size_t k = first; k < first + n_places; ++k)
          squares += (values[k] - sum / n) * (values[k] - sum / n);
        means.push_back({sum / n, n_places > 1 ? squares / (n - 1.) : absent});
      }
    return means;
  }

  double interval_of_mean(const std::vector<double> &values)
  {
    if (values.size() < 2)
      return 0.;
    const auto   n = static_cast<double>(values.size());
    const double t = boost::math::quantile(boost::math::students_t(n - 1.), 0.975);
    return t * std::sqrt(mean_over_places(values, values.size()).at(0).variance / n);
  }
} // namespace birdstrike
