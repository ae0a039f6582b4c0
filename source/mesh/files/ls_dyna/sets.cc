#include "mesh/files/ls_dyna/sets.h"

#include <algorithm>
#include <charconv>

namespace birdstrike
{
  namespace
  {
    std::string lower(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) { return std::tolower(c); });
      return text;
    }
  } // namespace

  const LsDynaSets::Kind *LsDynaSets::kind_of(const std::string &word)
  {
    static constexpr Kind kinds[] = {
      {"NODE", "node_set", 0},     {"BEAM", "beam_set", 1}, {"SHELL", "shell_set", 2},    {"SOLID", "solid_set", 3},
      {"TSHELL", "tshell_set", 3}, {"PART", "part_set", 0}, {"SEGMENT", "segment_set", 0}};
    const auto found =
      std::find_if(std::begin(kinds), std::end(kinds), [&word](const Kind &kind) { return word == kind.word; });
    return found != std::end(kinds) ? found : nullptr;
  }

  LsDynaSets::Reader LsDynaSets::reader_of(const std::string &layout)
  {
    static const std::map<std::string, Reader> known{{"", &LsDynaSets::read_list},
                                                     {"LIST", &LsDynaSets::read_list},
                                                     {"LIST_SMOOTH", &LsDynaSets::read_list},
                                                     {"COLUMN", &LsDynaSets::read_column},
                                                     {"LIST_GENERATE", &LsDynaSets::read_ranges},
                                                     {"GENERATE", &LsDynaSets::read_ranges},
                                                     {"LIST_GENERATE_INCREMENT", &LsDynaSets::read_steps},
                                                     {"GENERATE_INCREMENT", &LsDynaSets::read_steps},
                                                     {"GENERAL", &LsDynaSets::read_general},
                                                     {"ADD", &LsDynaSets::read_sum},
                                                     {"INTERSECT", &LsDynaSets::read_common}};
    const auto                                 found = known.find(layout);
    return found != known.end() ? found->second : nullptr;
  }

  void LsDynaSets::begin()
  {
    n_cards   = 0;
    title     = "";
    has_title = cards.has_word("TITLE");
    collects  = cards.has_word("COLLECT");
    std::string layout;
    for (std::size_t k = 2; k < cards.words.size(); ++k)
      if (cards.words[k] != "TITLE" && cards.words[k] != "COLLECT")
        layout += (layout.empty() ? "" : "_") + cards.words[k];
    kind      = cards.words.size() > 1 ? kind_of(cards.words[1]) : nullptr;
    kind_name = kind != nullptr ? kind->name : cards.words.size() > 1 ? lower(cards.words[1]) + "_set" : "set";
    read_one  = kind != nullptr ? reader_of(layout) : nullptr;
    if (read_one == &LsDynaSets::read_list && kind == kind_of("SEGMENT"))
      read_one = layout.empty() ? &LsDynaSets::read_segment : nullptr;
  }

  void LsDynaSets::read_card()
  {
    const std::size_t card = n_cards++ + !has_title;
    if (card == 0)
      title = trim(cards.lines.text());
    else if (card == 1)
      begin_set();
    else if (read_one != nullptr)
      (this->*read_one)();
  }

  void LsDynaSets::begin_set()
  {
    const std::string_view first = trim(cards.field(0, 0, cards.widths.integer));
    Id                     id    = 0;
    if (kind == nullptr && std::from_chars(first.data(), first.data() + first.size(), id).ec != std::errc())
      return; // a set by a name: of what is no mesh
    group = groups(kind_name, cards.integer(0));
    groups.give_title(group, title);
    if (read_one == nullptr)
      return refuse_when_asked(group, cards.keyword_line, "this kind of set is not offered");
    Set &set = sets[group];
    if (set.kind != nullptr && !set.collects && !collects)
      refuse_when_asked(group, cards.keyword_line,
                        "it stands in line " + std::to_string(set.line) + " already, and no _COLLECT joins the two");
    set.kind     = kind;
    set.number   = cards.integer(0);
    set.line     = cards.keyword_line;
    set.collects = collects;
  }

  void LsDynaSets::refuse_when_asked(const std::size_t group, const std::size_t line, const std::string &what) const
  {
    mesh.groups[group].not_read =
      "Line " + std::to_string(line) + ", *" + cards.name + ": " + what + ".\nWrite its members as *SET_..._LIST.";
  }

  std::vector<LsDynaSets::Id> LsDynaSets::fields(const std::size_t first, const std::size_t last) const
  {
    std::vector<Id> ids;
    for (std::size_t k = first; k <= last; ++k)
      if (const Id id = cards.integer(k); id != 0)
        ids.push_back(id);
    return ids;
  }

  void LsDynaSets::add(const Source source, const std::vector<Id> &ids, const Kind *const of, const bool removes)
  {
    auto &steps = sets[group].steps;
    if (steps.empty() || steps.back().source != source || steps.back().kind != of || steps.back().removes != removes)
      steps.push_back({source, of, removes, {}});
    steps.back().ids.insert(steps.back().ids.end(), ids.begin(), ids.end());
  }

  void LsDynaSets::read_list()
  {
    add(Source::members, fields(0, 7));
  }

  void LsDynaSets::read_column() ///< then attributes
  {
    add(Source::members, fields(0, 0));
  }

  void LsDynaSets::read_ranges()
  {
    for (std::size_t k = 0; k < 8; k += 2)
      add_range(cards.integer(k), cards.integer(k + 1), 1);
  }

  void LsDynaSets::read_steps()
  {
    add_range(cards.integer(0), cards.integer(1), std::max<Id>(cards.integer(2), 1));
  }

  void LsDynaSets::add_range(const Id first, const Id last, const Id step)
  {
    if (first < 1 || last < first)
      return; // fields of the card that are not filled
    const Id n = (last - first) / step + 1;
    cards.lines.add_listed(static_cast<std::size_t>(n));
    std::vector<Id> ids(static_cast<std::size_t>(n));
    for (Id k = 0; k < n; ++k)
      ids[static_cast<std::size_t>(k)] = first + k * step;
    add(Source::members, ids);
  }

  void LsDynaSets::read_segment()
  {
    add(Source::members, {cards.integer(0), cards.integer(1), cards.integer(2), cards.integer(3)});
  }

  void LsDynaSets::read_sum()
  {
    add(Source::sets, fields(0, 7), kind);
  }

  void LsDynaSets::read_common()
  {
    add(Source::common_sets, fields(0, 7), kind);
  }

  /// An option and up to seven ids. What begins with D takes away what came before.
  void LsDynaSets::read_general()
  {
    std::string       option     = cards.word(0);
    const bool        is_segment = kind == kind_of("SEGMENT");
    const std::string own        = is_segment                                           ? "SEG"
                                   : kind == kind_of("NODE") || kind == kind_of("PART") ? kind->word
                                                                                        : "ELEM";
    const bool        removes    = option.size() > 1 && option[0] == 'D';
    if (removes)
      option.erase(0, 1);
    const Kind *const of = option == "SET" ? kind : option.starts_with("SET_") ? kind_of(option.substr(4)) : nullptr;
    if (option == own && is_segment)
      add(Source::members, {cards.integer(1), cards.integer(2), cards.integer(3), cards.integer(4)}, nullptr, removes);
    else if (option == own)
      add(Source::members, fields(1, 7), nullptr, removes);
    else if (option == "ALL" && !is_segment)
      add(Source::all, {}, nullptr, removes);
    else if (option == "PART" && !is_segment)
      add(Source::parts, fields(1, 7), nullptr, removes);
    else if (of != nullptr && (of == kind || kind == kind_of("NODE") || of == kind_of("PART")) &&
             !(is_segment && of != kind))
      add(Source::sets, fields(1, 7), of, removes);
    else if (!option.empty())
      refuse_when_asked(group, cards.lines.line_number(), "its option " + cards.word(0) + " is not offered");
  }
} // namespace birdstrike
