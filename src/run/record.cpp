#include "run/record.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <ctime>

#include "common/error.hpp"
#include "common/json.hpp"
#include "common/text_file.hpp"

namespace valsalva::run {

namespace {

std::string host_name()
{
  char name[256] = "unknown";
  gethostname(name, sizeof name - 1);
  return name;
}

std::string utc_now()
{
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

constexpr std::size_t kRoomToEnd = 512;  // bytes more than the record of a run under way has

std::string text_of(const RunRecord& r, int ranks)
{
  return common::json_text({{"case", r.case_path},
                            {"outcome", r.outcome},
                            {"written", utc_now()},
                            {"host", host_name()},
                            {"ranks", ranks},
                            {"t_s", common::nine_digits(r.t_s)},
                            {"steps", r.steps},
                            {"cells", r.cells},
                            {"nodes", r.nodes},
                            {"wall_s", std::round(1e3 * r.wall_s) / 1e3},
                            {"peak_memory_mb", std::round(10 * r.peak_memory_mb) / 10}});
}

}  // namespace

double peak_memory_mb(const Communicator& comm)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return comm.sum(1024 * static_cast<double>(usage.ru_maxrss) / 1e6);
}

void write_run_record(const std::string& folder, RunRecord& record, const Communicator& comm)
{
  record.peak_memory_mb = peak_memory_mb(comm);
  common::on_rank_0(comm, [&] {
    const std::string path = folder + "/run.json", text = text_of(record, comm.size());
    common::write_text_file(path, text);
    if (record.outcome == "running") try {
        common::reserve_text_file(path, text.size() + kRoomToEnd);
      } catch (const IoError&) {
        std::remove(path.c_str());
        throw;
      }
  });
}

void write_failed_run_record(const std::string& folder, RunRecord record, const Communicator& comm)
{
  record.outcome = "failed";
  try {
    common::write_text_file(folder + "/run.json", text_of(record, comm.size()));
  } catch (const IoError&) {
  }
}

}  // namespace valsalva::run
