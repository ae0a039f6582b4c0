#include "material/pressure_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t n_bins = 2048; // 4 KiB

    /// Gauss' points of [-1, 1], of which the others are mirror images, and their weights.
    constexpr std::array<std::array<double, 2>, 4> gauss{{{{0.1834346424956498, 0.3626837833783620}},
                                                          {{0.5255324099163290, 0.3137066458778873}},
                                                          {{0.7966664774136267, 0.2223810344533745}},
                                                          {{0.9602898564975363, 0.1012285362903763}}}};
  } // namespace

  PressureTable::PressureTable(const std::vector<Point> &points)
  {
    pieces.push_back({0., 0., points[0].slope, 0., 0., 0.});
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      {
        const Point &a = points[k], &b = points[k + 1];
        const double h = b.mu - a.mu, secant = (b.pressure - a.pressure) / h;
        pieces.push_back({a.mu, a.pressure, a.slope, (3. * secant - 2. * a.slope - b.slope) / h,
                          (a.slope + b.slope - 2. * secant) / (h * h), 0.});
      }
    pieces.push_back({points.back().mu, points.back().pressure, points.back().slope, 0., 0., 0.});

    bins_per_mu = n_bins / last_mu();
    first_in_bin.resize(n_bins);
    for (std::size_t b = 0, k = 1; b < n_bins; ++b)
      {
        while (k + 2 < pieces.size() && pieces[k + 1].start * bins_per_mu <= static_cast<double>(b))
          ++k;
        first_in_bin[b] = static_cast<std::uint16_t>(k);
      }
    for (std::size_t k = 2; k < pieces.size(); ++k) // up to where pieces[k] starts, that of k - 1 answers
      pieces[k].stored = energy(std::nextafter(pieces[k].start, 0.));
  }

  void PressureTable::choose_slopes(std::vector<Point> &points)
  {
    const auto length = [&](const std::size_t k) { return points[k + 1].mu - points[k].mu; };
    const auto secant = [&](const std::size_t k) { return (points[k + 1].pressure - points[k].pressure) / length(k); };
    const auto n      = points.size();
    const double straight = secant(0);
    if (n == 2)
      points[0].slope = points[1].slope = straight;
    if (n == 2)
      return;
    for (std::size_t k = 1; k + 1 < n; ++k)
      {
        const double before = length(k - 1) + 2. * length(k), after = 2. * length(k - 1) + length(k);
        points[k].slope = (before + after) / (before / secant(k - 1) + after / secant(k));
      }
    const auto   without_curvature = [](const double other) { return 0.5 * (3. - other); };
    const double at_first = points[1].slope / straight, at_last = points[n - 2].slope / secant(n - 2);
    points[0].slope     = straight * (at_first >= 1. && at_first <= 2. ? 1. / at_first : without_curvature(at_first));
    points[n - 1].slope = secant(n - 2) * (at_last <= 1. ? 2. - at_last : without_curvature(at_last));
  }

  std::size_t PressureTable::find(const double mu) const
  {
    if (!(mu > 0.))
      return 0;
    const double at = mu * bins_per_mu;
    if (!(at < static_cast<double>(n_bins)))
      return pieces.size() - 1;
    std::size_t k = first_in_bin[static_cast<std::size_t>(at)];
    while (k + 1 < pieces.size() && pieces[k + 1].start <= mu)
      ++k;
    return k;
  }

  double PressureTable::pressure(const double mu) const
  {
    const Piece &piece = pieces[find(mu)];
    const double s     = mu - piece.start;
    return piece.value + s * (piece.first + s * (piece.half + s * piece.sixth));
  }

  double PressureTable::slope(const double mu) const
  {
    const Piece &piece = pieces[find(mu)];
    const double s     = mu - piece.start;
    return piece.first + s * (2. * piece.half + s * (3. * piece.sixth));
  }

  Lanes PressureTable::pressure(const Lanes mu) const
  {
    return Lanes([&](const auto k) { return pressure(static_cast<double>(mu[k])); });
  }

  Lanes PressureTable::slope(const Lanes mu) const
  {
    return Lanes([&](const auto k) { return slope(static_cast<double>(mu[k])); });
  }

  double PressureTable::energy(const double mu) const
  {
    const std::size_t k     = find(mu);
    const Piece      &piece = pieces[k];
    const double      u = 1. + piece.start, s = mu - piece.start;
    if (k == 0 || k + 1 == pieces.size())
      {
        const double eta = s / (u + s), log = std::log1p(s / u);
        return piece.stored + piece.value * eta / u + piece.first * (log - eta);
      }
    double sum = 0.;
    for (const auto &[place, weight] : gauss)
      for (const double side : {-1., 1.})
        {
          const double at = 0.5 * s * (1. + side * place), v = u + at;
          sum += weight * (piece.value + at * (piece.first + at * (piece.half + at * piece.sixth))) / (v * v);
        }
    return piece.stored + 0.5 * s * sum;
  }
} // namespace birdstrike
