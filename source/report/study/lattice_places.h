#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;

  /// A case with its lattices of particles elsewhere across their birds' axes: "Section/Entry=value" by place.
  ///
  /// The first place is the case's own. From there the places go on as the two-dimensional Kronecker sequence of the
  /// plastic number fills the cell (M. Roberts: The unreasonable effectiveness of quasirandom sequences, 2018), several
  /// birds taking turns, so that of more places the first ones are the same. Throws InputError, naming --places, for no
  /// place or more than 64, and for more than one of a case without birds, with half a bird or with a slab.
  std::vector<std::vector<std::string>> make_lattice_places(const CaseParameters &parameters, std::size_t n_places);

  /// What a quantity of one level came to at all places.
  struct PlaceMean
  {
    double mean;     ///< NaN where a place has no value
    double variance; ///< of one run, with n - 1 degrees of freedom; NaN of one place
  };

  /// Half the 95 % confidence interval of the mean of these values, one a place (Student's t of n - 1 degrees of
  /// freedom); 0 of one value, whose scatter nobody knows.
  double interval_of_mean(const std::vector<double> &values);

  /// Of values with places running fastest, level by level.
  std::vector<PlaceMean> mean_over_places(const std::vector<double> &values, std::size_t n_places);
} // namespace birdstrike
