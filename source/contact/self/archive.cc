#include <birdstrike/contact/self_contact.h>

/// What self-contact's next call depends on. Patches are grown where the surface first was and looked at seldom:
/// another grouping or another look would list other pairs.
namespace birdstrike
{
  void SurfacePatches::archive(Archive &archive, const FacetsView &facets)
  {
    const auto group = archive.group("patches");
    archive("edge", edge);
    archive.records("patches", patches, [](Archive::Row &row, Patch &patch) {
      row.list("facets", patch.facets);
      row.list("neighbors", patch.neighbors);
    });
    if (!archive.is_reading())
      return;
    owner_of_facet.assign(facets.n_facets, no_patch);
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      for (const std::uint32_t facet : patches[p].facets)
        owner_of_facet.at(facet) = p;
    normals.resize(facets.n_facets);
    collect_nodes(facets);
  }

  void SelfSearch::archive(Archive &archive, const FacetsView &facets)
  {
    const auto group = archive.group("search");
    archive("is known", is_known);
    archive("is torn", is_torn);
    archive("revision", revision);
    archive("facets", n_facets);
    archive("looks", looks);
    archive("margin", margin, last_motion);
    archive.list("reference positions", reference);
    archive.list("seen positions", seen);
    archive.records("pairs", pairs, [](Archive::Row &row, Candidate &pair) {
      row("point", pair.point);
      row("facet", pair.facet);
      row("own nodes", pair.own);
    });
    if (!is_known)
      return;
    patches.archive(archive, facets);
    if (archive.is_reading())
      list_facets_of_nodes(facets);
  }

  void SelfTouches::archive(Archive &archive)
  {
    archive("call", call);
    archive.records("nodes", records, [](Archive::Row &row, Record &record) {
      SelfSide &a = record.sides[0], &b = record.sides[1];
      row("last call", record.last_call);
      row("facet", a.nodes, b.nodes);
      row("sign", a.sign, b.sign);
      row("is known", a.is_known, b.is_known);
      row("is touching", a.is_touching, b.is_touching);
      row("reference", a.reference, b.reference);
      row("depth", a.depth, b.depth);
      row("stiffness", a.stiffness, b.stiffness);
      row("touch", a.touch, b.touch);
      row("outward", a.outward, b.outward);
    });
  }

  void SelfContact::archive(Archive &archive, const FacetsView &facets)
  {
    const auto group = archive.group("self-contact");
    plane            = facets.plane;
    topology.archive(archive);
    search.archive(archive, facets);
    narrow.archive(archive);
    archive.records("touches", before, [](Archive::Row &row, SelfTouch &touch) {
      row("point", touch.point);
      row("side", touch.side);
      row("nodes", touch.nodes);
      row("weights", touch.weights);
      row("normal", touch.normal);
      row("penetration", touch.penetration);
      row("share", touch.share);
      row("force", touch.force, touch.damping);
      row("stored energy", touch.stored);
    });
    archive("energies", last.stored_energy, last.dissipated_energy);
    archive("largest penetration", last.max_penetration);
    archive("work", last.n_touching, last.calls, last.looks, last.pairs_tested, last.touches);
  }
} // namespace birdstrike
