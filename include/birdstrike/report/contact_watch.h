#pragma once

#include <birdstrike/contact/report.h>
#include <birdstrike/report/force_channel.h>
#include <birdstrike/time_control/peak.h>

#include <cmath>

namespace birdstrike
{
  /// The contact force of a run: norm (N) of the sum of all contact forces on the blade, of the whole scene. Peaks are
  /// over every evaluation of contact, the bird's sub-steps included, so that no output interval can miss one.
  class ContactWatch
  {
  public:
    /// Channel frequency class (Hz) of the filtered force; 0: none is asked for, and what judges a run takes this one.
    static constexpr double usual_class = 1000.;

    explicit ContactWatch(const double channel_class = 0.)
      : of_channel(channel_class > 0. ? channel_class : usual_class)
    {
    }

    /// After each evaluation; `step` (s) leads to it from the one before, of which there is none at first.
    void update(const ContactReport &report, const double step)
    {
      clock += is_first ? 0. : step;
      is_first     = false;
      present      = std::hypot(report.force[0], report.force[1], report.force[2]);
      penetration  = report.max_penetration;
      over_spacing = report.max_penetration_over_spacing;
      whole_run.update(clock, present);
      this_row.update(clock, present);
      of_channel.update(clock, report.force);
    }

    /// So that a step of `duration` (s) allocates nothing.
    void make_room(const double duration)
    {
      of_channel.make_room(duration);
    }

    void archive(Archive &archive)
    {
      const auto group = archive.group("contact force");
      whole_run.archive(archive, "peak");
      this_row.archive(archive, "peak since the last row");
      archive("present", present);
      archive("penetration", penetration, over_spacing);
      archive("clock", clock);
      archive("is first", is_first);
      of_channel.archive(archive);
    }

    double force() const ///< N, of the last evaluation
    {
      return present;
    }
    const Peak &peak() const ///< N; s since first touch
    {
      return whole_run;
    }
    const ForceChannel &channel() const
    {
      return of_channel;
    }
    double max_penetration() const ///< m
    {
      return penetration;
    }

    double max_penetration_over_spacing() const ///< of the particles as they are packed
    {
      return over_spacing;
    }

    double peak_since_row() const ///< N
    {
      return this_row.value();
    }
    void start_row()
    {
      this_row = {};
    }

  private:
    Peak         whole_run, this_row;
    ForceChannel of_channel;
    double       present = 0., penetration = 0., over_spacing = 0., clock = 0.;
    bool         is_first = true;
  };
} // namespace birdstrike
