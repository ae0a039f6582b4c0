#include "mesh/files/ls_dyna/parts.h"

#include <algorithm>

namespace birdstrike
{
  /// *PART with options that add cards of a number that is known, and *PART_COMPOSITE, whose plies end with the next
  /// keyword.
  bool LsDynaParts::begin()
  {
    n_cards = 0;
    is_move = cards.name == "PART_MOVE";
    has_one = cards.has_word("COMPOSITE");
    return is_move || has_one || std::all_of(cards.words.begin() + 1, cards.words.end(), [](const std::string &word) {
             static constexpr const char *known[] = {"INERTIA",    "REPOSITION", "CONTACT", "PRINT",
                                                     "ATTACHMENT", "NODES",      "FIELD",   "AVERAGED"};
             return std::find(std::begin(known), std::end(known), word) != std::end(known);
           });
  }

  std::size_t LsDynaParts::n_cards_of_part() const
  {
    std::size_t n = 2 + n_of_inertia;
    for (const char *option : {"REPOSITION", "CONTACT", "PRINT", "ATTACHMENT", "FIELD"})
      n += cards.has_word(option);
    return n;
  }

  void LsDynaParts::read_card()
  {
    if (is_move)
      {
        const std::size_t first  = 2 * cards.widths.id + 3 * cards.widths.real;
        const bool        is_set = cards.lines.integer(cards.field(5, first, cards.widths.id)) == 1;
        const auto        id     = cards.id(0);
        mesh.groups[groups(is_set ? "part_set" : "part", id)].not_offered = mesh.not_offered(
          id, cards.lines.line_number(),
          is_set ? "*PART_MOVE moves part set #, of the blade" : "*PART_MOVE moves part #, of the blade",
          "Write the nodes where they stand after it, and remove the keyword.");
        return;
      }
    if (n_cards == 0)
      title = trim(cards.lines.text());
    else if (n_cards == 1)
      {
        groups.give_title(groups("part", cards.integer(0)), title);
        n_of_inertia = cards.has_word("INERTIA") ? 3 : 0;
      }
    else if (n_cards == 2 && n_of_inertia > 0 && cards.integer(4) == 1)
      n_of_inertia = 4; // axes of its own
    ++n_cards;
    if (!has_one && n_cards > 1 && n_cards == n_cards_of_part())
      n_cards = 0;
  }
} // namespace birdstrike
