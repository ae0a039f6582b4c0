#include "structure/elements/von_mises.h"
#include "structure/histories/element_points.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

namespace birdstrike
{
  namespace
  {
    const std::string entry = "Output/Histories/Elements";

    double triaxiality(const std::array<double, 6> &s)
    {
      const double q = von_mises(s);
      return q > 0. ? (s[0] + s[1] + s[2]) / (3. * q) : 0.;
    }

    double parse_layer(const std::string &text)
    {
      if (text.empty())
        return 0.;
      const double layer = parse_numbers(text, 1, entry)[0];
      if (!(layer >= -1. && layer <= 1.))
        throw InputError(entry + ": layer " + text +
                         ".\nAllowed: -1 (bottom) to 1 (top), shares of half the thickness.");
      return layer;
    }

    template <class Kind, class Points>
    class ElementTable final : public HistoryTable
    {
    public:
      ElementTable(const WatchedBlade<Kind> &blade, const HistoryRequests &requests, Warnings &warnings) : points(blade)
      {
        name = "elements";
        for (const Place &place : parse_places(requests.elements, entry, "element", 1, blade.plane.exists()))
          {
            const std::uint32_t element = find_element(blade.mesh, place, entry, warnings);
            points.add(element, parse_layer(place.options[0]));
            axes.push_back(make_axes(requests.axes, blade.mesh.surface(), blade.roles, blade.mesh.centroid(element)));
            add_columns(place.name);
          }
      }

      void fill(const std::span<double> row) const override
      {
        double *next = row.data();
        for (std::size_t k = 0; k < axes.size(); ++k)
          {
            const PointValues now = points.values(k);
            next                  = std::copy_n(axes[k].of(now.stress).data(), 6, next);
            next                  = std::copy_n(axes[k].of(now.strain).data(), 6, next);
            for (const double value : {now.plastic_strain, von_mises(now.stress), triaxiality(now.stress)})
              *next++ = value;
            if (has_thickness)
              *next++ = now.thickness;
            *next++ = now.is_failed ? 1. : 0.;
          }
      }
      void follow() override
      {
        points.follow();
      }
      void archive(Archive &archive) override
      {
        const auto group = archive.group(name.c_str());
        points.archive(archive);
      }

    private:
      static constexpr bool has_thickness = Kind::dim == 2;

      void add_columns(const std::string &place)
      {
        const std::size_t k     = axes.size() - 1;
        const std::string where = points.describe(k);
        const auto        add   = [&](const std::string &quantity, const std::string &unit, const std::string &words) {
          columns.push_back({place + "." + quantity, unit, words + " of " + where});
        };
        for (const std::string &pair : axes[k].tensor_names())
          add("stress_" + pair, "Pa", "Cauchy stress, tension positive, " + axes[k].text + ",");
        for (const std::string &pair : axes[k].tensor_names())
          add("strain_" + pair, "-",
              "Logarithmic strain ln V (shear: of the tensor, half the engineering strain), " + axes[k].text + ",");
        add("plastic_strain", "-", "Equivalent plastic strain");
        add("von_mises", "Pa", "Von Mises stress");
        add("triaxiality", "-", "Mean stress over von Mises stress");
        if (has_thickness)
          add("thickness", "m", "Present thickness");
        add("failed", "-", "1 once the element has failed (stress and strain are then 0), else 0;");
      }

      Points            points;
      std::vector<Axes> axes;
    };
  } // namespace

  template <>
  std::unique_ptr<HistoryTable> make_element_table(const WatchedBlade<ShellKind> &blade,
                                                   const HistoryRequests &requests, Warnings &warnings)
  {
    return std::make_unique<ElementTable<ShellKind, ShellPoints>>(blade, requests, warnings);
  }

  template <>
  std::unique_ptr<HistoryTable> make_element_table(const WatchedBlade<SolidKind> &blade,
                                                   const HistoryRequests &requests, Warnings &warnings)
  {
    return std::make_unique<ElementTable<SolidKind, SolidPoints>>(blade, requests, warnings);
  }
} // namespace birdstrike
