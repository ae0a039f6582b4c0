#include <birdstrike/core/archive.h>
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    /// Of an entry of a quantity: "" where both are the same.
    std::string compare(const std::string &name, const ArchivedQuantity &a, const ArchivedQuantity &b)
    {
      if (a.is_real != b.is_real || a.n_components != b.n_components || a.lengths != b.lengths || a.size() != b.size())
        return fmt::format("'{}' has {} values in one, {} in the other", name, a.size(), b.size());
      const std::size_t n_components = std::max<std::size_t>(a.n_components, 1);
      for (std::size_t k = 0; k < a.size(); ++k)
        {
          const std::string where =
            fmt::format("'{}', entity {} in order, component {}", name, k / n_components, k % n_components);
          if (a.is_real && std::bit_cast<std::uint64_t>(a.real[k]) != std::bit_cast<std::uint64_t>(b.real[k]))
            return fmt::format("{}: {} and {}", where, a.real[k], b.real[k]);
          if (!a.is_real && a.whole[k] != b.whole[k])
            return fmt::format("{}: {} and {}", where, a.whole[k], b.whole[k]);
        }
      return "";
    }

    /// Rows that are described before their values are handed over: enough to hide the cost of a piece, few enough that
    /// all quantities of a row together take a megabyte or two.
    constexpr std::size_t rows_of_a_piece = 4096;

    template <class Values>
    void append(Values &all, const Values &some)
    {
      all.insert(all.end(), some.begin(), some.end());
    }

    class StateCollector : public StateSink
    {
    public:
      explicit StateCollector(ArchivedState &state) : state(state)
      {
      }

      void take(const std::string &name, const ArchivedQuantity &piece) override
      {
        ArchivedQuantity &quantity = state[name];
        if (begun.insert(name).second)
          quantity = {};
        quantity.is_real      = piece.is_real;
        quantity.n_components = piece.n_components;
        append(quantity.real, piece.real);
        append(quantity.whole, piece.whole);
        append(quantity.lengths, piece.lengths);
      }

    private:
      ArchivedState        &state;
      std::set<std::string> begun; ///< of this archive: what the state had before goes
    };
  } // namespace

  std::string find_difference(const ArchivedState &one, const ArchivedState &other)
  {
    for (const auto &[name, quantity] : one)
      {
        const auto match = other.find(name);
        if (match == other.end())
          return "'" + name + "' is missing in the second";
        if (std::string difference = compare(name, quantity, match->second); !difference.empty())
          return difference;
      }
    for (const auto &[name, quantity] : other)
      if (!one.contains(name))
        return "'" + name + "' is missing in the first";
    return "";
  }

  void StateInventory::take(const std::string &name, const ArchivedQuantity &piece)
  {
    Shape &shape       = all[name];
    shape.is_real      = piece.is_real;
    shape.n_components = piece.n_components;
    shape.n_values += piece.size();
    shape.n_lengths += piece.lengths.size();
  }

  Archive Archive::writing(ArchivedState &to)
  {
    auto       collector = std::make_unique<StateCollector>(to);
    StateSink *sink      = collector.get();
    return Archive(std::move(collector), sink, nullptr);
  }

  Archive Archive::writing(StateSink &to)
  {
    return Archive(nullptr, &to, nullptr);
  }

  Archive Archive::reading(const ArchivedState &from)
  {
    return Archive(nullptr, nullptr, &from);
  }

  Archive::Group::Group(Archive &archive, const std::string &name)
    : archive(archive), length_before(archive.path.size())
  {
    archive.path += name + "/";
  }

  Archive::Group::~Group()
  {
    archive.path.resize(length_before);
  }

  Archive::Column Archive::open(const std::string &name, const bool is_real, const std::size_t n_components,
                                const std::size_t n_rows)
  {
    const std::string full = path + name;
    if (!asked.insert(full).second)
      throw std::logic_error("Archive: '" + full + "' is described twice.");
    Column column;
    if (target)
      {
        const std::size_t n       = n_components * std::min(n_rows, rows_of_a_piece);
        column.full_name          = full;
        column.piece.is_real      = is_real;
        column.piece.n_components = n_components;
        is_real ? column.piece.real.reserve(n) : column.piece.whole.reserve(n);
        return column;
      }
    const auto found = source->find(full);
    if (found == source->end())
      throw InputError("The archive has no '" + full + "': it was written by another version, or of another case.");
    column.from = &found->second;
    if (column.from->is_real != is_real || column.from->n_components != n_components ||
        (n_components > 0 ? column.from->size() != n_components * n_rows : column.from->lengths.size() != n_rows))
      throw InputError(fmt::format("The archive has '{}' of {} values in {} components, where {} in {} belong: it was "
                                   "written of another case.",
                                   full, column.from->size(), column.from->n_components, n_components * n_rows,
                                   n_components));
    return column;
  }

  Archive::Column &Archive::Row::next(const char *name, const bool is_real, const std::size_t n_components)
  {
    if (row == 0)
      {
        columns.push_back(archive.open(prefix.size() > 1 ? prefix + name : name, is_real, n_components, n_rows));
        columns.back().name = name;
      }
    Column &column = columns.at(field++);
    if (column.name != name && std::strcmp(column.name, name) != 0)
      throw std::logic_error("Archive: an entity describes '" + std::string(name) + "' where the first has '" +
                             column.name + "'.");
    return column;
  }

  std::size_t Archive::Row::exchange_length(Column &column, const std::size_t length)
  {
    if (!column.from)
      {
        column.piece.lengths.push_back(length);
        return length;
      }
    const std::size_t archived = column.from->lengths[row];
    if (archived > column.from->size() - column.position)
      throw InputError("The archive has '" + archive.path + prefix + column.name +
                       "' with lists longer than its values.");
    return archived;
  }

  void Archive::Row::hand_over()
  {
    if (archive.is_reading())
      return;
    for (Column &column : columns)
      {
        archive.target->take(column.full_name, column.piece);
        column.piece.real.clear();
        column.piece.whole.clear();
        column.piece.lengths.clear();
      }
  }

  void Archive::rows(const std::string &name, const std::size_t n, const Describe describe)
  {
    Row row(*this, name, n);
    for (row.row = 0; row.row < n; ++row.row)
      {
        row.field = 0;
        describe(row, row.row);
        if ((row.row + 1) % rows_of_a_piece == 0)
          row.hand_over();
      }
    row.hand_over();
  }

  void Archive::population(const std::string &name, std::vector<std::uint64_t> &ids)
  {
    Row row(*this, "", 1);
    row.list(name.c_str(), ids);
    row.hand_over();
  }

  void Archive::population(const std::string &name, std::size_t &n)
  {
    std::vector<std::uint64_t> ids(n);
    std::iota(ids.begin(), ids.end(), std::uint64_t(0));
    population(name, ids);
    n = ids.size();
  }

  void Archive::entities(const std::string &name, const std::size_t n, const Describe describe)
  {
    std::vector<std::uint64_t> ids(n);
    std::iota(ids.begin(), ids.end(), std::uint64_t(0));
    entities(name, ids, describe);
  }

  void Archive::entities(const std::string &name, const std::vector<std::uint64_t> &ids, const Describe describe)
  {
    std::vector<std::uint64_t> archived = ids;
    population(name, archived);
    std::vector<std::uint64_t> sorted = archived;
    std::sort(sorted.begin(), sorted.end());
    if (sorted != ids)
      throw InputError(
        fmt::format("The archive has {} of '{}', this scene {}, or others: it was written of another case.",
                    sorted.size(), path + name, ids.size()));
    rows(name, ids.size(), [&](Row &row, const std::size_t i) {
      describe(row, std::lower_bound(ids.begin(), ids.end(), archived[i]) - ids.begin());
    });
  }

  void Archive::finish() const
  {
    if (source)
      for (const auto &[name, quantity] : *source)
        if (!asked.contains(name))
          throw InputError("The archive has '" + name + "', which means nothing here: it was written of another case.");
  }
} // namespace birdstrike
