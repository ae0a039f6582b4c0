#include <birdstrike/report/history.h>
#include <birdstrike/report/observed.h>

/// What has been observed and written so far.
namespace birdstrike
{
  namespace
  {
    void archive_root(Archive &archive, RootSectionReport &root)
    {
      const auto group = archive.group("root at peak stress");
      archive("normal force", root.normal_force);
      archive("bending moment", root.bending_moment);
      archive("transverse force", root.transverse_force);
      archive.list("chord position", root.chord_position);
      archive.list("stress of struck face", root.stress_struck);
      archive.list("stress of rear face", root.stress_rear);
    }
  } // namespace

  void Observed::archive(Archive &archive)
  {
    const auto group = archive.group("observed");
    tip_peak.archive(archive, "tip peak");
    first_tip_peak.archive(archive, "first tip peak");
    root_stress.archive(archive, "root stress");
    root_moment.archive(archive, "root moment");
    root_force.archive(archive, "root force");
    hourglass_share.archive(archive, "hourglass share");
    contact.archive(archive);
    removed_particles.archive(archive);
    archive_root(archive, root_at_peak_stress);
    archive.list("mid-chord deflection at tip peak", mid_chord_at_peak);
    for (BladePeaks &of : row)
      {
        const auto of_blade = archive.group("blade " + std::to_string(of.place));
        of.tip.archive(archive, "tip peak");
        of.root_moment.archive(archive, "root moment");
        of.root_stress.archive(archive, "root stress");
      }
  }

  void History::archive(Archive &archive)
  {
    const auto group = archive.group(table.filename().string());
    archive("rows", rows);
    for (Curve &column : columns)
      archive.list(column.what.name.c_str(), column.rows);
    const auto of_profiles = archive.group("profiles");
    for (Profile &profile : profiles)
      archive.list(profile.what.name.c_str(), profile.rows);
  }
} // namespace birdstrike
