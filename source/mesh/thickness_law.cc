#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/blade_shape.h>
#include <birdstrike/mesh/thickness_law.h>

#include <map>
#include <memory>
#include <string>

namespace birdstrike
{
  namespace
  {
    /// The profile along the chord: a parabola to either side of the largest thickness, where both are level,
    ///   t(s, c) = t_max(s) (1 - (1 - t_edge(s)) ((c - c_max)/(c_edge - c_max))^2).
    class Profile
    {
    public:
      explicit Profile(const GeometryParameters &p)
        : is_built_in(p.mesh.generator != MeshGenerator::file)
        , shape(shape_of(p.mesh))
        , maximum(p.thickness.maximum, "Thickness/Maximum", 1e-9, 1e3)
        , leading(p.thickness.leading_edge, "Thickness/Leading edge", 1e-3, 1.)
        , trailing(p.thickness.trailing_edge, "Thickness/Trailing edge", 1e-3, 1.)
        , station(p.thickness.maximum_station)
      {
      }

      double operator()(const SurfacePlace &place) const
      {
        const auto [s, c]     = is_built_in ? shape.coordinates(place.position) : place.station;
        const bool   is_front = c < station;
        const double edge     = is_front ? leading(s) : trailing(s);
        const double ratio    = (c - station) / ((is_front ? 0. : 1.) - station);
        return maximum(s) * (1. - (1. - edge) * ratio * ratio);
      }

    private:
      /// The flat plate is a blade whose laws are at their defaults; of a file there is none.
      static BladeShape shape_of(MeshParameters mesh)
      {
        if (mesh.generator != MeshGenerator::blade)
          mesh.profile = {};
        return BladeShape(mesh);
      }

      bool       is_built_in;
      BladeShape shape;
      SpanLaw    maximum, leading, trailing;
      double     station;
    };

    ThicknessLaw make_base_law(const GeometryParameters &parameters)
    {
      if (!parameters.thickness.maximum.empty())
        return
          [profile = std::make_shared<Profile>(parameters)](const SurfacePlace &place) { return (*profile)(place); };
      const auto expression = std::make_shared<Expression>(parameters.thickness.value, 1, "Thickness/Value");
      return [expression](const SurfacePlace &place) {
        return place.given > 0. ? place.given : expression->value(place.position, 0.);
      };
    }
  } // namespace

  ThicknessLaw make_thickness_law(const GeometryParameters &parameters, const NamedIds &materials)
  {
    std::map<unsigned int, double> by_material;
    for (const auto &[key, value] : parse_pairs(parameters.thickness.by_material, "Blade/Thickness/By material"))
      for (const unsigned int id : materials.parse(key, "Blade/Thickness/By material"))
        by_material[id] = parse_numbers(value, 1, "Blade/Thickness/By material")[0];
    return [by_material, law = make_base_law(parameters)](const SurfacePlace &place) {
      const auto found = by_material.find(place.material_id);
      return found != by_material.end() ? found->second : law(place);
    };
  }

  double thickness_at(const ThicknessLaw &law, const SurfacePlace &place, const std::string &entry)
  {
    const double *position = place.position;
    const double  t        = law(place);
    if (!(t > 0.))
      throw InputError("Blade/" + entry + ": the thickness at " + point_text(position) + " is " + number_text(t) +
                       " m.\nAllowed: positive everywhere on the blade.");
    return t;
  }
} // namespace birdstrike
