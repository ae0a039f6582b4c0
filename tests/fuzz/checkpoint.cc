#include <birdstrike/core/errors.h>
#include <birdstrike/io/checkpoint_file.h>

#include "fuzz_input.h"

namespace
{
  using namespace birdstrike;

  /// A part that archives all that an archive knows: own numbers, lists, entities, records that come and go.
  struct Part
  {
    struct Record
    {
      std::uint32_t        id = 0;
      float                x  = 0;
      std::vector<double>  list;
      std::array<float, 3> vector{};
    };
    double                     time  = 1.;
    bool                       flag  = true;
    std::vector<std::uint64_t> gone  = {7, 8};
    std::vector<double>        nodes = {1., 2., 3.};
    std::vector<Record>        records{{1, 2.f, {3., 4.}, {}}, {5, 6.f, {}, {}}};

    void archive(Archive &archive)
    {
      const auto group = archive.group("part");
      archive("time", time);
      archive("flag", flag);
      archive.list("gone", gone);
      archive.entities("nodes", nodes.size(),
                       [&](Archive::Row &row, const std::size_t n) { row("x", nodes[n], nodes[n]); });
      archive.records("records", records, [](Archive::Row &row, Record &one) {
        row("id", one.id);
        row("x", one.x);
        row.list("list", one.list);
        row("vector", one.vector);
      });
    }
  };

  Checkpoint of_a_part()
  {
    Checkpoint checkpoint{"set A = 1\n", {{"plate.msh", "0123456789abcdef", false}}, "1.0", 1e-3, 12, {}};
    Archive    archive = Archive::writing(checkpoint.state);
    Part       part;
    part.archive(archive);
    return checkpoint;
  }

  /// Five bytes a change: of which quantity, what, where, and to which of many values.
  void change(ArchivedState &state, const std::uint8_t *change)
  {
    static constexpr std::uint64_t values[] = {
      0, 1, 2, 3, 4, 0xFFFFFFFF, 1ull << 32, 1ull << 40, 1ull << 61, 1ull << 63, ~std::uint64_t(0)};
    auto                found    = std::next(state.begin(), change[0] % state.size());
    ArchivedQuantity   &quantity = found->second;
    const std::uint64_t value    = change[3] < 128 ? change[3] : values[change[4] % std::size(values)];
    const auto          set      = [&](auto &list) {
      if (!list.empty())
        list[change[2] % list.size()] = value;
    };
    switch (change[1] % 9)
      {
      case 0:
        set(quantity.whole);
        return set(quantity.real);
      case 1:
        return set(quantity.lengths);
      case 2:
        quantity.n_components = value;
        return;
      case 3:
        quantity.lengths.push_back(value);
        return;
      case 4:
        quantity.whole.resize(change[3]);
        return;
      case 5:
        quantity.real.resize(change[3]);
        return;
      case 6:
        quantity.lengths.resize(change[3]);
        return;
      case 7:
        quantity.is_real = !quantity.is_real;
        return;
      default:
        if (state.size() > 1)
          state.erase(found);
      }
  }

  /// A state that another program may have written: through a file and back unchanged, then into a part.
  void read_changed_state(const std::string &file, const std::uint8_t *data, const std::size_t size)
  {
    Checkpoint checkpoint = of_a_part();
    for (std::size_t k = 0; k + 5 <= size && k < 100; k += 5)
      change(checkpoint.state, data + k);
    for (auto &[name, quantity] : checkpoint.state) // a file has one array of each
      quantity.is_real ? quantity.whole.clear() : quantity.real.clear();
    write_checkpoint(file, checkpoint);
    if (!find_difference(checkpoint.state, read_checkpoint(file).state).empty())
      __builtin_trap();
    Archive archive = Archive::reading(checkpoint.state);
    Part    part;
    part.archive(archive);
    archive.finish();
  }
} // namespace

/// The first letter: 'f', bytes of a file follow; 's', changes to a state. What lies behind a right checksum is HDF5's
/// own business: a damaged file does not get there.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  static const fuzz::Folder folder;
  if (size < 1)
    return -1;
  try
    {
      if (data[0] == 's')
        read_changed_state(folder.path / "checkpoint.h5", data + 1, size - 1);
      else if (data[0] == 'f')
        read_checkpoint(folder.write("checkpoint.h5", fuzz::text_of(data + 1, size - 1)));
      else
        return -1;
    }
  catch (const InputError &)
    {
    }
  return 0;
}
