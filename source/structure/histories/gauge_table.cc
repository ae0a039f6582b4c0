#include "structure/histories/gauges.h"
#include "structure/histories/strain.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/named_choices.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    const std::string entry = "Output/Histories/Gauges";

    GaugeFace parse_face(const std::string &text)
    {
      static const NamedChoices<GaugeFace> faces{{"struck", GaugeFace::struck},
                                                 {"other", GaugeFace::other},
                                                 {"bottom", GaugeFace::bottom},
                                                 {"top", GaugeFace::top}};
      if (!faces.has(text))
        throw InputError(entry + ": face '" + text + "'.\nAllowed: " + faces.selection() + ".");
      return faces.at(text);
    }

    /// Strain gauges. A gauge is glued to the quadrilateral of the surface that its element has there and reads the
    /// change of length over length of a line through its middle,
    ///   e = |c1 t1 + c2 t2| / |c1 T1 + c2 T2| - 1,
    /// t and T the derivatives of the bilinear surface now and at rest, c1 T1 + c2 T2 the gauge's direction. It is as
    /// long as the element; bending of a shell adds its half thickness times the curvature.
    template <class Kind, class Faces>
    class GaugeTable final : public HistoryTable
    {
    public:
      GaugeTable(const WatchedBlade<Kind> &blade, const HistoryRequests &requests, Warnings &warnings)
        : blade(blade), faces(blade)
      {
        name = "gauges";
        for (const Place &place : parse_places(requests.gauges, entry, "", 2, blade.plane.exists()))
          {
            const std::string face = place.options[1].empty() ? "struck" : place.options[1];
            faces.add(place, parse_face(face), entry, warnings);
            const auto   x         = faces.corners_at_rest(shares.size());
            const Point3 direction = parse_direction(place);
            shares.push_back(find_shares(place, Tangents::of(x), direction));
            const std::string along = place.options[0].empty() ? "span" : place.options[0];
            columns.push_back({place.name + ".strain", "-",
                               "Engineering strain along '" + along + "' in the surface (" + face +
                                 "), as a gauge glued there reads it: mean of the element's face with its middle at " +
                                 text_of(0.25 * (x[0] + x[1] + x[2] + x[3])) + "; 0 once that has failed"});
          }
      }

      void fill(const std::span<double> row) const override
      {
        for (std::size_t k = 0; k < shares.size(); ++k)
          row[k] =
            faces.is_failed(k)
              ? 0.
              : length(k, Tangents::of(faces.corners(k))) / length(k, Tangents::of(faces.corners_at_rest(k))) - 1.;
      }
      void follow() override
      {
        faces.follow();
      }
      void archive(Archive &archive) override
      {
        const auto group = archive.group(name.c_str());
        faces.archive(archive);
      }

    private:
      double length(const std::size_t k, const Tangents &of) const
      {
        return (shares[k][0] * of.first + shares[k][1] * of.second).norm();
      }

      /// The direction without its part out of the surface, in its tangents.
      std::array<double, 2> find_shares(const Place &place, const Tangents &of, const Point3 &direction) const
      {
        const Point3 normal = of.normal(), g = direction - direction.dot(normal) * normal;
        if (!(g.norm() > 1e-3 * direction.norm()))
          throw InputError(entry + ": the direction of '" + place.name +
                           "' is square to the surface there.\nGive one that lies in it.");
        const double area = of.first.cross(of.second).dot(normal);
        return {g.cross(of.second).dot(normal) / area, of.first.cross(g).dot(normal) / area};
      }

      double parse_degrees(const std::string &text, const std::string &name) const
      {
        try
          {
            return parse_numbers(text, 1, entry)[0];
          }
        catch (const InputError &)
          {
            throw InputError(entry + ": '" + text + "' is no direction of the gauge '" + name +
                             "'.\nAllowed: span, chord, degrees from the span towards the chord, or a vector 'x y z'.");
          }
      }

      Point3 parse_direction(const Place &place) const
      {
        const std::string &text = place.options[0];
        if (std::count(text.begin(), text.end(), ' ') >= 2)
          {
            const auto x = parse_numbers(text, 3, entry);
            return {x[0], x[1], x[2]};
          }
        const Matrix3<double> axes  = find_blade_axes(blade.mesh.surface(), blade.roles, place.point, entry);
        double                angle = 0.;
        if (text == "chord")
          angle = 90.;
        else if (!text.empty() && text != "span")
          angle = parse_degrees(text, place.name);
        angle *= std::numbers::pi / 180.;
        return std::cos(angle) * axes.row(0) + std::sin(angle) * axes.row(1);
      }

      WatchedBlade<Kind>                 blade;
      Faces                              faces;
      std::vector<std::array<double, 2>> shares;
    };
  } // namespace

  template <>
  std::unique_ptr<HistoryTable> make_gauge_table(const WatchedBlade<ShellKind> &blade, const HistoryRequests &requests,
                                                 Warnings &warnings)
  {
    return std::make_unique<GaugeTable<ShellKind, ShellFaces>>(blade, requests, warnings);
  }

  template <>
  std::unique_ptr<HistoryTable> make_gauge_table(const WatchedBlade<SolidKind> &blade, const HistoryRequests &requests,
                                                 Warnings &warnings)
  {
    return std::make_unique<GaugeTable<SolidKind, SolidFaces>>(blade, requests, warnings);
  }
} // namespace birdstrike
