#include <birdstrike/contact/contact.h>
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>

/// What contact's next call depends on: memories of points, the surface as it was at the last search, and the candidate
/// lists, for a new search would find others and let pairs sleep for another time.
namespace birdstrike
{
  void PointMemory::archive(Archive &archive)
  {
    const auto group = archive.group("memory");
    archive("revision", revision);
    archive("is empty", is_empty);
    archive("largest size", largest_size);
    archive.records("points", records, [](Archive::Row &row, PointRecord &point) {
      row("size", point.size);
      row("density", point.density);
      row("sound speed", point.sound_speed);
      row("modulus", point.modulus);
      row("last call", point.last_call);
      row("last touch", point.last_touch);
      row("index", point.index);
      PointRecord::Side &a = point.sides[0], &b = point.sides[1];
      row("piece", a.piece, b.piece);
      row("nodes", a.nodes, b.nodes);
      row("sign", a.sign, b.sign);
      row("is touching", a.is_touching, b.is_touching);
      row("is through", a.is_through, b.is_through);
      row("is on edge face", a.is_on_edge_face, b.is_on_edge_face);
      row("was beyond", a.was_beyond, b.was_beyond);
      row("reference", a.reference, b.reference);
      row("overlap", a.overlap, b.overlap);
      row("depth", a.depth, b.depth);
      row("outward", a.outward, b.outward);
    });
  }

  void Dissipation::archive(Archive &archive)
  {
    const auto group = archive.group("dissipation");
    archive("booked", booked);
    archive("under way", under_way);
    archive("most", most, largest_fall);
    archive("reported", reported);
    archive("lost by springs", lost);
    archive.records("touches", past, [](Archive::Row &row, Past &touch) {
      row("point", touch.id);
      row("nodes", touch.nodes);
      row("weights", touch.weights);
      row("force", touch.force);
      row("taken", touch.taken);
      row("has couple", touch.has_couple);
    });
    archive.records("couples", past_couples, [](Archive::Row &row, PastCouple &couple) {
      row("turn", couple.turn);
      row("tilt", couple.tilt);
      row("turn weights", couple.turn_weights);
    });
    const auto n_couples = std::count_if(past.begin(), past.end(), [](const Past &touch) { return touch.has_couple; });
    if (static_cast<std::size_t>(n_couples) != past_couples.size())
      throw InputError("The archive has " + std::to_string(past_couples.size()) + " couples of contact, where " +
                       std::to_string(n_couples) + " belong.");
  }

  void SharpEdges::archive(Archive &archive)
  {
    const auto group = archive.group("sharp edges");
    archive("revision", revision);
    archive("reach", known_reach);
    archive.records("edges", edges, [](Archive::Row &row, Edge &edge) {
      row("nodes", edge.nodes);
      row("facets", edge.facets);
    });
    archive.list("first of facet", first);
    archive.list("near facet", near);
  }

  void SurfaceTopology::archive(Archive &archive)
  {
    const auto group = archive.group("surface");
    archive("revision", revision);
    archive("largest half thickness", largest_half_thickness);
    archive.list("piece of facet", pieces);
    archive.list("piece of node", piece_of_node);
    archive.list("is on rim", rim_node);
    archive.list("half thickness of node", nodal_half_thickness);
    edges.archive(archive);
  }

  void CandidateSearch::archive(Archive &archive, const PointsView &points, const FacetsView &facets)
  {
    const auto group = archive.group("search");
    archive("searches", n_calls.searches, n_calls.reused, n_calls.apart);
    bool has_lists = is_of(points, facets);
    archive("has lists", has_lists);
    if (archive.is_reading())
      {
        is_known = false;
        set_blocks(points, facets);
        is_known = has_lists;
      }
    if (!has_lists)
      return;
    archive("path", path);
    archive("is tracking", is_tracking);
    if (!is_tracking) // lists of blocks are of some earlier search
      return;
    archive.entities("blocks", all_blocks.size(), [&](Archive::Row &row, const std::size_t b) {
      CandidateBlock &block = all_blocks[b];
      if (archive.is_reading())
        block.clear();
      row("path", block.path);
      row("speed", block.speed);
      row("is tracked", block.is_tracked);
      row("is new", block.is_new);
      row.list("points", block.points);
      row.list("has passed", block.has_passed);
      row.list("pair near", block.pair_near);
      std::vector<std::uint32_t> pair_facets;
      for (const std::uint32_t facet : block.pair_facet)
        pair_facets.push_back(block.facets.keys()[facet]);
      row.list("pair facet", pair_facets);
      std::vector<double> bounds; // without what fills up the last register
      if (!archive.is_reading())
        bounds.assign(block.pair_bound.begin(),
                      block.pair_bound.begin() + static_cast<std::ptrdiff_t>(block.n_pairs()));
      row.list("pair bound", bounds);
      const auto                &keys = block.facets.keys();
      std::vector<std::uint32_t> beside(keys.begin() + static_cast<std::ptrdiff_t>(block.n_paired_facets), keys.end());
      row.list("facets beside", beside);
      if (!archive.is_reading())
        return;
      block.pair_facet = pair_facets;
      block.pair_bound.assign(bounds.begin(), bounds.end());
      if (block.is_tracked)
        block.number_surface(facets, beside);
    });
    if (!archive.is_reading())
      return;
    std::copy(facets.position, facets.position + old_nodes.size(), old_nodes.begin());
    for (unsigned int d = 0; d < 3; ++d)
      std::copy(points.position[d], points.position[d] + points.n, old_points[d].begin());
    count_near();
  }

  void Contact::archive_report(Archive &archive)
  {
    const auto group = archive.group("report");
    archive("force", last.force);
    archive("energies", last.stored_energy, last.dissipation_power, last.dissipated_energy, last.released_energy,
            last.staggering, last.dissipation_fall);
    archive("largest frequency", last.largest_frequency);
    archive("touching", last.n_touching);
    archive("penetration", last.penetration, last.max_penetration, last.max_penetration_over_spacing);
    archive.list("patch pressures", last.patch_pressures);
    archive("peak force", last.peak_force, last.peak_force_time);
    archive("work", last.calls, last.skipped, last.searches, last.reused, last.pairs_listed, last.pairs_tested,
            last.points_near, last.points_active, last.touches);
  }

  void Contact::archive(Archive &archive, const PointsView &points, const FacetsView &facets)
  {
    const auto group = archive.group("contact");
    topology.archive(archive);
    memory.archive(archive);
    search.archive(archive, points, facets);
    archive.list("areal flexibility of node", areal_flexibility);
    dissipation.archive(archive);
    archive("clock", clock);
    archive("is first", is_first);
    bool is_particle = limit.where.kind != nullptr && limit.where.kind == std::string("particle");
    archive("step limit", limit.value);
    archive("limited by", is_particle, limit.where.id);
    archive("limited at", limit.where.position);
    archive_report(archive);
    if (!archive.is_reading())
      return;
    if (limit.value < INFINITY)
      {
        limit.reason     = step_limit_reason;
        limit.where.kind = is_particle ? "particle" : "node";
      }
    node_sums.set_nodes(search.blocks(), facets.n_nodes);
    size_touches();
  }
} // namespace birdstrike
