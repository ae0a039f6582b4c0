#include "io/aim/aim.h"
#include "io/aim/aimed_velocity.h"
#include "io/aim/contradiction.h"
#include "io/aim/row_slice.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/aimed_surface.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/rotor.h>
#include <birdstrike/structure/surface_map.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    std::array<double, 3> to_array(const Point3 &a)
    {
      return {{a[0], a[1], a[2]}};
    }

    std::string text_of(const double value) ///< to the last bit
    {
      std::array<char, 32> number;
      return {number.data(), std::to_chars(number.data(), number.data() + number.size(), value).ptr};
    }

    std::string text_of(const Point3 &a)
    {
      return text_of(a[0]) + ", " + text_of(a[1]) + ", " + text_of(a[2]);
    }

    /// The surface where the bird aims, or nothing.
    class Aim
    {
    public:
      Aim(const BirdParameters &bird, const BladeParameters &blade) : bird(bird), blade(blade)
      {
        const bool has_shares = !bird.aim_span_fraction.empty(), has_angle = !bird.angle_to_surface.empty(),
                   is_asked = has_shares || has_angle || bird.chordwise_offset != 0.;
        if (is_asked || blade.mesh.generator != MeshGenerator::file)
          map = make_surface_map(blade);
        if (!map && (has_shares || has_angle))
          throw InputError(
            bird.section + "/" + (has_shares ? "Aim span fraction" : "Angle to surface") +
            ": this blade has no span and chord to measure by.\nOf a mesh from a file they are known once "
            "Blade/Supports/Clamped (or Hub) and Blade/Supports/Tip name its root and its tip: set these.\nOr give Aim "
            "point and Velocity instead.");
      }

      /// `row` is what one blade takes of a bird that a row cuts.
      Point3 find_point(const bool is_given, const std::optional<RowSlice> &row) const
      {
        const Point3 given(bird.aim_point.data());
        if (bird.aim_span_fraction.empty())
          return given;
        const double span  = bird.aim_span_fraction[0];
        const Point3 point = is_by_edge() ? row->middle : map->position(span, bird.aim_chord_fraction[0]);
        if (!is_given)
          return point;
        if ((point - given).norm() > given_tolerance * (map->position(span, 1.) - map->position(span, 0.)).norm())
          refuse_difference(bird, "Aim point", shown(given) + " m",
                            is_by_edge() ? "Aim span fraction and Slice/Number of blades"
                                         : "Aim span fraction and Aim chord fraction",
                            shown(point) + " m");
        return given;
      }

      /// At the edge that meets the bird first, or where it aims.
      std::optional<RowSlice> find_row(const Point3 &velocity) const
      {
        if (bird.slice_blades == 0)
          return {};
        const Point3 none = Point3::Zero();
        if (bird.aim_span_fraction.empty())
          return RowSlice(bird, blade, Point3(bird.aim_point.data()), none, none, velocity);
        const double span = bird.aim_span_fraction[0];
        if (!is_by_edge())
          return RowSlice(bird, blade, map->position(span, bird.aim_chord_fraction[0]), none, none, velocity);
        constexpr double step    = 0.01; // of the span
        const Point3     leading = map->position(span, 0.), chord = map->position(span, 1.) - leading;
        const bool       is_leading = RowSlice(bird, blade, leading, none, chord, velocity).relative.dot(chord) > 0.;
        const double     share      = is_leading ? 0. : 1.;
        const Point3     along =
          map->position(std::min(span + step, 1.), share) - map->position(std::max(span - step, 0.), share);
        return RowSlice(bird, blade, map->position(span, share), along, is_leading ? chord : Point3(-chord), velocity);
      }

      /// Whether it aims beside the edge that cuts it, wherever that has gone by then.
      bool is_by_edge() const
      {
        return bird.slice_blades > 0 && !bird.aim_span_fraction.empty() && bird.aim_chord_fraction.empty();
      }

      std::optional<AimedSurface> find_surface(const Point3 &point) const
      {
        if (!map)
          return {};
        const auto [span, chord] = map->shares(point);
        return AimedSurface{to_array(map->normal(span, chord)), to_array(map->chord_direction(span)), span, chord,
                            (map->position(span, chord) - point).norm()};
      }

    private:
      const BirdParameters             &bird;
      const BladeParameters            &blade;
      std::unique_ptr<const SurfaceMap> map;
    };

    /// The planes of the slice that a blade takes, into `found` where the file does not give them.
    void add_planes(const BirdParameters &bird, const RowSlice &row, const bool is_normal_given,
                    const bool is_between_given, std::vector<std::string> &found)
    {
      const char *const there = "Slice/Number of blades";
      if (!is_normal_given)
        found.push_back(bird.section + "/Slice/Normal=" + text_of(row.normal));
      else if (const Point3 given(bird.slice_normal.data()); (given.normalized() - row.normal).norm() > given_tolerance)
        refuse_difference(bird, "Slice/Normal", shown(given), there, "along " + shown(row.normal));
      if (!is_between_given)
        found.push_back(bird.section + "/Slice/Between=" + text_of(-row.half) + ", " + text_of(row.half));
      else if (const auto &given = bird.slice_between;
               std::max(std::abs(given[0] + row.half), std::abs(given[1] - row.half)) > given_tolerance * row.half)
        refuse_difference(bird, "Slice/Between", fmt::format("{:.6g}, {:.6g} m", given[0], given[1]), there,
                          fmt::format("{:.6g}, {:.6g} m", -row.half, row.half));
    }

    /// Where a bird that comes from a position will strike, nearly: to know the blade's faces by. The scene, which has
    /// the surface itself, finds it exactly.
    Point3 guess_aim(const BirdParameters &bird, const BladeParameters &blade, const Point3 &velocity)
    {
      const Point3 position(bird.position.data());
      if (blade.mesh.generator == MeshGenerator::file || blade.kind == BladeKind::none || velocity.norm() == 0.)
        return position;
      const auto map = make_surface_map(blade);
      if (!map)
        return position;
      const auto foot = [&](const Point3 &x) {
        const auto [span, chord] = map->shares(x);
        return map->position(span, chord);
      };
      const Rotor     rotor(blade.spin);
      const HubMotion hub = rotor.motion(0.);
      if (rotor.turns() && hub.axis.dot(velocity) != 0.) // when it comes through the row
        {
          const double time = hub.axis.dot(map->position(0.5, 0.5) - position) / hub.axis.dot(velocity);
          return foot(hub.centre + rotor.turn(std::max(0., time)).back(position + time * velocity - hub.centre));
        }
      Point3 x = position;
      for (unsigned int pass = 0; pass < 20; ++pass)
        x = position + (foot(x) - position).dot(velocity) / velocity.squaredNorm() * velocity;
      return x;
    }

    struct PlacedBird
    {
      Point3 point, velocity;
    };

    /// What follows of the slice, "Section/Entry=value", goes into `found`.
    PlacedBird place(BirdParameters &bird, const BladeParameters &blade, const ParameterFile &file,
                     std::vector<std::string> &found)
    {
      const auto              is_given = [&](const char *entry) { return file.is_given(bird.section + "/" + entry); };
      const Aim               aim(bird, blade);
      const auto              velocity = [&] { return find_velocity(bird, blade, is_given("Velocity")); };
      std::optional<RowSlice> row;
      if (bird.slice_blades > 0)
        {
          require_turning_row(bird, blade); // to whose surface no angle is given
          row = aim.find_row(velocity());
          add_planes(bird, *row, is_given("Slice/Normal"), is_given("Slice/Between"), found);
        }
      bird.is_aim_given  = is_given("Aim point");
      const Point3 point = bird.position.empty() || bird.is_aim_given ? aim.find_point(bird.is_aim_given, row)
                                                                      : guess_aim(bird, blade, velocity());
      if (!bird.aim_span_fraction.empty())
        bird.aimed_place = to_array(aim.is_by_edge() ? row->edge : point);
      bird.aimed_surface = aim.find_surface(point);
      return {point, velocity()};
    }

    /// What follows, "Section/Entry=value", into `found`.
    void resolve(BirdParameters &bird, const BladeParameters &blade, const ParameterFile &file,
                 std::vector<std::string> &found)
    {
      const auto [point, velocity] = place(bird, blade, file, found);
      if (to_array(point) != bird.aim_point)
        found.push_back(bird.section + "/Aim point=" + text_of(point));
      if (to_array(velocity) != bird.velocity)
        found.push_back(bird.section + "/Velocity=" + text_of(velocity));
    }

    /// Its aim and flight alone, before it is cut; one that a row would have placed aims at the leading edge.
    BirdParameters without_body(const BirdParameters &bird)
    {
      BirdParameters flight;
      flight.section            = bird.section;
      flight.velocity           = bird.velocity;
      flight.speed              = bird.speed;
      flight.angle_to_surface   = bird.angle_to_surface;
      flight.flight_direction   = bird.flight_direction;
      flight.aim_point          = bird.aim_point;
      flight.chordwise_offset   = bird.chordwise_offset;
      flight.aim_span_fraction  = bird.aim_span_fraction;
      flight.aim_chord_fraction = bird.aim_chord_fraction;
      if (bird.slice_blades > 0 && !bird.aim_span_fraction.empty() && bird.aim_chord_fraction.empty())
        flight.aim_chord_fraction = {0.};
      return flight;
    }
  } // namespace

  std::optional<AimedSurface> find_aimed_surface(const BirdParameters &bird, const BladeParameters &blade)
  {
    return Aim(bird, blade).find_surface(Point3(bird.aim_point.data()));
  }

  void resolve_aim(CaseParameters &parameters)
  {
    std::vector<std::string> found;
    if (parameters.bird.enabled)
      resolve(parameters.bird, parameters.blade, parameters.file, found);
    for (CaseParameters::FurtherBird &each : parameters.further_birds)
      if (each.bird.enabled)
        resolve(each.bird, parameters.blade, parameters.file, found);
    parameters.file.set(found);
  }

  std::optional<BladeParameters::StrikingBird> find_struck_side(const CaseParameters &parameters,
                                                                std::string          &why_unknown)
  {
    std::vector<std::string> not_set;
    if (!parameters.bird.enabled)
      return {};
    for (BirdParameters bird : {parameters.bird, without_body(parameters.bird)})
      try
        {
          bird.check();
          const auto [point, velocity] = place(bird, parameters.blade, parameters.file, not_set);
          bird.aim_point               = to_array(point);
          why_unknown.clear();
          return BladeParameters::StrikingBird{bird.target(), to_array(velocity)};
        }
      catch (const InputError &error)
        {
          why_unknown = error.what();
        }
    return {};
  }
} // namespace birdstrike
