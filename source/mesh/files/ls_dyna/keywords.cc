#include "mesh/files/ls_dyna/keywords.h"

namespace birdstrike
{
  namespace
  {
    constexpr KeywordUse pass = KeywordUse::passed_over, note = KeywordUse::noted, no = KeywordUse::refused;

    // By their first words; a longer beginning goes before a shorter one.
    const KeywordFamilies families(
      '_',
      {// the deck itself
       {pass, "KEYWORD, TITLE, COMMENT, PARAMETER, MODULE, INCLUDE_PATH, UNIT, HASH"},
       // how the program goes about it, and what it writes
       {pass, "CONTROL, CONTROL_REFINE_ALE, CONTROL_REFINE_ALE2D, CONTROLLER, DATABASE, TERMINATION, SENSOR, "
              "INTERFACE, COSIM, LSO"},
       {no, "CONTROL_FORMING, CONTROL_REFINE, CONTROL_COARSEN, CONTROL_SPOTWELD_BEAM"},
       // metals, liquids, sections
       {pass, "MAT, EOS, HOURGLASS, SECTION, INTEGRATION, DAMPING, FATIGUE, DEFORMABLE_TO_RIGID, RIGID_DEFORMABLE, "
              "PERTURBATION_MAT, STOCHASTIC"},
       // curves, boxes, systems
       {pass, "DEFINE"},
       {note, "DEFINE_STAGED_CONSTRUCTION_PART, DEFINE_ELEMENT_DEATH, DEFINE_ELEMENT_EROSION"},
       {no, "DEFINE_FORMING"},
       // what acts on the blade
       {pass, "LOAD, BOUNDARY, RIGIDWALL, RAIL, AIRBAG, PARTICLE, CONTACT, INITIAL, CONSTRAINED_GLOBAL, "
              "CONSTRAINED_LOCAL, CONSTRAINED_LAGRANGE_IN_SOLID, CONSTRAINED_EULER_IN_EULER, "
              "CONSTRAINED_IMMERSED_IN_SPG, CONSTRAINED_JOINT_STIFFNESS, CONSTRAINED_RIGID_BODY_STOPPERS, "
              "NODE_SCALAR, NODE_RIGID_SURFACE"},
       {note, "INITIAL_STRESS, INITIAL_STRAIN, INITIAL_FOAM_REFERENCE_GEOMETRY, INITIAL_AXIAL_FORCE, "
              "INITIAL_TIED_CONTACT_DATA, CONSTRAINED"},
       {no, "INITIAL_LAG_MAPPING, CONSTRAINED_ADAPTIVITY, CONSTRAINED_UNDO"},
       // parts: heads are read
       {pass, "PART_ADAPTIVE_FAILURE, PART_ANNEAL, PART_SENSOR, PART_MODES"},
       // sets of what is no part of a mesh
       {pass, "SET"},
       // nothing that could be an element of the blade
       {pass, "ELEMENT_PLOTEL, ELEMENT_SEATBELT_ACCELEROMETER, ELEMENT_SEATBELT_PRETENSIONER, "
              "ELEMENT_SEATBELT_RETRACTOR, ELEMENT_SEATBELT_SENSOR, ELEMENT_SEATBELT_SLIPRING"},
       // other fields: fluids, heat, electricity, frequencies
       {pass, "ALE, BATTERY, CESE, CHEMISTRY, DUALCESE, EF, EFV, EM, FREQUENCY_DOMAIN, ICFD, ISPG, MESH, RVE, "
              "USER"}});

    bool ties(const std::string &contact)
    {
      for (const char *word : {"TIED", "TIEBREAK", "SPOTWELD", "GLUED"})
        if (contact.find(word) != std::string::npos)
          return true;
      return false;
    }
  } // namespace

  KeywordUse ls_dyna_keyword(const std::string &name)
  {
    const KeywordUse use = families.use_of(name);
    return use == pass && name.starts_with("CONTACT") && ties(name) ? note : use;
  }
} // namespace birdstrike
