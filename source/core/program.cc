#include <birdstrike/core/program.h>

#include <deal.II/base/config.h>

#include <Eigen/Core>
#include <fmt/format.h>

#include <H5public.h>
#include <link.h>

#include <cstdlib>
#include <cstring>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t n_bytes_shown = 8;

    std::string to_hex(const unsigned char *bytes, const std::size_t n)
    {
      static constexpr char digits[] = "0123456789abcdef";
      std::string           text;
      for (std::size_t i = 0; i < n; ++i)
        text += {digits[bytes[i] / 16], digits[bytes[i] % 16]};
      return text;
    }

    /// Searches one segment of ELF notes: header, name and description, the latter two padded to four bytes.
    std::string find_build_id(const char *note, const std::size_t size)
    {
      const auto padded = [](const std::size_t n) { return (n + 3) / 4 * 4; };
      for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;)
        {
          ElfW(Nhdr) header;
          std::memcpy(&header, note + at, sizeof(header));
          const char       *name = note + at + sizeof(header);
          const std::size_t next = at + sizeof(header) + padded(header.n_namesz) + padded(header.n_descsz);
          if (next > size)
            break;
          if (header.n_type == NT_GNU_BUILD_ID && header.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0 &&
              header.n_descsz >= n_bytes_shown)
            return to_hex(reinterpret_cast<const unsigned char *>(name + padded(header.n_namesz)), n_bytes_shown);
          at = next;
        }
      return "";
    }

    /// Of the program itself, which the loader lists first.
    int read_program(dl_phdr_info *object, std::size_t, void *build)
    {
      auto &id = *static_cast<std::string *>(build);
      for (int k = 0; k < object->dlpi_phnum && id.empty(); ++k)
        if (const auto &segment = object->dlpi_phdr[k]; segment.p_type == PT_NOTE)
          id = find_build_id(reinterpret_cast<const char *>(object->dlpi_addr + segment.p_vaddr), segment.p_memsz);
      return 1; // the libraries are not asked
    }
  } // namespace

  const ProgramIdentity &program_identity()
  {
    static const ProgramIdentity identity = [] {
      ProgramIdentity made{BIRDSTRIKE_VERSION, ""};
      dl_iterate_phdr(read_program, &made.build);
      return made;
    }();
    return identity;
  }

  std::string describe_program()
  {
    const std::string commit = BIRDSTRIKE_COMMIT;
    return fmt::format("birdstrike {}\n"
                       "commit    {}\n"
                       "build     {}\n"
                       "compiler  {}\n"
                       "flags     {}\n"
                       "deal.II   {}\n"
                       "Trilinos  {}.{}.{}\n"
                       "HDF5      {}.{}.{}\n"
                       "Eigen     {}.{}.{}",
                       BIRDSTRIKE_VERSION, commit.empty() ? "not known" : commit, program_identity().build,
                       BIRDSTRIKE_COMPILER, BIRDSTRIKE_FLAGS, DEAL_II_PACKAGE_VERSION, DEAL_II_TRILINOS_VERSION_MAJOR,
                       DEAL_II_TRILINOS_VERSION_MINOR, DEAL_II_TRILINOS_VERSION_SUBMINOR, H5_VERS_MAJOR, H5_VERS_MINOR,
                       H5_VERS_RELEASE, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  }

  bool is_started_by_launcher()
  {
    for (const char *variable : launcher_variables)
      if (std::getenv(variable))
        return true;
    return false;
  }
} // namespace birdstrike
