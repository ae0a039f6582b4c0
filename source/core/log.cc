#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace birdstrike
{
  namespace
  {
    std::shared_ptr<spdlog::logger> make_logger()
    {
      auto console = std::make_shared<spdlog::sinks::stdout_color_sink_mt>();
      auto made    = std::make_shared<spdlog::logger>("birdstrike", console);
      made->set_pattern("%^%v%$");
      made->set_level(spdlog::level::trace);
      made->flush_on(spdlog::level::info); // a run that is killed has said what it has said
      made->sinks().front()->set_level(spdlog::level::info);
      return made;
    }

    std::shared_ptr<spdlog::logger> &the_logger()
    {
      static std::shared_ptr<spdlog::logger> logger = make_logger();
      return logger;
    }
  } // namespace

  spdlog::logger &log()
  {
    return *the_logger();
  }

  void reset_log()
  {
    the_logger() = make_logger();
  }

  void log_to_file(const std::string &path, const bool is_continued)
  {
    try
      {
        auto file = std::make_shared<spdlog::sinks::basic_file_sink_mt>(path, !is_continued);
        file->set_level(spdlog::level::debug);
        file->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
        auto &sinks = log().sinks();
        sinks.resize(1);
        sinks.push_back(std::move(file));
      }
    catch (const spdlog::spdlog_ex &error)
      {
        throw InputError("Cannot write the log file " + path + ": " + error.what());
      }
  }

  void tell(const std::string &brief, const std::string &whole)
  {
    bool is_console = true;
    for (const auto &sink : log().sinks())
      {
        spdlog::logger one(log().name(), sink); // which tells of a sink that fails, as the log does, and goes on
        one.info("{}", is_console && !sink->should_log(spdlog::level::debug) ? brief : whole);
        one.flush();
        is_console = false;
      }
  }

  void set_console_level(const std::string &level)
  {
    log().sinks().front()->set_level(spdlog::level::from_str(level));
  }
} // namespace birdstrike
