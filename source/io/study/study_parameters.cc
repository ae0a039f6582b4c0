#include <birdstrike/io/study_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace birdstrike
{
  namespace
  {
    std::string name_of(const std::size_t k)
    {
      return "Vary " + std::to_string(k + 1);
    }
  } // namespace

  void StudyParameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Study");
    prm.add_parameter(name_of(0), vary[0],
                      "Values of an entry over which 'birdstrike study' runs this case: Section/Entry = v1, v2. Ranges "
                      "are a:b:n (n numbers from a to b). Values with commas are separated by bars: v1 | v2. [-]",
                      Anything());
    for (std::size_t k = 1; k < vary.size(); ++k)
      prm.add_parameter(name_of(k), vary[k], "Values of a further entry, combined with all values of the others. [-]",
                        Anything());
    prm.add_parameter(
      "Pairs", are_pairs,
      "Pairing of the values of all entries: first with first, second with second. false: all combinations. [-]",
      Bool());
    prm.leave_subsection();
  }

  std::vector<std::string> StudyParameters::given() const
  {
    std::vector<std::string> texts;
    for (const std::string &text : vary)
      if (!text.empty())
        texts.push_back(text);
    return texts;
  }

  std::vector<std::string> study_entries()
  {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::size(StudyParameters().vary); ++k)
      names.push_back("Study/" + name_of(k));
    names.emplace_back("Study/Pairs");
    return names;
  }
} // namespace birdstrike
