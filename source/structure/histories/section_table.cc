#include "structure/histories/section_forces.h"
#include "structure/histories/watched_blade.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    const std::string entry = "Output/Histories/Stations";

    template <class Kind>
    class SectionHistory final : public HistoryTable
    {
    public:
      SectionHistory(const WatchedBlade<Kind> &blade, const HistoryRequests &requests) : blade(blade)
      {
        name = "sections";
        if (!blade.roles.root.is_present() || !blade.roles.tip.is_present())
          throw InputError(
            entry + ": this blade has no " + (blade.roles.root.is_present() ? "row of the tip" : "clamped root") +
            ", so its span is not known.\nName root and tip in Blade/Supports/Clamped (or Hub) and Tip.");
        for (const std::string &text : dealii::Utilities::split_string_list(requests.stations, ','))
          {
            const double station = parse_numbers(text, 1, entry)[0];
            if (!(station >= 0. && station < 1.))
              throw InputError(entry + " holds " + text + ".\nAllowed: shares of the span from 0 to below 1.");
            if (std::ranges::find(columns, "span" + text + ".N", &Column::name) != columns.end())
              throw InputError(entry + " holds " + text + " twice.\nGive each station once.");
            cuts.emplace_back(blade.mesh, blade.roles, station, blade.plane, blade.stiffness);
            add_columns("span" + text);
          }
      }

      void fill(const std::span<double> row) const override
      {
        const double *const on_support = blade.motion.support_forces(), *const force = blade.motion.element_forces(),
                            *const x    = blade.motion.positions();
        double                    *next = row.data();
        for (const auto &cut : cuts)
          {
            const SectionForces now = cut.compute(
              cut.is_root() ? on_support : force, x,
              [this](const std::uint32_t n) { return this->blade.elements.is_free(n); },
              [this](const std::uint32_t cell) { return this->blade.elements.is_failed(cell); });
            for (const double value : {now.normal(), now.force.dot(now.axes.row(1)), now.force.dot(now.axes.row(2)),
                                       now.bending(), now.moment.dot(now.axes.row(2)), now.moment.dot(now.axes.row(0))})
              *next++ = value;
          }
      }

    private:
      void add_columns(const std::string &place)
      {
        const auto &way = blade.roles.tip.middle - blade.roles.root.middle;
        const auto  at =
          fmt::format(" through the section at {:.5g} of {:.5g} mm of the span, that the part beyond exerts, in axes "
                      "that turn with it",
                      1e3 * cuts.back().span_position(), 1e3 * way.norm());
        const auto add = [&](const char *quantity, const char *unit, const std::string &words) {
          columns.push_back({place + "." + quantity, unit, words + at});
        };
        add("N", "N", "Force along the span, tension positive,");
        add("Q_chord", "N", "Shear force along the chord");
        add("Q_normal", "N", "Shear force along the normal, away from the struck side,");
        add("M_bending", "N m", "Moment about normal x span, positive stretches the struck face,");
        add("M_edgewise", "N m", "Moment about the normal");
        add("M_torsion", "N m", "Moment about the span, away from the root,");
      }

      WatchedBlade<Kind>                                   blade;
      std::vector<SectionCut<static_cast<int>(Kind::dim)>> cuts;
    };
  } // namespace

  template <class Kind>
  std::unique_ptr<HistoryTable> make_section_table(const WatchedBlade<Kind> &blade, const HistoryRequests &requests)
  {
    return std::make_unique<SectionHistory<Kind>>(blade, requests);
  }

  template std::unique_ptr<HistoryTable> make_section_table(const WatchedBlade<ShellKind> &, const HistoryRequests &);
  template std::unique_ptr<HistoryTable> make_section_table(const WatchedBlade<SolidKind> &, const HistoryRequests &);
} // namespace birdstrike
