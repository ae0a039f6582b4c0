#include <birdstrike/report/removed_particles.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    const Field &field_of(const FieldSnapshot &snapshot, const std::string &name)
    {
      const auto found = std::ranges::find(snapshot.fields, name, &Field::name);
      if (found == snapshot.fields.end())
        throw std::logic_error("Particles have no field '" + name + "'.");
      return *found;
    }
  } // namespace

  void RemovedParticles::keep(const FieldSnapshot &before, const FieldSnapshot &after, const double time)
  {
    const std::vector<double> &ids = field_of(before, "id").values, &velocity = field_of(before, "velocity").values;
    std::set<double>           left;
    if (!after.points.empty())
      left.insert(field_of(after, "id").values.begin(), field_of(after, "id").values.end());
    for (std::size_t p = 0; p < ids.size(); ++p)
      if (!left.contains(ids[p]))
        {
          Particle one{time, {}, {}, {}};
          std::copy_n(before.points.begin() + static_cast<std::ptrdiff_t>(3 * p), 3, one.position.begin());
          std::copy_n(velocity.begin() + static_cast<std::ptrdiff_t>(3 * p), 3, one.velocity.begin());
          for (const Field &field : before.fields)
            for (std::size_t c = 0; c < field.n_components; ++c)
              one.values.push_back(field.values[field.n_components * p + c]);
          all.push_back(std::move(one));
        }
  }

  void RemovedParticles::add_to(FieldSnapshot &particles, const double time) const
  {
    Field removed{"removed", "", false, 1, std::vector<double>(particles.points.size() / 3, 0.), true};
    for (const Particle &one : all)
      {
        particles.cells.push_back(static_cast<std::uint32_t>(particles.points.size() / 3));
        for (std::size_t d = 0; d < 3; ++d)
          particles.points.push_back(one.position[d] + (time - one.time) * one.velocity[d]);
        auto value = one.values.begin();
        for (Field &field : particles.fields)
          for (std::size_t c = 0; c < field.n_components; ++c)
            field.values.push_back(*value++);
        removed.values.push_back(1.);
      }
    particles.fields.push_back(std::move(removed));
  }

  void RemovedParticles::archive(Archive &archive)
  {
    archive.records("removed particles", all, [](Archive::Row &row, Particle &one) {
      row("time", one.time);
      row("position", one.position);
      row("velocity", one.velocity);
      row.list("fields", one.values);
    });
  }
} // namespace birdstrike
