#include <birdstrike/bird/bird.h>

/// What the bird's next step depends on. What a step sets before it uses it is not among it (rates that predicted,
/// half_step), nor what follows from the parameters (closing energy).
namespace birdstrike
{
  void CellGrid::archive(Archive &archive, Particles &particles, ThreadPool &pool)
  {
    const auto group = archive.group("cells");
    archive("numbers", n);
    archive("periodic", periodic);
    archive("origin", origin);
    archive("inverse edges", inverse_edge);
    archive("smallest edge", smallest_edge);
    cell_of.resize(particles.size());
    for (const std::uint32_t cell : occupied_cells)
      if (!archive.is_reading())
        std::fill(cell_of.begin() + start[cell], cell_of.begin() + start[cell + 1], cell);
    archive.rows("particles", particles.size(),
                 [&](Archive::Row &row, const std::size_t p) { row("cell", cell_of[p]); });
    if (archive.is_reading())
      sort(particles, pool);
  }

  void NeighborList::archive(Archive &archive, Particles &particles, ThreadPool &pool)
  {
    const auto        group = archive.group("neighbor list");
    const std::size_t n     = particles.size();
    archive("builds", builds);
    if (n == 0)
      return;
    grid.archive(archive, particles, pool);
    archive("safe range", safe_range);
    archive("origin", origin);
    std::vector<unsigned char> has_image(n);
    for (std::size_t p = 0; p < n && is_mirrored && !archive.is_reading(); ++p)
      has_image[p] = mirror_images.count_before(p + 1) > mirror_images.count_before(p);
    for (auto &component : positions)
      component.resize(std::max(n, component.size()));
    archive.rows("particles", n, [&](Archive::Row &row, const std::size_t p) {
      row("position", positions[0][p], positions[1][p], positions[2][p]);
      row("has image", has_image[p]);
    });
    if (!archive.is_reading())
      return;
    if (is_mirrored)
      mirror_images.update(n, [&](const std::size_t p) { return has_image[p] != 0; });
    reflect_positions(n);
    make_lists(n, pool);
  }

  void Bird::archive(Archive &archive)
  {
    const auto                 group = archive.group("bird");
    Particles                 &all   = particles;
    std::vector<std::uint64_t> ids(all.id.begin(), all.id.end());
    archive.population("particles", ids);
    if (archive.is_reading())
      {
        all.resize(ids.size());
        std::copy(ids.begin(), ids.end(), all.id.begin());
      }
    archive.rows("particles", ids.size(), [&](Archive::Row &row, const std::size_t p) {
      const auto vector = [&](const char *name, auto &column) { row(name, column[0][p], column[1][p], column[2][p]); };
      const auto tensor = [&](const char *name, auto &column) {
        row(name, column[0][p], column[1][p], column[2][p], column[3][p], column[4][p], column[5][p]);
      };
      vector("position", all.x);
      vector("velocity", all.v);
      row("mu", all.mu[p]);
      row("internal energy", all.internal_energy[p]);
      row("dissipated energy", all.dissipated[p]);
      vector("force", all.force);
      row("compression rate", all.compression_rate[p]);
      row("power", all.power[p]);
      row("dissipation", all.dissipation[p]);
      row("signal speed", all.signal_speed[p]);
      row("largest mu", all.largest_mu[p]);
      tensor("correction", all.correction);
      if (all.has_velocity_gradient)
        tensor("velocity gradient", all.velocity_gradient);
      if (all.has_strength)
        {
          tensor("stress", all.stress);
          tensor("shear correction", all.shear_correction);
          vector("spin", all.spin);
          tensor("earlier velocity gradient", all.earlier_velocity_gradient);
          vector("earlier spin", all.earlier_spin);
        }
      row("volume", all.volume[p]);
      row("density", all.density[p]);
      row("sound speed", all.sound_speed[p]);
      vector("contact force", all.contact_force);
    });
    archive("staggered half steps", staggered_half, staggered_contact);
    archive("staggering", staggering);
    archive("second evaluations", n_second);
    archive("has contact force", has_contact_force);
    archive("revision", revision);
    archive("contact work", contact_work);
    archive("contact impulse", contact_impulse);
    {
      RetiredShare &gone    = retired_share;
      const auto    retired = archive.group("retired");
      archive("particles", gone.particles);
      archive("energy", gone.energy, gone.made);
      archive("momentum", gone.momentum, gone.moment);
      archive("force", gone.force, gone.torque);
    }
    rates->archive(archive);
    list.archive(archive, particles, pool);
  }
} // namespace birdstrike
