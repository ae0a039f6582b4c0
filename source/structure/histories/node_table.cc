#include "structure/histories/watched_blade.h"

namespace birdstrike
{
  namespace
  {
    const std::string entry = "Output/Histories/Nodes";

    template <class Kind>
    class NodeTable final : public HistoryTable
    {
    public:
      NodeTable(const WatchedBlade<Kind> &blade, const HistoryRequests &requests, Warnings &warnings) : blade(blade)
      {
        name = "nodes";
        for (const Place &place : parse_places(requests.nodes, entry, "node", 0, blade.plane.exists()))
          {
            const std::uint32_t node = find_node(blade.mesh, place, entry, warnings);
            watched.push_back(
              {node, make_axes(requests.axes, blade.mesh.surface(), blade.roles, blade.mesh.node(node))});
            add_columns(place.name, watched.back());
          }
      }

      void fill(const std::span<double> row) const override
      {
        double *next = row.data();
        for (const Watched &one : watched)
          for (const auto &vector : blade.motion.motion_of(one.node))
            next = std::copy_n(one.axes.of(Point3(vector.data())).data(), 3, next);
      }

    private:
      struct Watched
      {
        std::uint32_t node;
        Axes          axes;
      };

      void add_columns(const std::string &place, const Watched &one)
      {
        static constexpr std::array<std::array<const char *, 3>, 3> vectors{
          {{"u", "m", "Displacement"}, {"v", "m/s", "Velocity"}, {"a", "m/s^2", "Acceleration, damping included,"}}};
        for (const auto &[quantity, unit, words] : vectors)
          for (const std::string &axis : one.axes.names)
            columns.push_back(
              {place + "." + quantity + "_" + axis, unit,
               std::string(words) + " of " + describe_node(blade.mesh, one.node) + ", " + one.axes.text});
      }

      WatchedBlade<Kind>   blade;
      std::vector<Watched> watched;
    };
  } // namespace

  template <class Kind>
  std::unique_ptr<HistoryTable> make_node_table(const WatchedBlade<Kind> &blade, const HistoryRequests &requests,
                                                Warnings &warnings)
  {
    return std::make_unique<NodeTable<Kind>>(blade, requests, warnings);
  }

  template std::unique_ptr<HistoryTable> make_node_table(const WatchedBlade<ShellKind> &, const HistoryRequests &,
                                                         Warnings &);
  template std::unique_ptr<HistoryTable> make_node_table(const WatchedBlade<SolidKind> &, const HistoryRequests &,
                                                         Warnings &);
} // namespace birdstrike
