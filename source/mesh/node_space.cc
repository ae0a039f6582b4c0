#include <birdstrike/mesh/node_space.h>

#include <deal.II/base/partitioner.h>

namespace birdstrike
{
  using dealii::Utilities::MPI::Partitioner;

  NodeSpace::NodeSpace(const dealii::IndexSet &owned, const dealii::IndexSet &ghosts)
    : nodes(std::make_shared<const Partitioner>(owned, ghosts, MPI_COMM_SELF))
  {
  }

  std::uint32_t NodeSpace::n_owned() const
  {
    return nodes ? nodes->locally_owned_size() : 0;
  }

  std::uint32_t NodeSpace::size() const
  {
    return nodes ? nodes->locally_owned_size() + nodes->n_ghost_indices() : 0;
  }

  bool NodeSpace::is_whole() const
  {
    return !nodes || nodes->locally_owned_size() == nodes->size();
  }

  std::uint32_t NodeSpace::global(const std::uint32_t node) const
  {
    return static_cast<std::uint32_t>(nodes->local_to_global(node));
  }

  std::uint32_t NodeSpace::local(const std::uint32_t global) const
  {
    return nodes->global_to_local(global);
  }

  bool NodeSpace::has(const std::uint32_t global) const
  {
    return nodes->in_local_range(global) || nodes->is_ghost_entry(global);
  }

  std::shared_ptr<const Partitioner> NodeSpace::unknowns(const unsigned int n) const
  {
    const auto spread = [n](const dealii::IndexSet &of_nodes) {
      dealii::IndexSet set(n * of_nodes.size());
      for (auto interval = of_nodes.begin_intervals(); interval != of_nodes.end_intervals(); ++interval)
        set.add_range(n * *interval->begin(), n * (interval->last() + 1));
      return set;
    };
    return std::make_shared<const Partitioner>(spread(nodes->locally_owned_range()), spread(nodes->ghost_indices()),
                                               nodes->get_mpi_communicator());
  }
} // namespace birdstrike
