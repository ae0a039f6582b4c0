#include <birdstrike/bird/retirement.h>

#include <algorithm>
#include <vector>

namespace birdstrike
{
  namespace
  {
    /// Volume strain beyond which liquid at zero pressure has come apart for good, unless something strikes it.
    constexpr double cavitated = -0.01;

    Point3 at(const Particles::Column3 &column, const std::size_t p)
    {
      return {column[0][p], column[1][p], column[2][p]};
    }
  } // namespace

  RetiredShare retire_particles(Particles &particles, const Box &box,
                                const std::function<double(std::size_t p)> &specific_energy, const bool has_cutoff)
  {
    RetiredShare             share;
    std::vector<std::size_t> kept;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const bool   is_loose = particles.signal_speed[p] == 0. || (has_cutoff && particles.largest_mu[p] < cavitated);
        const Point3 v        = at(particles.v, p);
        if (!is_loose || !box.passage(at(particles.x, p), v).is_empty())
          {
            kept.push_back(p);
            continue;
          }
        ++share.particles;
        const Point3 x = at(particles.x, p), f = at(particles.force, p);
        share.momentum += particles.mass * v;
        share.moment += particles.mass * x.cross(v);
        share.force += f;
        share.torque += x.cross(f);
        const double heat = specific_energy ? particles.mass * specific_energy(p) + particles.dissipated[p]
                                            : particles.internal_energy[p];
        share.energy += 0.5 * particles.mass * v.squaredNorm() + heat;
        share.made += heat - particles.internal_energy[p];
      }
    if (share.particles == 0)
      return share;
    for (std::size_t k = 0; k < kept.size(); ++k)
      particles.id[k] = particles.id[kept[k]];
    particles.for_each_column([&](auto &column) {
      for (std::size_t k = 0; k < kept.size(); ++k)
        column[k] = column[kept[k]];
    });
    particles.resize(kept.size());
    return share;
  }
} // namespace birdstrike
