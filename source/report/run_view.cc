#include <birdstrike/bird/bird.h>
#include <birdstrike/report/run_view.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double small_force  = 0.01;    ///< of the filtered peak
    constexpr double closing_time = 0.25e-3; ///< s, half a period of the highest frequency that CFC 1000 passes

    /// The particles of one snapshot behind those of another one, of the same fields.
    void append(FieldSnapshot &all, const FieldSnapshot &some)
    {
      const auto n = static_cast<std::uint32_t>(all.points.size() / 3);
      all.points.insert(all.points.end(), some.points.begin(), some.points.end());
      for (const std::uint32_t cell : some.cells)
        all.cells.push_back(n + cell);
      for (std::size_t k = 0; k < all.fields.size(); ++k)
        all.fields[k].values.insert(all.fields[k].values.end(), some.fields[k].values.begin(),
                                    some.fields[k].values.end());
    }
  } // namespace

  bool RunView::has_bird() const
  {
    return std::ranges::any_of(birds, [](const BirdOfRun &each) { return each.bird != nullptr; });
  }

  double RunView::closing_force() const
  {
    const auto force = observed.contact.channel().mean_of_last(closing_time);
    return std::hypot(force[0], force[1], force[2]);
  }

  bool RunView::is_pushed() const
  {
    const double peak = observed.smooth_peak;
    return contact && peak > 0. && closing_force() > small_force * peak;
  }

  bool RunView::may_deflect_further() const
  {
    return end_reason != EndReason::tip_peak && (is_pushed() || !observed.first_tip_peak.has_turned_back(time, 0.));
  }

  std::size_t RunView::n_particles() const
  {
    std::size_t n = 0;
    for (const BirdOfRun &each : birds)
      n += each.bird ? each.bird->n_particles() : 0;
    return n;
  }

  double BirdOfRun::retired_mass() const
  {
    return at_start.particles > 0
             ? at_start.mass * static_cast<double>(n_retired) / static_cast<double>(at_start.particles)
             : 0.;
  }

  std::size_t RunView::n_retired() const
  {
    std::size_t n = 0;
    for (const BirdOfRun &each : birds)
      n += each.n_retired;
    return n;
  }

  double RunView::retired_mass() const
  {
    double mass = 0.;
    for (const BirdOfRun &each : birds)
      mass += each.retired_mass();
    return mass;
  }

  FieldSnapshot RunView::bird_snapshot() const
  {
    FieldSnapshot all;
    bool          is_first = true;
    for (const BirdOfRun &each : birds)
      if (each.bird)
        {
          FieldSnapshot some = each.bird->snapshot(each.first_id);
          if (birds.size() > 1)
            some.fields.push_back(
              {"bird", "", false, 1, std::vector<double>(some.points.size() / 3, each.number), true});
          if (is_first)
            all = std::move(some);
          else
            append(all, some);
          is_first = false;
        }
    return all;
  }
} // namespace birdstrike
