#pragma once

#include <birdstrike/core/function_ref.h>

#include <cstdint>
#include <map>
#include <memory>
#include <ranges>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace birdstrike
{
  /// Values of one name: of each entity (or of the part itself, then of one) n_components numbers, or a list.
  struct ArchivedQuantity
  {
    bool                       is_real = true;   ///< which of the two arrays holds the values
    std::vector<double>        real;             ///< SI units; floats exactly
    std::vector<std::uint64_t> whole;            ///< counts, ids, flags; negative ones modulo 2^64
    std::size_t                n_components = 0; ///< 0: lists
    std::vector<std::uint64_t> lengths;          ///< of lists, by entity

    std::size_t size() const
    {
      return is_real ? real.size() : whole.size();
    }
  };

  /// The state of a run by name, "part/entities/quantity"; "part/entities" itself are the global ids. In memory; each
  /// quantity is what a data set of a file would be.
  using ArchivedState = std::map<std::string, ArchivedQuantity>;

  /// Where the values of a state go while it is written, piece by piece: the state as a whole need not stand in memory.
  class StateSink
  {
  public:
    virtual ~StateSink() = default;

    /// The next values and lengths of the quantity of this name; no other piece has another kind or other components.
    virtual void take(const std::string &name, const ArchivedQuantity &piece) = 0;
  };

  /// Sizes of a state, by name, without its values.
  class StateInventory : public StateSink
  {
  public:
    struct Shape
    {
      bool        is_real      = true;
      std::size_t n_components = 0, n_values = 0, n_lengths = 0;
    };

    void take(const std::string &name, const ArchivedQuantity &piece) override;

    const std::map<std::string, Shape> &shapes() const
    {
      return all;
    }

  private:
    std::map<std::string, Shape> all;
  };

  /// The first quantity, by name, in which two states differ in any bit (or which only one of them has), and where; ""
  /// for equal ones.
  std::string find_difference(const ArchivedState &one, const ArchivedState &other);

  /// Writes or reads a state. A part describes what its next step depends on once, for both directions:
  ///
  ///   const auto group = archive.group("plate");
  ///   archive("speed", speed);
  ///   archive.entities("nodes", n_nodes, [&](Archive::Row &row, const std::size_t n) {
  ///     row("position", x[3 * n], x[3 * n + 1], x[3 * n + 2]);
  ///   });
  ///
  /// Values are numbers of any kind, arrays and vectors of a fixed length, or what converts to double and can be
  /// assigned (a lane of a register): never registers, so that another width reads what one has written. What follows
  /// from the archived state or from the case is not written but made again by the part that reads. All entities of a
  /// set have the same quantities. Between whole macro steps only.
  ///
  /// Reading throws InputError naming the quantity where one is missing or has another shape, and in finish() where one
  /// has not been asked for.
  class Archive
  {
  public:
    static Archive writing(ArchivedState &to);
    static Archive writing(StateSink &to);
    static Archive reading(const ArchivedState &from);

    bool is_reading() const
    {
      return source != nullptr;
    }

    /// Names that follow begin with that of the group, while this lives.
    class [[nodiscard]] Group
    {
    public:
      Group(Archive &archive, const std::string &name);
      ~Group();
      Group(const Group &)            = delete;
      Group &operator=(const Group &) = delete;

    private:
      Archive    &archive;
      std::size_t length_before;
    };
    Group group(const std::string &name)
    {
      return Group(*this, name);
    }

    /// One quantity and how far it has been read.
    struct Column
    {
      const char             *name = nullptr;
      std::string             full_name;          ///< with those of the groups
      ArchivedQuantity        piece;              ///< written, and not handed over yet
      const ArchivedQuantity *from     = nullptr; ///< of what is read
      std::size_t             position = 0;       ///< of the next value

      template <class T>
      void exchange(T &&value);
    };

    /// The quantities of one entity, in the same order for all of a set.
    class Row
    {
    public:
      Row(Archive &archive, const std::string &entities, std::size_t n)
        : archive(archive), prefix(entities + "/"), n_rows(n)
      {
      }

      template <class... T>
      void operator()(const char *name, T &&...components)
      {
        Column &column = next(name, is_real<T...>(), (size_of<T>(components) + ...));
        (column.exchange(components), ...);
      }

      /// A list whose length differs from entity to entity.
      template <class List>
      void list(const char *name, List &values)
      {
        Column &column = next(name, std::is_floating_point_v<typename List::value_type>, 0);
        values.resize(exchange_length(column, values.size()));
        for (auto &value : values)
          column.exchange(value);
      }

    private:
      friend class Archive;

      Column     &next(const char *name, bool is_real, std::size_t n_components);
      std::size_t exchange_length(Column &column, std::size_t length);
      void        hand_over(); ///< what is written so far, to the sink

      Archive            &archive;
      std::string         prefix;
      std::size_t         n_rows, row = 0, field = 0;
      std::vector<Column> columns;
    };
    using Describe = FunctionRef<void(Row &, std::size_t)>;

    /// A quantity of the part itself.
    template <class... T>
    void operator()(const char *name, T &&...components)
    {
      Row row(*this, "", 1);
      row(name, components...);
      row.hand_over();
    }
    template <class List>
    void list(const char *name, List &values)
    {
      Row row(*this, "", 1);
      row.list(name, values);
      row.hand_over();
    }

    /// Entities that the part has in any case, of ids 0 ... n - 1: calls describe(row, id) for each, in any order.
    void entities(const std::string &name, std::size_t n, Describe describe);
    /// The same of ids that are not those of the first n, ascending: calls describe(row, i) for each ids[i].
    void entities(const std::string &name, const std::vector<std::uint64_t> &ids, Describe describe);

    /// Entities that come and go: reading replaces `ids`, in the order in which they were written. Their quantities
    /// follow by rows().
    void population(const std::string &name, std::vector<std::uint64_t> &ids);
    /// The same of numbered ones: reading replaces their number.
    void population(const std::string &name, std::size_t &n);

    /// Quantities of a population: calls describe(row, i) for its n entities.
    void rows(const std::string &name, std::size_t n, Describe describe);

    /// A population of numbered records: describe(row, record).
    template <class Records, class DescribeRecord>
    void records(const std::string &name, Records &all, const DescribeRecord &describe)
    {
      std::size_t n = all.size();
      population(name, n);
      all.resize(n);
      rows(name, n, [&](Row &row, const std::size_t i) { describe(row, all[i]); });
    }

    /// @throws InputError where a quantity of the state that is read was not asked for.
    void finish() const;

  private:
    Archive(std::unique_ptr<StateSink> own, StateSink *to, const ArchivedState *from)
      : collector(std::move(own)), target(to), source(from)
    {
    }

    Column open(const std::string &name, bool is_real, std::size_t n_components, std::size_t n_rows);

    template <class T>
    static constexpr bool is_array = std::ranges::range<std::remove_cvref_t<T>>;
    template <class T>
    static constexpr bool is_whole =
      std::is_integral_v<std::remove_cvref_t<T>> || std::is_enum_v<std::remove_cvref_t<T>>;

    template <class T, class... Others>
    static constexpr bool is_real()
    {
      if constexpr (is_array<T>)
        return !is_whole<std::ranges::range_value_t<std::remove_cvref_t<T>>>;
      else
        return !is_whole<T>;
    }
    template <class T>
    static std::size_t size_of(T &value)
    {
      if constexpr (is_array<T>)
        return static_cast<std::size_t>(std::ranges::distance(value));
      else
        return 1;
    }

    std::unique_ptr<StateSink> collector; ///< of a state in memory
    StateSink                 *target;
    const ArchivedState       *source;
    std::string                path; ///< of the open groups
    std::set<std::string>      asked;
  };

  template <class T>
  void Archive::Column::exchange(T &&value)
  {
    using Value = std::remove_cvref_t<T>;
    if constexpr (is_array<Value>)
      for (auto &component : value)
        exchange(component);
    else if constexpr (is_whole<Value>)
      {
        if (!from)
          piece.whole.push_back(static_cast<std::uint64_t>(value));
        else
          value = static_cast<Value>(from->whole[position++]);
      }
    else
      {
        if (!from)
          piece.real.push_back(static_cast<double>(value));
        else if constexpr (std::is_floating_point_v<Value>)
          value = static_cast<Value>(from->real[position++]);
        else
          std::move(value) = from->real[position++]; // of a lane: what stands for it may only be assigned as this
      }
  }
} // namespace birdstrike
