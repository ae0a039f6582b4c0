#include "mesh/files/ls_dyna/elements.h"
#include "mesh/files/ls_dyna/keywords.h"
#include "mesh/files/ls_dyna/parts.h"
#include "mesh/files/ls_dyna/sets.h"
#include "mesh/files/readers.h"

namespace birdstrike
{
  namespace
  {
    class LsDynaFile
    {
    public:
      explicit LsDynaFile(const std::string &path) : cards(path)
      {
      }

      ImportedMesh read()
      {
        while (cards.next())
          if (cards.is_keyword())
            begin();
          else if (read_card != nullptr)
            (this->*read_card)();
        sets.resolve();
        mesh.notes.always = noted.sentences();
        return std::move(mesh);
      }

    private:
      LsDynaCards    cards;
      ImportedMesh   mesh;
      LsDynaGroups   groups{mesh, cards};
      LsDynaElements elements{mesh, cards, groups};
      LsDynaSets     sets{mesh, cards, groups};
      LsDynaParts    parts{mesh, cards, groups};
      NotedKeywords  noted;

      void (LsDynaFile::*read_card)() = nullptr;

      void begin()
      {
        read_card              = nullptr;
        const std::string kind = cards.words[0];
        const KeywordUse  use  = ls_dyna_keyword(cards.name);
        if (cards.name == "NODE")
          read_card = &LsDynaFile::read_node;
        else if (kind == "PART" && parts.begin())
          read_card = &LsDynaFile::read_part;
        else if (kind == "SET")
          {
            sets.begin();
            read_card = &LsDynaFile::read_set;
          }
        else if (use == KeywordUse::noted)
          noted.add(cards.name, cards.keyword_line);
        else if (use == KeywordUse::refused && kind == "ELEMENT")
          {
            elements.begin();
            read_card = &LsDynaFile::read_element;
          }
        else if (use == KeywordUse::refused)
          refuse_keyword();
      }

      [[noreturn]] void refuse_keyword() const
      {
        const std::string what = "the keyword *" + cards.name + " is not offered";
        if (cards.words[0] == "INCLUDE")
          cards.lines.refuse(what, "Put the text of the included file here, moved as the keyword says: the whole mesh, "
                                   "where it stands, is wanted as *NODE and *ELEMENT_... in one file.");
        cards.lines.refuse(what, "It may move, join, thicken or make nodes or elements. Write the whole mesh, where it "
                                 "stands, as *NODE and *ELEMENT_... into one file, and remove the keyword.");
      }

      void read_node()
      {
        const auto x = [this](const std::size_t k) {
          return cards.real_at(k + 1, cards.widths.id + k * cards.widths.real, cards.widths.real);
        };
        if (const ImportedMesh::Id number = cards.id(0); number > 0)
          mesh.nodes.emplace_back(number, Point3(x(0), x(1), x(2)));
      }

      void read_element()
      {
        elements.read_card();
      }

      void read_set()
      {
        sets.read_card();
      }

      void read_part()
      {
        parts.read_card();
      }
    };
  } // namespace

  ImportedMesh read_ls_dyna(const std::string &path)
  {
    return LsDynaFile(path).read();
  }
} // namespace birdstrike
